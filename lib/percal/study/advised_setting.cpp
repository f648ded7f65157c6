#include "percal/study/advised_setting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "percal/math/statistics.hpp"

namespace percal {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

// Replicates whose mean has the error `target` on a mesh with the error `discretisation`; 0 where there is no such number.
int replicates_for(double target, double discretisation, double noise) {
  const double left = target * target - discretisation * discretisation;
  if (!(left > 0)) return 0;
  const double runs = std::max(1.0, std::ceil(noise * noise / left * (1 - 1e-12)));
  return runs <= most_advised_replicates ? static_cast<int>(runs) : 0;
}

struct Candidate {
  double elements_per_radius = 0;
  int replicates = 0;
  double discretisation = 0;
  double cpu_seconds = unbounded;
  bool is_estimated = false;
  bool is_found() const { return replicates > 0; }
};

void keep_cheaper(Candidate& best, double mesh, double discretisation, double run_seconds, const LadderModel& model,
                  double target) {
  const int replicates = replicates_for(target, discretisation, model.noise.on(mesh));
  if (replicates > 0 && replicates * run_seconds < best.cpu_seconds)
    best = {mesh, replicates, discretisation, replicates * run_seconds, best.is_estimated};
}

Candidate cheapest(std::span<const Rung> rungs, const LadderModel& model, const PowerLaw& cost, double target) {
  Candidate best;
  const double finest = rungs.back().elements_per_radius;
  for (std::size_t i = 0; i < rungs.size(); ++i)
    keep_cheaper(best, rungs[i].elements_per_radius, model.discretisation[i], rungs[i].cpu_seconds, model, target);
  if (best.is_found()) return best;
  best.is_estimated = true;
  for (double mesh = std::floor(finest) + 1; mesh <= farthest_advised_mesh * finest; ++mesh) {
    const double fitted = model.fit.error_at(1.0 / mesh) / model.fit.limit;
    keep_cheaper(best, mesh, std::hypot(fitted, model.irregularity), cost.at(mesh), model, target);
  }
  return best;
}

// The scene's own mesh with the runs that its noise needs.
Candidate on_scene_mesh(const Ladder& ladder, const LadderModel& model, const PowerLaw& cost, double target) {
  Candidate own;
  const auto rung = std::ranges::find(ladder.meshes, ladder.scene_mesh, &Rung::elements_per_radius);
  own.is_estimated = rung == ladder.meshes.end();
  keep_cheaper(own, ladder.scene_mesh, 0, own.is_estimated ? cost.at(ladder.scene_mesh) : rung->cpu_seconds, model,
               target);
  return own;
}

// Processor seconds of a run against elements per radius.
PowerLaw cost_law(std::span<const Rung> rungs) {
  std::vector<double> meshes, seconds;
  for (const Rung& rung : rungs) {
    meshes.push_back(rung.elements_per_radius);
    seconds.push_back(std::max(rung.cpu_seconds, 1e-9));
  }
  return fit_power_law(meshes, seconds, Misfit::relative);
}

std::optional<double> bounded(double seconds) { return seconds < unbounded ? std::optional(seconds) : std::nullopt; }

// The quantile of values that may be infinite: the next one of them, never one between.
double value_at(std::vector<double> values, double share) {
  std::ranges::sort(values);
  return values[static_cast<std::size_t>(std::lround(share * static_cast<double>(values.size() - 1)))];
}

std::string why_no_mesh(std::span<const Rung> rungs, const LadderModel& model) {
  return fmt::format(
      "no mesh of the ladder reaches it with up to {} replicates, nor, by the fitted curve, one of up to {:g} elements "
      "per radius: on {:g} the mesh's error is {:.2g} %, the depths scatter from mesh to mesh by {:.2g} % beyond their "
      "noise, and a run by {:.2g} %",
      most_advised_replicates, farthest_advised_mesh * rungs.back().elements_per_radius,
      rungs.back().elements_per_radius, 100 * model.discretisation.back(), 100 * model.irregularity,
      100 * model.noise.on(rungs.back().elements_per_radius));
}

std::string why_no_number(double noise) {
  return fmt::format("up to {} replicates do not reach it: a run scatters by {:.2g} %", most_advised_replicates,
                     100 * noise);
}

}  // namespace

AdvisedSetting advise(const Ladder& ladder, const ErrorVsTime& study, double target) {
  AdvisedSetting advice;
  advice.target = target;
  if (!study.is_answered()) {
    advice.why_not = study.has_limit() ? "the meshes of the ladder give no depth to extrapolate to"
                                       : "the finest mesh of the ladder gives no depth";
    return advice;
  }
  const auto rungs = std::span(ladder.meshes).subspan(study.first_used);
  const PowerLaw cost = cost_law(rungs);
  const auto choose = [&](const LadderModel& model) {
    return study.has_limit() ? cheapest(rungs, model, cost, target) : on_scene_mesh(ladder, model, cost, target);
  };
  const Candidate best = choose(study.model);
  std::vector<double> others;
  for (const auto& model : study.resampled) others.push_back(choose(model).cpu_seconds);
  advice.cpu_seconds_low = bounded(std::min(best.cpu_seconds, value_at(others, 0.025)));
  advice.cpu_seconds_high = bounded(std::max(best.cpu_seconds, value_at(others, 0.975)));
  if (!best.is_found()) {
    advice.why_not =
        study.has_limit() ? why_no_mesh(rungs, study.model) : why_no_number(study.model.noise.on(ladder.scene_mesh));
    return advice;
  }
  advice.is_found = true;
  advice.cost_is_estimated = best.is_estimated;
  advice.elements_per_radius = best.elements_per_radius;
  advice.replicates = best.replicates;
  if (study.has_limit()) advice.discretisation_error = best.discretisation;
  const double noise = study.model.noise.on(best.elements_per_radius);
  advice.noise_error = noise / std::sqrt(best.replicates);
  advice.error = combined_error(best.discretisation, noise, best.replicates);
  advice.cpu_seconds = best.cpu_seconds;
  return advice;
}

AdvisedSetting advise(double elements_per_radius, double noise, double target, double known) {
  AdvisedSetting advice;
  advice.target = target;
  // What runs have to bring beside what is known: 1/target^2 = 1/known^2 + 1/left^2.
  const double left = known > target ? 1 / std::sqrt(1 / (target * target) - 1 / (known * known)) : unbounded;
  advice.replicates = replicates_for(left, 0, noise);
  advice.is_found = advice.replicates > 0;
  if (!advice.is_found) {
    advice.why_not = why_no_number(noise);
    return advice;
  }
  advice.elements_per_radius = elements_per_radius;
  advice.noise_error = 1 / std::sqrt(1 / (known * known) + advice.replicates / (noise * noise));
  advice.error = advice.noise_error;
  return advice;
}

}  // namespace percal
