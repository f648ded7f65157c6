// Measures curve fits for docs/verification/fit_speed.md and prints one JSON line: fit_bench.py makes the table. Not a test.
//
//   fit_bench            fits of 24, 100 and 1,000 points in one process, and their intervals: processor time, medians of many
//   fit_bench csv N      the N points themselves, as a CSV file that other programs fit too
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "percal/fit/interval/uncertainty.hpp"
#include "support/synthetic_curves.hpp"

namespace {

using namespace percal;
using nlohmann::json;

constexpr Ogden solid{.mu = 11640, .alpha = 9};
constexpr unsigned seed = 20090401;

CurveData curve_of(int points) {
  test::NormalNumbers normal(seed);
  return test::noisy_curve(solid, test::states({.points = points}), {.relative = 0.02}, normal);
}

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Median of the milliseconds of processor time of one call, the calls repeated for a second at most.
template <class Call>
double milliseconds_of(const Call& call) {
  std::vector<double> each;
  const double start = processor_seconds();
  while (each.size() < 201 && processor_seconds() - start < 1) {
    const double before = processor_seconds();
    call();
    each.push_back(1e3 * (processor_seconds() - before));
  }
  std::nth_element(each.begin(), each.begin() + static_cast<long>(each.size() / 2), each.end());
  return each[each.size() / 2];
}

json measured(int points) {
  const CurveData data = curve_of(points);
  const CurveFit fit = fit_ogden(data, Residual::relative);
  return {{"points", points},
          {"mu_Pa", fit.minima[0].solid.terms[0].mu},
          {"alpha", fit.minima[0].solid.terms[0].alpha},
          {"objective", fit.minima[0].objective},
          {"fit_ms", milliseconds_of([&] { fit_ogden(data, Residual::relative); })},
          {"intervals_ms", milliseconds_of([&] { uncertainty_of(data, fit, {}); })}};
}

void print_csv(int points) {
  std::printf("mode,stretch,stress_Pa\n");
  for (const auto& point : curve_of(points).points)
    std::printf("uniaxial,%.17g,%.17g\n", point.strained.amount, point.nominal_stress);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 3 && std::string(argv[1]) == "csv") {
    print_csv(std::atoi(argv[2]));
    return 0;
  }
  json sizes = json::array();
  for (const int points : {24, 100, 1000}) sizes.push_back(measured(points));
  std::printf("%s\n", sizes.dump().c_str());
  return 0;
}
