#include "percal/predict/emulator_json.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "percal/invert/depth_covariance.hpp"

namespace percal {
namespace {

using page::at;
using page::Json;

constexpr const char* input_names[] = {"ln_pi4",
                                       "ln_pi5",
                                       "alpha",
                                       "erosion_strain",
                                       "ln_depth_over_radius",
                                       "ln_bulk_ratio",
                                       "ln_erosion_length_over_radius",
                                       "cover_ln_1_plus_thickness_over_radius",
                                       "cover_ln_density_ratio",
                                       "cover_ln_mu_ratio",
                                       "cover_alpha",
                                       "cover_erosion_strain",
                                       "second_cover_ln_1_plus_thickness_over_radius",
                                       "second_cover_ln_density_ratio",
                                       "second_cover_ln_mu_ratio",
                                       "second_cover_alpha",
                                       "second_cover_erosion_strain"};
static_assert(std::size(input_names) == sphere_inputs);

// Of the inputs that are not left out.
Json lengths_to_json(const std::array<double, sphere_inputs>& length) {
  Json all = Json::object();
  for (int i = 0; i < sphere_inputs; ++i)
    if (length[i] > 0) all[input_names[i]] = page::finite(length[i]);
  return all;
}

std::array<double, sphere_inputs> lengths_of(const Json& json) {
  for (const auto& [name, value] : json.items())
    if (std::ranges::find(input_names, name) == std::end(input_names)) throw page::MissingKey("length");
  std::array<double, sphere_inputs> length{};
  for (int i = 0; i < sphere_inputs; ++i) length[i] = page::number(page::maybe(json, input_names[i])).value_or(0);
  return length;
}

// The inputs of a run under so many covers.
int inputs_under(std::size_t covers) {
  return inputs_without_covers + static_cast<int>(covers) * (sphere_inputs - inputs_without_covers) / most_covers;
}

// The inputs in the order of SphereInputs, the element's size and ln(depth/radius).
Json run_to_json(const TrainingRun& run, int inputs) {
  Json row = Json::array();
  for (int k = 0; k < inputs; ++k) row.push_back(run.at.*sphere_input_order[k]);
  row.push_back(run.h);
  row.push_back(run.log_depth);
  return row;
}

TrainingRun run_of(const Json& json, int inputs) {
  const auto row = row_of(json, static_cast<std::size_t>(inputs) + 2, "runs");
  TrainingRun run{.at = {}, .h = row[inputs], .log_depth = row[inputs + 1]};
  for (int k = 0; k < inputs; ++k) run.at.*sphere_input_order[k] = row[k];
  return run;
}

}  // namespace

double wanted(const Json& object, const std::string& key) {
  const auto value = page::number(object, key);
  if (!value) throw page::MissingKey(key);
  return *value;
}

int whole(const Json& object, const std::string& key) {
  const double value = wanted(object, key);
  if (!(value >= 0 && value <= std::numeric_limits<int>::max())) throw page::MissingKey(key);
  return static_cast<int>(value);
}

std::vector<double> row_of(const Json& json, std::size_t length, const char* key) {
  std::vector<double> row = page::numbers(json);
  if (row.size() != length || std::any_of(row.begin(), row.end(), [](double x) { return !std::isfinite(x); }))
    throw page::MissingKey(key);
  return row;
}

Json settings_to_json(const EmulatorSettings& settings) {
  return {{"amplitude", page::finite(settings.amplitude)},
          {"length", lengths_to_json(settings.length)},
          {"mesh_amplitude", page::finite(settings.mesh_amplitude)},
          {"mesh_length", lengths_to_json(settings.mesh_length)},
          {"mesh_order", page::finite(settings.mesh_order)},
          {"noise", page::finite(settings.noise)},
          {"noise_order", page::finite(settings.noise_order)},
          {"log_likelihood", page::finite(settings.log_likelihood)},
          {"likelihood_evaluations", settings.evaluations}};
}

EmulatorSettings settings_of(const Json& json) {
  return {.amplitude = wanted(json, "amplitude"),
          .length = lengths_of(at(json, "length")),
          .mesh_amplitude = wanted(json, "mesh_amplitude"),
          .mesh_length = lengths_of(at(json, "mesh_length")),
          .mesh_order = wanted(json, "mesh_order"),
          .noise = wanted(json, "noise"),
          .noise_order = wanted(json, "noise_order"),
          .log_likelihood = wanted(json, "log_likelihood"),
          .evaluations = whole(json, "likelihood_evaluations")};
}

void require_lengths(const EmulatorSettings& settings, const std::vector<TrainingRun>& runs) {
  if (runs.empty()) return;
  for (const int input : scale_of(runs).seen)
    if (!(settings.length[input] > 0) || (settings.mesh_amplitude > 0 && !(settings.mesh_length[input] > 0)))
      throw page::MissingKey("length");
}

Json runs_to_json(const std::vector<TrainingRun>& runs, std::size_t covers) {
  Json rows = Json::array();
  for (const TrainingRun& run : runs) rows.push_back(run_to_json(run, inputs_under(covers)));
  return rows;
}

std::vector<TrainingRun> runs_of(const Json& json, std::size_t covers) {
  std::vector<TrainingRun> runs;
  for (const Json& run : page::list(json, "runs")) runs.push_back(run_of(run, inputs_under(covers)));
  return runs;
}

}  // namespace percal
