#include "percal/study/measured_effects.hpp"

#include <cmath>

#include "percal/math/statistics.hpp"
#include "percal/problem/domain.hpp"
#include "percal/problem/replicates.hpp"

namespace percal {
namespace {

std::optional<MeasuredEffect> effect_of(DepthErrorSource source, const std::vector<Evaluation>& before,
                                        const std::vector<Evaluation>& after, double radius) {
  std::vector<double> changes;
  for (std::size_t k = 0; k < before.size(); ++k) {
    if (after[k].result.outcome != Outcome::stopped) return std::nullopt;
    changes.push_back((after[k].result.depth - before[k].result.depth) * radius);
  }
  const auto pairs = static_cast<int>(changes.size());
  return MeasuredEffect{source, mean(changes), sample_deviation(changes) / std::sqrt(pairs), pairs};
}

}  // namespace

Problem with_better(DepthErrorSource source, const Problem& problem) {
  Problem better = problem;
  if (source == DepthErrorSource::time_step) better.time_step_factor *= finer_step;
  if (source == DepthErrorSource::bulk) {
    better.bulk_ratio *= stiffer_bulk;
    for (LowerLayer& layer : better.below) layer.bulk_ratio *= stiffer_bulk;
  }
  if (source == DepthErrorSource::wall) {
    better.width *= farther_wall;
    better.graded_columns = problem.graded_columns == usual_graded_columns(problem)
                                ? usual_graded_columns(better)
                                : graded_columns_like(problem, problem.elements_per_radius, better.width);
  }
  return better;
}

long effect_runs(int replicates) { return static_cast<long>(measured_sources.size()) * replicates; }

std::vector<MeasuredEffect> measured_effects(const Reduction& reduction, const std::vector<Evaluation>& replicates,
                                             Campaign& campaign, Progress* progress) {
  std::vector<Problem> problems;
  for (const DepthErrorSource source : measured_sources) {
    problems.push_back(with_better(source, reduction.problem));
    problems.back().history_samples = 0;
  }
  const auto runs = campaign.replicate(problems, static_cast<int>(replicates.size()), progress);
  std::vector<MeasuredEffect> effects;
  for (std::size_t i = 0; i < runs.size(); ++i)
    if (const auto effect = effect_of(measured_sources[i], replicates, runs[i], reduction.scales.radius))
      effects.push_back(*effect);
  return effects;
}

}  // namespace percal
