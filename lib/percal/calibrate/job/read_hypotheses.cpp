// [[hypotheses]], [[cross_validation]] and [[ridge_points]]; and what no single block of a job can tell.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "percal/calibrate/job/read_job.hpp"
#include "percal/calibrate/job_fit.hpp"
#include "percal/text/job_table.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

// "readings" is the older spelling.
std::string spelling_of_hypotheses(const TomlTable& block) {
  if (block.has("readings") && block.has("hypotheses"))
    block.refuse("readings", "this beside hypotheses, which says the same", "hypotheses alone");
  return block.has("readings") ? "readings" : "hypotheses";
}

std::optional<int> find_parameter(const CalibrationJob& job, const std::string& name) {
  for (std::size_t k = 0; k < job.parameters.size(); ++k)
    if (job.parameters[k].free.name == name) return static_cast<int>(k);
  return std::nullopt;
}

std::string parameter_names(const CalibrationJob& job) {
  std::vector<std::string> names;
  for (const auto& parameter : job.parameters) names.push_back(parameter.free.name);
  return listed(names);
}

std::map<int, double> held_from(const TomlTable& block, const CalibrationJob& job) {
  std::map<int, double> held;
  const auto hold = block.optional_table("hold");
  if (!hold) return held;
  for (const std::string& name : hold->keys()) {
    const auto k = find_parameter(job, name);
    if (!k) hold->refuse(name, "a parameter that the job does not have", parameter_names(job));
    const CalibrationParameter& parameter = job.parameters[*k];
    const Range within{
        .low = parameter.free.low,
        .high = parameter.free.high,
        .words = fmt::format("a value from {:.6g} to {:.6g}, the parameter's bounds, in {}", parameter.free.low,
                             parameter.free.high, parameter.free.unit.empty() ? "no unit" : parameter.free.unit),
        .in_general = "a value within the parameter's bounds"};
    held[*k] = hold->quantity(name, dimension_of(parameter.kind), within);
  }
  if (held.size() == job.parameters.size())
    block.refuse("hold", "every parameter held", "one or more left to be fitted");
  return held;
}

Hypothesis hypothesis_from(const TomlTable& block, const CalibrationJob& job) {
  if (block.has("contact_stiffness"))
    block.refuse("contact_stiffness", "a stiffness of springs that contact does not have any more",
                 "a hypothesis that differs in what it holds, in its convention or in its measure");
  const auto measure = static_cast<StrainMeasure>(block.word("measure", {"engineering", "true", "green-lagrange"}, 0));
  std::map<int, double> held = held_from(block, job);
  for (auto& [parameter, value] : held)  // inside, erosion strains are engineering ones
    if (job.parameters[parameter].kind == ParameterKind::erosion_strain) value = stretch_at(value, measure) - 1;
  return {.name = block.text("name"),
          .held = held,
          .convention = static_cast<ModulusConvention>(block.word("convention", {"true", "mu/alpha"}, 0)),
          .measure = measure};
}

// Moduli are positive, so a mu that stands for mu_true 2/alpha needs a positive alpha.
void check_convention(const TomlTable& block, const CalibrationJob& job, const Hypothesis& hypothesis) {
  if (hypothesis.convention != ModulusConvention::mu_over_alpha) return;
  for (const CalibrationMaterial& material : job.materials) {
    const auto* shared = std::get_if<SharedParameter>(&material.alpha);
    const double lowest = shared ? job.parameters[shared->index].free.low : std::get<double>(material.alpha);
    if (lowest < 0)
      block.refuse("convention", "\"mu/alpha\" beside negative exponents of " + material.name,
                   "positive exponents, or convention = \"true\"");
  }
}

PublishedPairs published_from(const TomlTable& block, const CalibrationJob& job) {
  PublishedPairs published{.name = block.text("name"), .modulus = 0, .pairs = {}};
  const std::string name = block.text("parameter");
  const auto k = find_parameter(job, name);
  if (!k || job.parameters[*k].kind != ParameterKind::modulus)
    block.refuse("parameter", in_quotes(name), "a parameter of kind \"modulus\" among " + parameter_names(job));
  published.modulus = *k;
  const CsvTable table = table_of(block);
  const auto mu = column_of(block, "mu", table, dimension::pressure);
  const auto strain = column_of(block, "erosion_strain", table, dimension::none);
  for (std::size_t i = 0; i < mu.size(); ++i) published.pairs.push_back({mu[i], strain[i]});
  return published;
}

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

