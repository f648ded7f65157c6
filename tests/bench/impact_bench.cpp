// Measures the impact solver and prints one JSON line: docs/verification/make_performance.py makes tables of them. Not a test.
//
//   impact_bench run [key=value]...    one run: elements, steps, element-steps, times, memory, samples by phase
//   impact_bench batch [key=value]...  `runs` replicates side by side on `threads` threads: wall time
//   impact_bench peak                  what one core reaches in multiply-adds and in moving memory
//
// Keys (all but runs and replicate as in problem/problem.hpp): nf, graded, depth, fine, end, double, history (points of it), rates,
// threads, replicate, runs. The problem is setting S of docs/theory/impact.md. The instruction level is the environment's PERCAL_ISA.
#include <sys/resource.h>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "bench/machine_peak.hpp"
#include "bench/phase_sampler.hpp"
#include "impact/setting_s.hpp"
#include "percal/impact/march/march.hpp"
#include "percal/math/instruction_level.hpp"
#include "percal/problem/replicates.hpp"

namespace {

using namespace percal;
using nlohmann::json;

class Options {
 public:
  Options(int argc, char** argv) {
    for (int k = 2; k < argc; ++k) {
      const std::string word = argv[k];
      const auto equals = word.find('=');
      if (equals == std::string::npos || !known.contains(word.substr(0, equals))) {
        std::fprintf(stderr, "impact_bench: %s: expected key=number, the key one of those above in the source\n",
                     argv[k]);
        std::exit(2);
      }
      values_[word.substr(0, equals)] = std::atof(word.c_str() + equals + 1);
    }
  }
  double operator()(const std::string& key) const {
    const auto found = values_.find(key);
    return found == values_.end() ? known.at(key) : found->second;
  }

 private:
  // With their defaults; graded = 0: half as many columns as elements per radius.
  inline static const std::map<std::string, double> known = {
      {"nf", 10},     {"graded", 0}, {"depth", 45},  {"fine", 1},      {"end", 1000}, {"double", 0},
      {"history", 0}, {"rates", 2},  {"threads", 1}, {"replicate", 0}, {"runs", 40}};
  std::map<std::string, double> values_;
};

Problem problem_of(const Options& option) {
  Problem p = setting_s(static_cast<int>(option("nf")));
  if (option("graded") > 0) p.graded_columns = static_cast<int>(option("graded"));
  p.depth = option("depth");
  p.fine_width = option("fine");
  p.end_time = option("end");
  p.rates = static_cast<int>(option("rates"));
  p.history_samples = static_cast<int>(option("history"));
  p.arithmetic = option("double") != 0 ? Arithmetic::double_precision : Arithmetic::single_precision;
  p.speed_factor = replicate_speed_factor(static_cast<int>(option("replicate")));
  return p;
}

// Of all threads of the process.
double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double largest_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

json measured_run(const Options& option) {
  const Problem p = problem_of(option);
  bench::start_sampling();
  const double memory_before = largest_memory(), cpu = cpu_seconds(), wall = wall_seconds();
  const ImpactResult result = run_impact(p, static_cast<int>(option("threads")));
  const auto samples = bench::stop_sampling();
  json line = {
      {"level", instruction_level()}, {"outcome", word(result.outcome)}, {"depth", result.depth},
      {"elements", result.elements},  {"steps", result.steps},           {"element_steps", result.element_steps},
      {"cpu_s", cpu_seconds() - cpu}, {"wall_s", wall_seconds() - wall}, {"bytes", largest_memory() - memory_before}};
  for (const auto& [phase, count] : samples) line["samples"][phase] = count;
  return line;
}

json measured_batch(const Options& option) {
  const int runs = static_cast<int>(option("runs")), threads = static_cast<int>(option("threads"));
  std::atomic<int> next{0};
  const double cpu = cpu_seconds(), wall = wall_seconds();
  const auto work = [&] {
    for (int k = next++; k < runs; k = next++) {
      Problem p = problem_of(option);
      p.speed_factor = replicate_speed_factor(k);
      run_impact(p);
    }
  };
  {
    std::vector<std::jthread> others;
    for (int k = 1; k < threads; ++k) others.emplace_back(work);
    work();
  }
  return {{"level", instruction_level()},
          {"runs", runs},
          {"threads", threads},
          {"cpu_s", cpu_seconds() - cpu},
          {"wall_s", wall_seconds() - wall}};
}

json measured_peak() {
  json line = {{"flops", bench::multiply_add_flops()}};
  for (const auto& [name, bytes] : bench::memory_sizes)
    line["triad"].push_back({{"level", name}, {"bytes", bytes}, {"bytes_per_s", bench::triad_bytes_per_second(bytes)}});
  return line;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "";
  json line;
  if (what == "run")
    line = measured_run({argc, argv});
  else if (what == "batch")
    line = measured_batch({argc, argv});
  else if (what == "peak")
    line = measured_peak();
  else {
    std::fprintf(stderr, "usage: impact_bench run|batch|peak [key=number]...\n");
    return 2;
  }
  std::printf("%s\n", line.dump().c_str());
}
