// A job's head: the file, its settings, [training], [parameters.NAME] and [materials.NAME].
#include "percal/calibrate/job/read_job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "percal/invert/emulator.hpp"
#include "percal/scene/document_kind.hpp"
#include "percal/scene/erosion_length.hpp"
#include "percal/scene/scene_toml.hpp"
#include "percal/text/file.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

const Range confidence{.low = 0.5, .high = 0.9999, .words = "a confidence from 0.5 to 0.9999"};

SolverScene read_solver(const TomlTable& root) {
  const auto block = root.optional_table("solver");
  if (!block) return {};
  const SolverScene solver = solver_from(*block);  // of spheres; bodies of other shapes have a block's own
  if (solver.end_time)
    block->refuse("end_time", "a time for all spheres, small and large",
                  "no end_time in a job: runs end when the sphere stops");
  return solver;
}

constexpr int most_runs = 1000000;
const Range share{.low = 0, .high = 1, .words = "a share from 0 to 1, as 0.15 or \"15 %\""};
const Range some_share{
    .low = 0, .high = 1, .low_open = true, .words = "a share above 0 and up to 1, as 0.5 or \"50 %\""};

// A length must have three elements in it (scene/erosion_length.hpp).
const Range elements_in_length{.low = 1 / largest_element_in_length,
                               .high = 1000,
                               .words = "a number from 3 to 1000, of elements in the erosion length"};

const std::vector<std::string> kind_words(std::begin(parameter_kinds), std::end(parameter_kinds));
constexpr double smallest_exponent = 1e-3;  // the solver divides by it

Range range_of(ParameterKind kind) {
  if (kind == ParameterKind::modulus) return positive("modulus");
  if (kind == ParameterKind::erosion_strain) return positive("strain");
  if (kind == ParameterKind::erosion_length) return positive("length");
  if (kind == ParameterKind::rate_exponent) return {.low = -1, .high = 1, .words = "a power of the rate from -1 to 1"};
  if (kind == ParameterKind::size_exponent)
    return {.low = -2, .high = 2, .words = "a power of the radius from -2 to 2"};
  if (kind == ParameterKind::relaxation_share)
    return {.low = 0, .high = 1, .high_open = true, .words = "a share of the modulus from 0 to below 1"};
  if (kind == ParameterKind::relaxation_time) return positive("time");
  return {.low = -100, .high = 100, .words = "an exponent from -100 to 100"};
}