// What shots have to say about a column, for messages.
std::string values_of(const CalibrationJob& job, const std::string& column) {
  std::set<std::string> values, columns{"set"};
  for (const MeasuredShot& shot : job.shots) {
    for (const auto& [name, cell] : shot.row) columns.insert(name);
    if (column == "set") values.insert(in_quotes(job.sets[shot.set].name));
    if (const auto cell = shot.row.find(column); cell != shot.row.end()) values.insert(in_quotes(cell->second));
  }
  if (values.empty()) return "a column of the shots' tables: " + listed({columns.begin(), columns.end()});
  return column + " with one of " + listed({values.begin(), values.end()});
}

ShotFilter filter_from(const TomlTable& block, const std::string& key, const CalibrationJob& job) {
  ShotFilter filter;
  for (const std::string& condition : block.texts(key)) {
    const auto equals = condition.find('=');
    if (equals == std::string::npos) block.refuse(key, in_quotes(condition), "\"COLUMN=VALUE\" or \"set=NAME\"");
    const std::string column = trimmed(condition.substr(0, equals));
    filter.push_back(column + "=" + trimmed(condition.substr(equals + 1)));
    if (chosen(job, {filter.back()}).empty())
      block.refuse(key, in_quotes(condition) + ", which no shot meets", values_of(job, column));
  }
  if (chosen(job, filter).empty())
    block.refuse(key, "conditions that no shot meets together", "conditions that some shot meets");
  return filter;
}

std::vector<int> hypotheses_from(const TomlTable& block, const CalibrationJob& job) {
  std::vector<int> hypotheses;
  const std::string key = spelling_of_hypotheses(block);
  if (!block.has(key)) return hypotheses;
  for (const std::string& name : block.texts(key)) {
    const auto found =
        std::find_if(job.hypotheses.begin(), job.hypotheses.end(), [&](const auto& r) { return r.name == name; });
    if (found == job.hypotheses.end())
      block.refuse(key, in_quotes(name), "hypotheses of the job: " + names_of(job.hypotheses));
    hypotheses.push_back(static_cast<int>(found - job.hypotheses.begin()));
  }
  return hypotheses;
}

void check_apart(const TomlTable& block, const CalibrationJob& job, const CrossValidation& wanted) {
  const auto fitted = chosen(job, wanted.fit);
  for (const int shot : chosen(job, wanted.predict))
    if (std::find(fitted.begin(), fitted.end(), shot) != fitted.end())
      block.refuse("predict", "the shot " + in_quotes(job.shots[shot].label) + ", which is fitted too",
                   "shots that are not among the fitted");
}

void add_index(std::set<int>& indices, const MaterialNumber& number) {
  if (const auto* shared = std::get_if<SharedParameter>(&number)) indices.insert(shared->index);
}

void add_relaxation(std::set<int>& indices, const CalibrationMaterial& material) {
  for (const auto& [share, time] : material.relaxation) add_index(indices, share), add_index(indices, time);
}

std::set<int> parameters_of(const CalibrationMaterial& material) {
  std::set<int> indices;
  for (const MaterialNumber* number : {&material.mu, &material.alpha, &material.erosion_strain})
    add_index(indices, *number);
  if (material.erosion_length) add_index(indices, *material.erosion_length);
  add_index(indices, material.rate_exponent);
  add_index(indices, material.size_exponent);
  add_index(indices, material.erosion_strain_below);
  add_relaxation(indices, material);
  return indices;
}

// Parameters that a fitted shot or a curve depends on.
std::set<int> parameters_with_data(const CalibrationJob& job) {
  std::set<int> indices;
  for (const MeasuredShot& shot : job.shots)
    for (std::size_t m = 0; m < job.materials.size(); ++m)
      if (shot.used && meets(job, shot, static_cast<int>(m))) indices.merge(parameters_of(job.materials[m]));
  for (const MeasuredCurve& curve : job.curves) {
    add_index(indices, job.materials[curve.material].mu);
    add_index(indices, job.materials[curve.material].alpha);
    add_index(indices, job.materials[curve.material].rate_exponent);
    add_relaxation(indices, job.materials[curve.material]);
  }
  return indices;
}

