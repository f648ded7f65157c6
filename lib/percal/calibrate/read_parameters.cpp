// [parameters.NAME] and [materials.NAME].
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <stdexcept>

#include "percal/calibrate/read_job.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

const std::vector<std::string> kind_words{"modulus", "exponent", "erosion strain"};  // as ParameterKind
constexpr double smallest_exponent = 1e-3;                                           // the solver divides by it

Dimension dimension_of(ParameterKind kind) {
  return kind == ParameterKind::modulus ? dimension::pressure : dimension::none;
}

Range range_of(ParameterKind kind) {
  if (kind == ParameterKind::modulus) return positive("modulus");
  if (kind == ParameterKind::erosion_strain) return positive("strain");
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
  free.unit = kind == ParameterKind::modulus ? "Pa" : "";
  free.logarithmic = kind != ParameterKind::exponent;
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
      block.refuse(
          key,
          fmt::format("{}, a parameter of kind \"{}\"", in_quotes(name),
                      kind_words[static_cast<int>(job.parameters[k].kind)]),
          fmt::format("a parameter of kind \"{}\": {}", kind_words[static_cast<int>(kind)], parameters_of(job, kind)));
    return SharedParameter{static_cast<int>(k)};
  }
  return std::nullopt;
}

// A quantity, or the name of a parameter of the kind.
MaterialNumber number_from(const TomlTable& block, const std::string& key, const CalibrationJob& job,
                           ParameterKind kind) {
  block.describe(key, {dimension_of(kind) == dimension::none ? "number or name" : "pressure or name",
                       words_of(range_of(kind)) + ", or the name of a parameter of kind " +
                           in_quotes(kind_words[static_cast<int>(kind)]),
                       ""});
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

CalibrationMaterial material_from(const TomlTable& block, const std::string& name, const CalibrationJob& job) {
  CalibrationMaterial material{
      .name = name,
      .density = block.quantity("density", dimension::density, positive("density")),
      .mu = number_from(block, "mu", job, ParameterKind::modulus),
      .alpha = number_from(block, "alpha", job, ParameterKind::exponent),
      .erosion_strain = number_from(block, "erosion_strain", job, ParameterKind::erosion_strain),
      .rate_factor = block.optional_number("rate_factor", positive("factor")),
      .rate_factor_error = share_from(block, "rate_factor_error", not_negative("share"), 0),
      .curve_modulus = block.optional_quantity("curve_modulus", dimension::pressure, positive("modulus"))};
  if (!material.rate_factor && block.has("rate_factor_error"))
    block.refuse("rate_factor", "no such key beside rate_factor_error", "the factor");
  return material;
}

}  // namespace

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

int material_index(const TomlTable& block, const CalibrationJob& job) {
  const std::string name = block.text("material");
  for (std::size_t m = 0; m < job.materials.size(); ++m)
    if (job.materials[m].name == name) return static_cast<int>(m);
  block.refuse("material", in_quotes(name), "a material of the job: " + names_of(job.materials));
}

}  // namespace percal
