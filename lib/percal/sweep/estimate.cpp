#include "percal/sweep/estimate.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <queue>

#include "percal/base/memory.hpp"
#include "percal/campaign/sphere_runs.hpp"
#include "percal/impact/target/size.hpp"
#include "percal/problem/domain.hpp"
#include "percal/scene/erosion_length.hpp"

namespace percal {
namespace {

constexpr int most_measured = 16;
constexpr double coarser = 0.5;           // of the elements per radius
constexpr double fewest_elements = 5;     // per radius: below, a run's share of its size is another
constexpr double most_measured_work = 1e9;  // of one run: a few seconds

// Elements per radius of the run that is measured for a problem: coarser, but not so coarse that it would be another problem.
double measured_mesh(const Problem& problem) {
  double least = fewest_elements;
  if (const auto length = erosion_length(problem)) least = std::max(least, 1 / (largest_element_in_length * *length));
  const double quick = problem.elements_per_radius * std::cbrt(most_measured_work / work_of(problem));
  return std::min(problem.elements_per_radius, std::max(least, std::min(coarser * problem.elements_per_radius, quick)));
}

// Evenly over the problems in the order of their work.
std::vector<Problem> sample_of(const std::vector<Problem>& problems) {
  std::vector<const Problem*> sorted;
  for (const Problem& problem : problems) sorted.push_back(&problem);
  std::ranges::stable_sort(sorted, {}, [](const Problem* problem) { return work_of(*problem); });
  const int count = std::min<int>(most_measured, static_cast<int>(sorted.size()));
  std::vector<Problem> sample;
  for (int k = 0; k < count; ++k) {
    const auto place = static_cast<std::size_t>((k + 0.5) / count * static_cast<double>(sorted.size()));
    sample.push_back(on_mesh(*sorted[place], measured_mesh(*sorted[place])));
  }
  return sample;
}

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

double memory_of_this_process() {
  std::ifstream file("/proc/self/statm");
  double pages = 0, resident = 0;
  file >> pages >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGE_SIZE));
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

CostEstimate estimate_cost(const std::vector<Problem>& to_run, long runs, int threads) {
  CostEstimate estimate{.runs = runs, .stored = runs - static_cast<long>(to_run.size()), .threads = threads};
  add_memory(estimate, to_run, threads);
  const std::vector<Problem> sample = sample_of(to_run);
  if (sample.empty()) return estimate;
  Campaign campaign(nullptr, threads);
  double steps = 0, work = 0, wall = 0;
  const auto measured = campaign.evaluate(sample, nullptr);
  for (std::size_t k = 0; k < sample.size(); ++k) {
    steps += measured[k].result.element_steps;
    work += work_of(sample[k]);
    wall += measured[k].wall_seconds;
  }
  estimate.measured_runs = static_cast<int>(sample.size());
  estimate.measured_cpu_seconds = campaign.cost().cpu_seconds;
  std::vector<double> seconds;
  for (const Problem& problem : to_run) {
    const double element_steps = work_of(problem) * steps / work;
    estimate.element_steps += element_steps;
    estimate.cpu_seconds += element_steps * campaign.cost().cpu_seconds / steps;
    seconds.push_back(element_steps * wall / steps);
  }
  estimate.longest_seconds = std::ranges::max(seconds);
  estimate.wall_seconds = end_of_all(seconds, std::max(1, estimate.side_by_side));
  return estimate;
}

}  // namespace percal