void check_parameters(const TomlTable& root, const CalibrationJob& job) {
  std::set<int> named;
  for (const CalibrationMaterial& material : job.materials) named.merge(parameters_of(material));
  const std::set<int> with_data = parameters_with_data(job);
  for (std::size_t k = 0; k < job.parameters.size(); ++k) {
    const std::string& name = job.parameters[k].free.name;
    if (!named.contains(static_cast<int>(k)))
      root.table("parameters")
          .refuse(name, "a parameter that no material names",
                  "one that is mu, alpha, erosion_strain, erosion_length, a law's exponent or a term of relaxation of "
                  "some material");
    if (!with_data.contains(static_cast<int>(k)))
      root.table("parameters")
          .refuse(name, "a parameter that no fitted datum depends on",
                  "a fitted shot of its material (for mu, alpha and a rate exponent a curve will do), or a value in "
                  "its place");
  }
}

void check_materials(const TomlTable& root, const CalibrationJob& job) {
  for (std::size_t m = 0; m < job.materials.size(); ++m) {
    const int material = static_cast<int>(m);
    if (std::ranges::none_of(job.shots, [&](const MeasuredShot& shot) { return meets(job, shot, material); }) &&
        std::ranges::find(job.curves, material, &MeasuredCurve::material) == job.curves.end())
      root.table("materials").refuse(job.materials[m].name, "a material without data", "shots or curves of it");
  }
}

void check_targets(const TomlTable& root, const CalibrationJob& job) {
  for (std::size_t t = job.materials.size(); t < job.targets.size(); ++t)
    if (std::ranges::find(job.shots, static_cast<int>(t), &MeasuredShot::target) == job.shots.end())
      root.table("targets").refuse(job.targets[t].name, "a target without shots", "shots with target = its name");
}

void check_groups(const TomlTable& root, const CalibrationJob& job) {
  for (std::size_t g = 0; g < job.groups.size(); ++g) {
    const auto in_this = [g](const auto& data) { return data.group == static_cast<int>(g); };
    if (std::none_of(job.shots.begin(), job.shots.end(), in_this) &&
        std::none_of(job.curves.begin(), job.curves.end(), in_this))
      root.table("scatter").refuse(job.groups[g].name, "a group without data",
                                   "shots or curves with scatter = its name");
  }
}

}  // namespace

void read_hypotheses(const TomlTable& root, CalibrationJob& job) {
  for (const TomlTable& block : root.tables(spelling_of_hypotheses(root))) {
    const Hypothesis hypothesis = hypothesis_from(block, job);
    for (const Hypothesis& other : job.hypotheses)
      if (other.name == hypothesis.name)
        block.refuse("name", in_quotes(hypothesis.name) + " again", "a name of its own");
    check_convention(block, job, hypothesis);
    job.hypotheses.push_back(hypothesis);
  }
  if (job.hypotheses.empty()) job.hypotheses.push_back({.name = "as given", .held = {}});
}

void read_published(const TomlTable& root, CalibrationJob& job) {
  for (const TomlTable& block : root.tables("ridge_points")) job.published.push_back(published_from(block, job));
}

void read_cross_validations(const TomlTable& root, CalibrationJob& job) {
  for (const TomlTable& block : root.tables("cross_validation")) {
    CrossValidation wanted{.name = block.text("name"),
                           .fit = filter_from(block, "fit", job),
                           .predict = filter_from(block, "predict", job),
                           .hypotheses = hypotheses_from(block, job),
                           .goal = optional_share_from(block, "goal", positive("share"))};
    check_apart(block, job, wanted);
    for (const CrossValidation& other : job.cross_validations)
      if (other.name == wanted.name) block.refuse("name", in_quotes(wanted.name) + " again", "a name of its own");
    job.cross_validations.push_back(std::move(wanted));
  }
}

void check_use(const TomlTable& root, const CalibrationJob& job) {
  if (job.shots.empty() && job.curves.empty())
    root.refuse("shots", "neither shots nor curves", "[[shots]] or [[curves]]");
  check_materials(root, job);
  check_targets(root, job);
  check_groups(root, job);
  check_parameters(root, job);
}

}  // namespace percal