// Plots are files that carry it.
void check_name(const TomlTable& blocks, const std::string& name) {
  const auto fit_for_a_file = [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-'; };
  if (name.empty() || !std::all_of(name.begin(), name.end(), fit_for_a_file))
    blocks.refuse(name, "a parameter called " + in_quotes(name), "a name of letters, digits, '_' and '-'");
}

void check_bounds(const TomlTable& block, ParameterKind kind, const FreeParameter& free) {
  if (!(free.low < free.high)) block.refuse("high", "a bound that is not above low", "low below high");
  if (kind == ParameterKind::exponent && free.low < smallest_exponent && free.high > -smallest_exponent)
    block.refuse("low", fmt::format("bounds from {} to {}, with 0 between them", free.low, free.high),
                 "exponents of one sign, at least 0.001 in size");
}

void read_prior(const TomlTable& block, ParameterKind kind, FreeParameter& free) {
  free.prior = block.optional_quantity("prior", dimension_of(kind), range_of(kind));
  const auto error = optional_share_from(block, "prior_error", positive("prior error"));
  if (free.prior && !error)
    block.refuse("prior_error", "no such key beside prior",
                 free.logarithmic ? "the prior's standard deviation as a share of it: 0.1 or \"10 %\""
                                  : "the prior's standard deviation, a number");
  if (error && !free.prior) block.refuse("prior", "no such key beside prior_error", "the value that is expected");
  free.prior_error = error.value_or(0);
}

CalibrationParameter parameter_from(const TomlTable& block, const std::string& name) {
  CalibrationParameter parameter{static_cast<ParameterKind>(block.word("kind", kind_words)), {}};
  const ParameterKind kind = parameter.kind;
  FreeParameter& free = parameter.free;
  free.name = name;
  free.unit = kind == ParameterKind::modulus           ? "Pa"
              : kind == ParameterKind::erosion_length  ? "m"
              : kind == ParameterKind::relaxation_time ? "s"
                                                       : "";
  free.logarithmic = kind == ParameterKind::modulus || kind == ParameterKind::erosion_strain ||
                     kind == ParameterKind::erosion_length || kind == ParameterKind::relaxation_time;
  free.low = block.quantity("low", dimension_of(kind), range_of(kind));
  free.high = block.quantity("high", dimension_of(kind), range_of(kind));
  check_bounds(block, kind, free);
  read_prior(block, kind, free);
  return parameter;
}

std::string parameters_of(const CalibrationJob& job, ParameterKind kind) {
  std::vector<std::string> names;
  for (const auto& parameter : job.parameters)
    if (parameter.kind == kind) names.push_back(parameter.free.name);
  return names.empty() ? "none of this kind" : listed(names);
}

std::optional<SharedParameter> named_parameter(const TomlTable& block, const std::string& key,
                                               const CalibrationJob& job, ParameterKind kind) {
  if (!block.is_text(key)) return std::nullopt;
  const std::string name = block.text(key);
  for (std::size_t k = 0; k < job.parameters.size(); ++k) {
    if (job.parameters[k].free.name != name) continue;
    if (job.parameters[k].kind != kind)
      block.refuse(key, fmt::format("{}, a parameter of kind \"{}\"", in_quotes(name), word(job.parameters[k].kind)),
                   fmt::format("a parameter of kind \"{}\": {}", word(kind), parameters_of(job, kind)));
    return SharedParameter{static_cast<int>(k)};
  }
  return std::nullopt;
}

void describe_number(const TomlTable& block, const std::string& key, ParameterKind kind) {
  block.describe(key, {name_of(dimension_of(kind)) + " or name",
                       words_of(range_of(kind)) + ", or the name of a parameter of kind " + in_quotes(word(kind)), ""});
}

// A quantity, or the name of a parameter of the kind.
MaterialNumber number_from(const TomlTable& block, const std::string& key, const CalibrationJob& job,
                           ParameterKind kind) {
  describe_number(block, key, kind);
  if (const auto shared = named_parameter(block, key, job, kind)) return *shared;
  const std::string accepted = fmt::format("{}, or the name of a parameter: {}",
                                           words_of(range_of(kind), dimension_of(kind)), parameters_of(job, kind));
  if (block.is_text(key)) {
    const std::string text = block.text(key);
    try {
      parse_quantity(text);
    } catch (const std::invalid_argument&) {
      block.refuse(key, in_quotes(text), accepted);
    }
  }
  if (!block.has(key)) block.refuse(key, "no such key", accepted);
  const double value = block.quantity(key, dimension_of(kind), range_of(kind));
  if (kind == ParameterKind::exponent && std::abs(value) < smallest_exponent)
    block.refuse(key, fmt::format("{}", value), "an exponent at least 0.001 in size");
  return value;
}

// One emulator answers for all materials: all are judged over a length, or none is.
std::optional<MaterialNumber> erosion_length_from(const TomlTable& block, const CalibrationJob& job) {
  describe_number(block, "erosion_length", ParameterKind::erosion_length);
  const bool has = block.has("erosion_length");
  if (!job.materials.empty() && has != has_erosion_length(job)) {
    const std::string first = job.materials.front().name;
    block.refuse("erosion_length", has ? "this, but " + first + " has none" : "no such key, but " + first + " has one",
                 "an erosion length of every material of a job, or of none");
  }
  if (!has) return std::nullopt;
  return number_from(block, "erosion_length", job, ParameterKind::erosion_length);
}

// A law's number with what it refers to: both keys or none.
struct LawKeys {
  std::string exponent, reference;
};
void read_law(const TomlTable& block, const LawKeys& keys, ParameterKind kind, const Dimension& dimension,
              const CalibrationJob& job, MaterialNumber& exponent, double& reference) {
  describe_number(block, keys.exponent, kind);
  block.knows(keys.exponent);
  const auto given = block.optional_quantity(keys.reference, dimension, positive(keys.reference));
  if (!block.has(keys.exponent)) {
    if (given) block.refuse(keys.reference, "this without " + keys.exponent, "both or none");
    return;
  }
  if (!given) block.refuse(keys.reference, "no such key beside " + keys.exponent, "what it refers to");
  exponent = number_from(block, keys.exponent, job, kind);
  reference = *given;
}

double highest_of(const MaterialNumber& number, const CalibrationJob& job) {
  if (const auto* shared = std::get_if<SharedParameter>(&number)) return job.parameters[shared->index].free.high;
  return std::get<double>(number);
}

// [[materials.NAME.relaxation]]; its shares must not be able to take the whole modulus.
std::vector<MaterialRelaxation> relaxation_from(const TomlTable& block, const CalibrationJob& job) {
  std::vector<MaterialRelaxation> terms;
  double highest = 0;
  for (const TomlTable& term : block.tables("relaxation")) {
    terms.push_back({number_from(term, "share", job, ParameterKind::relaxation_share),
                     number_from(term, "time", job, ParameterKind::relaxation_time)});
    highest += highest_of(terms.back().share, job);
  }
  if (terms.size() > most_relaxation_terms)
    block.refuse("relaxation", fmt::format("{} terms", terms.size()), "up to 3 terms");
  if (highest >= 1)
    block.refuse("relaxation", fmt::format("shares that may add up to {:.4g}", highest),
                 "shares, or highest values of their parameters, that add up to less than 1");
  if (!terms.empty() && block.has("rate_exponent"))
    block.refuse("relaxation", "this beside rate_exponent", "one law of the rate");
  return terms;
}

CalibrationMaterial material_from(const TomlTable& block, const std::string& name, const CalibrationJob& job) {
  CalibrationMaterial material{
      .name = name,
      .density = block.quantity("density", dimension::density, positive("density")),
      .mu = number_from(block, "mu", job, ParameterKind::modulus),
      .alpha = number_from(block, "alpha", job, ParameterKind::exponent),
      .erosion_strain = number_from(block, "erosion_strain", job, ParameterKind::erosion_strain),
      .erosion_length = erosion_length_from(block, job),
      .rate_factor = block.optional_number("rate_factor", positive("factor")),
      .rate_factor_error = share_from(block, "rate_factor_error", not_negative("share"), 0),
      .curve_modulus = block.optional_quantity("curve_modulus", dimension::pressure, positive("modulus"))};
  read_law(block, {"rate_exponent", "reference_rate"}, ParameterKind::rate_exponent, dimension::rate, job,
           material.rate_exponent, material.reference_rate);
  read_law(block, {"size_exponent", "reference_radius"}, ParameterKind::size_exponent, dimension::length, job,
           material.size_exponent, material.reference_radius);
  read_law(block, {"erosion_strain_below", "cell"}, ParameterKind::erosion_strain, dimension::length, job,
           material.erosion_strain_below, material.cell);
  material.relaxation = relaxation_from(block, job);
  if (!material.rate_factor && block.has("rate_factor_error"))
    block.refuse("rate_factor", "no such key beside rate_factor_error", "the factor");
  return material;
}

void read_parameters(const TomlTable& root, CalibrationJob& job) {
  const TomlTable blocks = root.table("parameters");
  for (const std::string& name : blocks.keys()) {
    check_name(blocks, name);
    job.parameters.push_back(parameter_from(blocks.table(name), name));
  }
  if (job.parameters.empty()) root.refuse("parameters", "no parameter", "one [parameters.NAME] or more");
}

void read_materials(const TomlTable& root, CalibrationJob& job) {
  const TomlTable blocks = root.table("materials");
  for (const std::string& name : blocks.keys()) job.materials.push_back(material_from(blocks.table(name), name, job));
  if (job.materials.empty()) root.refuse("materials", "no material", "one [materials.NAME] or more");
}

// By their keys in results.
std::set<RunNumber> numbers_to_learn(const TomlTable& block) {
  std::vector<std::string> names;
  for (const RunNumber number : numbers_beside) names.emplace_back(kind_of(number).key);
  block.describe("learn", {"array of words", listed(names), ""});
  block.knows("learn");
  std::set<RunNumber> numbers;
  if (!block.has("learn")) return numbers;
  for (const std::string& name : block.texts("learn")) {
    const auto number = run_number_of(name);
    if (!number || *number == RunNumber::depth) block.refuse("learn", in_quotes(name), listed(names));
    numbers.insert(*number);
  }
  return numbers;
}

void read_training(const TomlTable& root, CalibrationJob& job) {
  TrainingSettings& t = job.training;
  const bool length = has_erosion_length(job);
  if (length) t.coarse = 4, t.fine = t.verify = 6;
  const auto block = root.optional_table("training");
  if (!block) return;
  const Range meshes = length ? elements_in_length : elements_per_radius_range();
  t.coarse = block->number("coarse", meshes, t.coarse);
  t.fine = block->number("fine", meshes, t.fine);
  t.verify = block->number("verify", meshes, t.verify);
  const std::string as_many = std::string("as many ") + mesh_words(job) + " or more";
  if (t.fine < t.coarse) block->refuse("fine", "a mesh coarser than coarse", as_many);
  if (t.verify < t.fine) block->refuse("verify", "a mesh coarser than fine", as_many);
  t.initial = block->integer("initial", fewest_training_runs, most_runs, t.initial);
  t.batch = block->integer("batch", 1, most_runs, t.batch);
  t.most = block->integer("most", t.initial, most_runs, std::max(t.most, t.initial));
  t.body.initial = block->integer("body_initial", smallest_training, most_runs, t.body.initial);
  t.body.batch = block->integer("body_batch", 1, most_runs, t.body.batch);
  t.body.most = block->integer("body_most", t.body.initial, most_runs, std::max(t.body.most, t.body.initial));
  t.fine_share = share_from(*block, "fine_share", share, t.fine_share);
  t.accuracy = share_from(*block, "accuracy", some_share, t.accuracy);
  t.failures_tolerated = share_from(*block, "failures_tolerated", share, t.failures_tolerated);
  t.passage = block->flag("passage", t.passage);
  t.learn = numbers_to_learn(*block);
  t.verify_replicates = block->integer("verify_replicates", 1, 100, t.verify_replicates);
  t.seed = static_cast<unsigned>(block->integer("seed", 0, 2147483647, static_cast<int>(t.seed)));
}

}  // namespace

Dimension dimension_of(ParameterKind kind) {
  if (kind == ParameterKind::erosion_length) return dimension::length;
  if (kind == ParameterKind::relaxation_time) return dimension::time;
  return kind == ParameterKind::modulus ? dimension::pressure : dimension::none;
}

CalibrationJob read_calibration_job(const std::string& path) {
  CalibrationJob job;
  job.file = path;
  job.text = read_file(path);
  const TomlTable root = parse_toml(job.text, path);
  need_kind(root, DocumentKind::calibrate);
  job.title = root.text("title", path);
  job.level = root.number("level", confidence, job.level);
  job.bootstrap = root.integer("bootstrap", 0, 100000, job.bootstrap);
  job.dehn = root.flag("dehn", job.dehn);
  job.solver = read_solver(root);
  read_parameters(root, job);
  read_materials(root, job);
  read_targets(root, job);
  read_training(root, job);  // what its meshes count, the materials say
  read_scatter_groups(root, job);
  read_shots(root, job);
  read_job_curves(root, job);
  read_hypotheses(root, job);
  read_cross_validations(root, job);
  read_published(root, job);
  root.finish();
  check_use(root, job);
  settle_bodies(root, job);
  settle_width(job);
  return job;
}

}  // namespace percal
