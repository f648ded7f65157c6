#include "percal/campaign/sphere_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <stdexcept>

#include "percal/base/error.hpp"
#include "percal/base/version.hpp"
#include "percal/invert/reach.hpp"
#include "percal/math/instruction_level.hpp"
#include "percal/math/polyhedron.hpp"
#include "percal/observe/stored_run.hpp"
#include "percal/problem/domain.hpp"
#include "percal/problem/replicates.hpp"

namespace percal {
namespace {

static_assert(phase_span < one_mesh_span, "the phases of one mesh must not be taken for several meshes");

bool is_plain(const LowerLayer& layer) {
  return layer.erosion_limit > 0 && std::isfinite(layer.erosion_limit) && layer.further_erosion.is_empty() &&
         layer.stretch == 1 && std::holds_alternative<NoFibres>(layer.fibres);
}

double engineering_strain(double limit, StrainMeasure measure) {
  return strain_at(stretch_at(limit, measure), StrainMeasure::engineering);
}

// Of the layer's n-th boundary from the top, in radii: as its rows of elements have it.
double boundary(const Problem& p, std::size_t n) {
  return std::round(p.lower_faces()[n] * p.elements_per_radius) / p.elements_per_radius;
}

// In radii: the smaller of half width and half thickness.
double smaller_half(const Particle& particle) {
  if (const auto* prism = std::get_if<RigidPolygon>(&particle); prism && prism->half_thickness > 0)
    return std::min(1.0, prism->half_thickness);
  if (const auto* body = std::get_if<RigidPolyhedron>(&particle)) {
    const auto [low, high] = extent(body->vertices, 1);
    return std::min(1.0, (high - low) / 2);
  }
  return 1;
}

std::optional<double> reach_of(const Problem& problem, const StoredEvaluation& evaluation, const Store& store) {
  const bool may_have = evaluation.outcome == word(Outcome::stopped) || problem.until != RunUntil::deepest;
  if (!may_have) return std::nullopt;
  try {
    return reach_of(problem, from_payload(evaluation.payload).result);
  } catch (const std::invalid_argument& error) {
    throw IoFailure(fmt::format("{}: {}; remove the file or name another store", store.path(), error.what()));
  }
}

}  // namespace

bool is_for_an_emulator(const Problem& p) {
  return std::holds_alternative<RigidSphere>(p.particle) && p.geometry == Geometry::axisymmetric &&
         std::holds_alternative<StrainErosion>(p.erosion) && p.further_erosion.is_empty() && p.stretch == 1 &&
         std::holds_alternative<NoFibres>(p.fibres) && std::holds_alternative<NoRelaxation>(p.relaxation) &&
         std::holds_alternative<NoFriction>(p.friction) && p.below.size() <= most_covers &&
         std::ranges::all_of(p.below, is_plain);
}

std::string stored_spheres_prefix() { return sphere_key_prefix(instruction_level()); }

std::vector<StoredSphere> stored_spheres(const Store& store) {
  std::vector<StoredSphere> spheres;
  for (const auto& [key, evaluation] : store.with_prefix(stored_spheres_prefix())) {
    const auto problem = problem_of_key(key, instruction_level());
    if (!problem || !is_for_an_emulator(*problem)) continue;
    spheres.push_back(
        {*problem, key, evaluation.outcome, reach_of(*problem, evaluation, store), evaluation.cpu_seconds});
  }
  return spheres;
}

std::optional<double> erosion_length(const Problem& problem) {
  const auto* average = std::get_if<AverageWithin>(&problem.erosion_average);
  return average ? std::optional(average->length) : std::nullopt;
}

double log_erosion_length(const std::optional<double>& radii) { return radii ? std::log(*radii) : 0; }

double element_size(const Problem& problem) {
  return 1.0 / problem.elements_per_radius / smaller_half(problem.particle) / erosion_length(problem).value_or(1);
}

SphereInputs inputs_of(const Problem& p) {
  const auto& erosion = std::get<StrainErosion>(p.erosion);
  std::vector<LowerLayer> layers{
      {.depth = p.depth, .mu = p.mu(), .alpha = p.alpha, .bulk_ratio = p.bulk_ratio, .erosion_limit = erosion.limit}};
  layers.insert(layers.end(), p.below.begin(), p.below.end());
  const LowerLayer& last = layers.back();
  SphereInputs at{.log_pi4 = std::log(last.density / last.mu * p.speed_factor * p.speed_factor),
                  .log_pi5 = std::log(last.density / p.density_ratio),
                  .alpha = last.alpha,
                  .erosion_strain = engineering_strain(last.erosion_limit, erosion.measure),
                  .log_layer_depth = std::log(p.whole_depth()),
                  .log_bulk_ratio = std::log(last.bulk_ratio),
                  .log_erosion_length = log_erosion_length(erosion_length(p))};
  for (std::size_t k = 0; k < p.below.size(); ++k) {
    const std::size_t n = p.below.size() - 1 - k;
    lay_on(at, cover_members[k],
           {.thickness = boundary(p, n) - (n == 0 ? 0 : boundary(p, n - 1)),
            .density = layers[n].density / last.density,
            .mu = layers[n].mu / last.mu,
            .alpha = layers[n].alpha,
            .erosion_strain = engineering_strain(layers[n].erosion_limit, erosion.measure)});
  }
  return at;
}

// The key of the problem with everything that an emulator knows of set to 1.
std::string setting_of(const Problem& problem) {
  Problem plain = problem;
  plain.pi4 = plain.density_ratio = plain.alpha = plain.depth = plain.bulk_ratio = plain.speed_factor = 1;
  plain.erosion = StrainErosion{1};
  plain.below.clear();
  if (erosion_length(problem)) plain.erosion_average = AverageWithin{1};
  if (plain.graded_columns == usual_graded_columns(plain)) plain.graded_columns = 0;
  plain.elements_per_radius = 1;
  plain.until = RunUntil::deepest;  // the depth is the same
  return evaluation_key(plain, "any");
}

Problem problem_of(const std::string& setting, const TrainingRun& run) {
  static const std::regex version("solver=[0-9]+");
  const std::string now = std::regex_replace(setting, version, fmt::format("solver={}", solver_version));
  auto problem = problem_of_key(now, "any");
  if (!problem) throw BadInput({}, "\"" + setting + "\"", "a setting of the solver, as setting_of() writes it");
  const double length = erosion_length(*problem) ? std::exp(run.at.log_erosion_length) : 1;
  problem->pi4 = round_to_12_digits(std::exp(run.at.log_pi4));
  problem->density_ratio = round_to_12_digits(std::exp(-run.at.log_pi5));
  problem->alpha = round_to_12_digits(run.at.alpha);
  problem->depth = round_to_12_digits(std::exp(run.at.log_layer_depth));
  problem->bulk_ratio = round_to_12_digits(std::exp(run.at.log_bulk_ratio));
  problem->erosion = StrainErosion{round_to_12_digits(run.at.erosion_strain)};
  if (erosion_length(*problem)) problem->erosion_average = AverageWithin{round_to_12_digits(length)};
  problem->until = RunUntil::passage;
  problem->elements_per_radius = round_to_12_digits(1 / (run.h * length));
  if (problem->graded_columns == 0) problem->graded_columns = usual_graded_columns(*problem);
  return *problem;
}

std::optional<double> reach_of(const Problem& problem, const ImpactResult& result) {
  if (result.outcome == Outcome::stopped) return result.depth;
  if (result.outcome != Outcome::passed_through || !result.aftermath) return std::nullopt;
  const Aftermath& after = *result.aftermath;
  if (after.ending == Ending::rests || after.ending == Ending::left_upwards) return problem.whole_depth();
  if (after.ending != Ending::passed_through) return std::nullopt;
  constexpr double least_loss = 0.1;  // of the energy
  const double left = after.speed / problem.speed_factor;
  return left * left < 1 - least_loss ? std::optional(reach_of_passage(problem.whole_depth(), left)) : std::nullopt;
}

TrainingRun training_run(const Problem& problem, double reach) {
  return {.at = inputs_of(problem), .h = element_size(problem), .log_depth = std::log(reach)};
}

}  // namespace percal
