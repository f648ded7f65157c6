#include "percal/sweep/sweep_runs.hpp"

#include <set>

#include "percal/math/instruction_level.hpp"
#include "percal/problem/replicates.hpp"
#include "percal/text/sha256.hpp"

namespace percal {

std::vector<std::vector<Problem>> problems_of(const std::vector<SweepPoint>& points) {
  std::vector<std::vector<Problem>> problems;
  for (const SweepPoint& point : points)
    problems.push_back(replicates_of(point.reduction.problem, point.scene.replicates));
  return problems;
}

std::vector<std::vector<Problem>> problems_to_run(const std::vector<std::vector<Problem>>& of_points,
                                                  const Store* store) {
  std::set<std::string> seen;
  std::vector<std::vector<Problem>> missing;
  for (const auto& replicates : of_points) {
    missing.emplace_back();
    for (const Problem& problem : replicates) {
      const std::string key = evaluation_key(problem, instruction_level());
      if (seen.insert(key).second && !(store && store->find(key))) missing.back().push_back(problem);
    }
  }
  return missing;
}

std::vector<std::vector<Evaluation>> run_points(const std::vector<SweepPoint>& points, Campaign& campaign,
                                                const Store* store, Progress& progress) {
  const auto of_points = problems_of(points);
  double work = 0;
  for (const auto& problems : problems_to_run(of_points, store))
    for (const Problem& problem : problems) work += work_of(problem);
  progress.weigh(work);
  std::vector<Problem> all;
  for (const auto& replicates : of_points) all.insert(all.end(), replicates.begin(), replicates.end());
  auto runs = campaign.evaluate(all, &progress);
  std::vector<std::vector<Evaluation>> grouped;
  auto next = runs.begin();
  for (const auto& replicates : of_points) {
    const auto first = next;
    next += static_cast<std::ptrdiff_t>(replicates.size());
    grouped.emplace_back(std::make_move_iterator(first), std::make_move_iterator(next));
  }
  return grouped;
}

std::string store_digest(const SweepPoint& point) {
  const auto replicates = replicates_of(point.reduction.problem, point.scene.replicates);
  const Problem& middle = replicates[static_cast<std::size_t>(middle_replicate(point.scene.replicates))];
  return sha256(evaluation_key(middle, instruction_level()));
}

}  // namespace percal
