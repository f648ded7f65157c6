#include "percal/calibrate/run_sizes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "percal/base/error.hpp"
#include "percal/calibrate/shot_problem.hpp"
#include "percal/problem/replicates.hpp"
#include "percal/scene/erosion_length.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

enum class End { shortest, longest };

// In the middle of all bounds, but for an erosion length, which is at one of its ends.
std::vector<double> natural_at(const CalibrationJob& job, End length) {
  std::vector<double> natural;
  for (const CalibrationParameter& parameter : job.parameters) {
    const FreeParameter& p = parameter.free;
    if (parameter.kind == ParameterKind::erosion_length)
      natural.push_back(length == End::shortest ? p.low : p.high);
    else
      natural.push_back(p.natural(p.middle()));
  }
  return natural;
}

CoveredMaterial material_of(const CalibrationJob& job, const MeasuredShot& shot, End length) {
  return target_at(job, job.hypotheses.front(), job.targets[shot.target], natural_at(job, length));
}

// "3 of 9 shots, first \"gold 2 um at 651 m/s\""; empty where `is_meant` is true of none.
template <class Test>
std::string counted_shots(const CalibrationJob& job, const Test& is_meant) {
  const auto count = std::ranges::count_if(job.shots, is_meant);
  if (count == 0) return "";
  return fmt::format("{} of {} shots, first {}", count, job.shots.size(),
                     in_quotes(std::ranges::find_if(job.shots, is_meant)->label));
}

// The coarsest mesh that is drawn for a shot, elements per radius.
double coarsest_drawn(const CalibrationJob& job, const MeasuredShot& shot) {
  const double mesh = mesh_of(shot, material_of(job, shot, End::longest), job.training.coarse);
  return mesh - walk_span(mesh) / 2;
}

void refuse_what_is_too_coarse(const CalibrationJob& job) {
  constexpr double rounding = 1e-9;
  const auto too_few_in_length = [&](const MeasuredShot& shot) {
    const double in_length = *material_of(job, shot, End::longest).erosion_length / shot.radius;
    return coarsest_drawn(job, shot) * in_length * largest_element_in_length < 1 - rounding;
  };
  const auto too_few_in_radius = [&](const MeasuredShot& shot) { return coarsest_drawn(job, shot) < 1 - rounding; };
  if (const std::string shots = counted_shots(job, too_few_in_length); !shots.empty())
    throw BadInput(
        Place{job.file, 0, "training.coarse"},
        fmt::format("{:g} elements in the erosion length, fewer than 3 on the coarsest meshes drawn about that: {}",
                    job.training.coarse, shots),
        "4 or more elements in the erosion length");
  if (const std::string shots = counted_shots(job, too_few_in_radius); !shots.empty())
    throw BadInput(Place{job.file, 0, "training.coarse"},
                   fmt::format("{:g} elements in the erosion length at its longest, fewer than one per radius: {}",
                               job.training.coarse, shots),
                   "a shorter erosion length, best below half a radius of the smallest sphere, or more elements in it");
}

// A cover that is not two elements thick is hardly there.
void refuse_covers_too_thin(const CalibrationJob& job) {
  constexpr double fewest_rows = 2;
  const auto too_thin = [&](const MeasuredShot& shot) {
    return std::ranges::any_of(job.targets[shot.target].covers, [&](const TargetCover& cover) {
      return cover.thickness / shot.radius * coarsest_drawn(job, shot) < fewest_rows;
    });
  };
  const std::string shots = counted_shots(job, too_thin);
  if (shots.empty()) return;
  const MeasuredShot& first = *std::ranges::find_if(job.shots, too_thin);
  const auto& covers = job.targets[first.target].covers;
  const double thinnest = std::ranges::min_element(covers, {}, &TargetCover::thickness)->thickness;
  const double wanted = fewest_rows * first.radius / thinnest;
  throw BadInput(
      Place{job.file, 0, "training.coarse"},
      fmt::format("a cover of fewer than two elements on the coarsest meshes: {}", shots),
      fmt::format("coarse = {:.0f} or more, or a target without that cover", std::ceil(wanted + phase_span / 2)));
}

}  // namespace

RunSize largest_run(const CalibrationJob& job) {
  const auto verifying = [&](const MeasuredShot& shot) {
    const CoveredMaterial material = material_of(job, shot, End::shortest);
    return shot_problem(job, shot, material, mesh_of(shot, material, job.training.verify));
  };
  refuse_covers_too_thin(job);
  if (has_erosion_length(job)) {
    refuse_what_is_too_coarse(job);
    const auto too_large = [&](const MeasuredShot& shot) { return is_too_large(verifying(shot)); };
    if (const std::string shots = counted_shots(job, too_large); !shots.empty()) {
      const Problem first = verifying(*std::ranges::find_if(job.shots, too_large));
      throw BadInput(
          Place{job.file, 0, "training.verify"},
          fmt::format("{:g} elements in the erosion length at its shortest, too large a run for {}: {:.4g} elements "
                      "per radius, {}",
                      job.training.verify, shots, first.elements_per_radius, in_words(size_of(first))),
          "a longer erosion length, or fewer elements in it");
    }
  }
  RunSize largest;
  for (const MeasuredShot& shot : job.shots) {
    const Problem problem = verifying(shot);
    refuse_what_is_too_large(problem, job.file, {"training.verify", "shots.layer_depth", "shots.layer_width"});
    if (const RunSize size = size_of(problem); size.elements > largest.elements) largest = size;
  }
  return largest;
}

}  // namespace percal
