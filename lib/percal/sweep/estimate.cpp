#include "percal/sweep/estimate.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>

#include "percal/base/memory.hpp"
#include "percal/campaign/sphere_runs.hpp"
#include "percal/impact/target/size.hpp"
#include "percal/problem/domain.hpp"
#include "percal/scene/erosion_length.hpp"

namespace percal {
namespace {

constexpr std::size_t most_measured = 16;
constexpr double coarser = 0.5;             // of the elements per radius
constexpr double fewest_elements = 5;       // per radius: below, a run's share of its size is another
constexpr double most_measured_work = 1e9;  // of one run: a few seconds

// Elements per radius of the run that is measured for a problem: coarser, but not so coarse that it would be another problem.
double measured_mesh(const Problem& problem) {
  double least = fewest_elements;
  if (const auto length = erosion_length(problem)) least = std::max(least, 1 / (largest_element_in_length * *length));
  const double quick = problem.elements_per_radius * std::cbrt(most_measured_work / work_of(problem));
  return std::min(problem.elements_per_radius, std::max(least, std::min(coarser * problem.elements_per_radius, quick)));
}

// Points with something to run in the order of the work of one run, and which of them are measured.
struct Sample {
  std::vector<const std::vector<Problem>*> points;
  std::vector<std::size_t> measured;  // of `points`, evenly among them

  explicit Sample(const std::vector<std::vector<Problem>>& to_run) {
    for (const auto& problems : to_run)
      if (!problems.empty()) points.push_back(&problems);
    std::ranges::stable_sort(points, {}, [](const auto* problems) { return work_of(middle(*problems)); });
    const std::size_t count = std::min(most_measured, points.size());
    for (std::size_t k = 0; k < count; ++k) measured.push_back((2 * k + 1) * points.size() / (2 * count));
  }
  static const Problem& middle(const std::vector<Problem>& problems) { return problems[problems.size() / 2]; }

  std::vector<Problem> coarser_problems() const {
    std::vector<Problem> problems;
    for (const std::size_t place : measured)
      problems.push_back(on_mesh(middle(*points[place]), measured_mesh(middle(*points[place]))));
    return problems;
  }
  // Of the measured ones, the one that stands for a point.
  std::size_t nearest(std::size_t place) const {
    return std::min(measured.size() - 1, place * measured.size() / points.size());
  }
};

// When the last of these ends, each begun by the thread that is free first, the longest first.
double end_of_all(std::vector<double> seconds, int threads) {
  std::ranges::sort(seconds, std::greater<>());
  std::priority_queue<double, std::vector<double>, std::greater<>> free_at;
  for (int k = 0; k < threads; ++k) free_at.push(0);
  double last = 0;
  for (const double one : seconds) {
    const double end = free_at.top() + one;
    free_at.pop();
    free_at.push(end);
    last = std::max(last, end);
  }
  return last;
}

// The largest that are side by side, as far as they fit.
void add_memory(CostEstimate& estimate, const std::vector<Problem>& problems, int threads) {
  std::vector<double> bytes;
  for (const Problem& problem : problems) bytes.push_back(size_of(problem).bytes);
  std::ranges::sort(bytes, std::greater<>());
  const double room = available_memory();
  double taken = 0;
  estimate.side_by_side = 0;
  for (const double one : bytes) {
    if (estimate.side_by_side == threads || (estimate.side_by_side > 0 && taken + one > room)) break;
    taken += one;
    ++estimate.side_by_side;
  }
  estimate.bytes = memory_of_this_process() + taken;
}

}  // namespace

CostEstimate estimate_cost(const std::vector<std::vector<Problem>>& to_run, long runs, int threads) {
  CostEstimate estimate{.runs = runs, .threads = threads};
  std::vector<Problem> all;
  for (const auto& problems : to_run) all.insert(all.end(), problems.begin(), problems.end());
  estimate.stored = runs - static_cast<long>(all.size());
  if (all.empty()) return estimate;
  add_memory(estimate, all, threads);
  const Sample sample(to_run);
  const std::vector<Problem> coarser_problems = sample.coarser_problems();
  Campaign campaign(nullptr, threads);
  const auto measured = campaign.evaluate(coarser_problems, nullptr);
  estimate.measured_runs = static_cast<int>(measured.size());
  estimate.measured_cpu_seconds = campaign.cost().cpu_seconds;
  std::vector<double> seconds;
  for (std::size_t place = 0; place < sample.points.size(); ++place) {
    const std::size_t k = sample.nearest(place);
    for (const Problem& problem : *sample.points[place]) {
      const double size = work_of(problem) / work_of(coarser_problems[k]);
      estimate.element_steps += size * measured[k].result.element_steps;
      estimate.cpu_seconds += size * measured[k].cpu_seconds;
      seconds.push_back(size * measured[k].wall_seconds);
    }
  }
  estimate.longest_seconds = std::ranges::max(seconds);
  estimate.wall_seconds = end_of_all(seconds, estimate.side_by_side);
  return estimate;
}

}  // namespace percal
