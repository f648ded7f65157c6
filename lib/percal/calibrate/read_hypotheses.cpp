// [[hypotheses]] and [[ridge_points]].
#include <fmt/format.h>

#include <cmath>

#include "percal/calibrate/read_job.hpp"
#include "percal/text/job_table.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

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
    const bool modulus = parameter.kind == ParameterKind::modulus;
    held[*k] = hold->quantity(name, modulus ? dimension::pressure : dimension::none, within);
  }
  if (held.size() == job.parameters.size())
    block.refuse("hold", "every parameter held", "one or more left to be fitted");
  return held;
}

Hypothesis hypothesis_from(const TomlTable& block, const CalibrationJob& job) {
  const auto measure = static_cast<StrainMeasure>(block.word("measure", {"engineering", "true", "green-lagrange"}, 0));
  std::map<int, double> held = held_from(block, job);
  for (auto& [parameter, value] : held)  // inside, erosion strains are engineering ones
    if (job.parameters[parameter].kind == ParameterKind::erosion_strain) value = stretch_at(value, measure) - 1;
  return {.name = block.text("name"),
          .held = held,
          .convention = static_cast<ModulusConvention>(block.word("convention", {"true", "mu/alpha"}, 0)),
          .measure = measure,
          .contact_stiffness = block.number("contact_stiffness", positive("stiffness"), job.solver.contact_stiffness)};
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

}  // namespace

void read_hypotheses(const TomlTable& root, CalibrationJob& job) {
  for (const TomlTable& block : root.tables(root.has("readings") ? "readings" : "hypotheses")) {
    const Hypothesis hypothesis = hypothesis_from(block, job);
    for (const Hypothesis& other : job.hypotheses)
      if (other.name == hypothesis.name)
        block.refuse("name", in_quotes(hypothesis.name) + " again", "a name of its own");
    check_convention(block, job, hypothesis);
    job.hypotheses.push_back(hypothesis);
  }
  if (job.hypotheses.empty())
    job.hypotheses.push_back({.name = "as given", .held = {}, .contact_stiffness = job.solver.contact_stiffness});
}

void read_published(const TomlTable& root, CalibrationJob& job) {
  for (const TomlTable& block : root.tables("ridge_points")) job.published.push_back(published_from(block, job));
}

}  // namespace percal
