#include "percal/fit/shape/curve_branches.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace percal {
namespace {

constexpr double jump = 0.5;      // of the largest strain, back in one row: a new curve begins
constexpr double at_rest = 0.1;   // of the strain that a curve has reached, after one row: likewise
constexpr double relaxed = 0.05;  // of the largest stress, lost while the stretch is held

double mean_stress(const Followed& test, std::size_t from, std::size_t to) {
  double sum = 0;
  for (std::size_t i = from; i <= to; ++i) sum += test.points[i].stress;
  return sum / static_cast<double>(to - from + 1);
}

}  // namespace

std::vector<Followed> followed(const std::vector<StressPoint>& points, std::size_t fewest) {
  std::map<std::pair<Deformation, bool>, Followed> tests;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& [deformation, amount, across] = points[i].strained;
    if (deformation == Deformation::biaxial) continue;
    const bool shear = deformation == Deformation::simple_shear, back = amount < (shear ? 0 : 1);
    Followed& test = tests[{deformation, back}];
    test.name = word(deformation) + (shear ? "" : back ? " compression" : " tension");
    test.points.push_back({std::abs(amount - (shear ? 0 : 1)), (back ? -1 : 1) * points[i].nominal_stress, i});
    test.longest = std::max(test.longest, test.points.back().strain);
    test.largest = std::max(test.largest, std::abs(test.points.back().stress));
  }
  std::vector<Followed> all;
  for (auto& [key, test] : tests)
    if (test.points.size() >= fewest) all.push_back(std::move(test));
  return all;
}

std::vector<Branch> branches_of(const Followed& test) {
  std::vector<Branch> found;
  bool up = true, anew = false;
  std::size_t begin = 0, extreme = 0;
  const auto close = [&] {
    if (extreme > begin) found.push_back({begin, extreme, up, anew});
    anew = anew && extreme <= begin;
    begin = extreme;
  };
  for (std::size_t i = 1; i < test.points.size(); ++i) {
    const double step = (up ? 1 : -1) * (test.points[i].strain - test.points[extreme].strain);
    if (step >= 0) extreme = i;
    if (step > -turning * test.longest) continue;
    const bool restart = up && i == extreme + 1 &&
                         (-step > jump * test.longest || test.points[i].strain < at_rest * test.points[extreme].strain);
    close();
    if (restart)
      begin = i, anew = true;
    else
      up = !up;
    extreme = i;
  }
  close();
  return found;
}

std::vector<HeldRows> holds_of(const Followed& test) {
  std::vector<HeldRows> holds;
  for (std::size_t i = 0; i < test.points.size();) {
    std::size_t end = i;
    while (end + 1 < test.points.size() &&
           std::abs(test.points[end + 1].strain - test.points[i].strain) <= standing * test.longest)
      ++end;
    if (end >= i + 3 && test.points[i].stress - test.points[end].stress > relaxed * test.largest &&
        test.points[i].stress > 0)
      holds.push_back({i, end});
    i = end + 1;
  }
  return holds;
}

Top top_of(const Followed& test, std::size_t begin, std::size_t end) {
  const std::size_t n = end - begin + 1, few = std::max<std::size_t>(1, n / 50);
  const auto first = test.points.begin() + static_cast<std::ptrdiff_t>(begin);
  const auto at = begin + static_cast<std::size_t>(
                              std::max_element(first, first + static_cast<std::ptrdiff_t>(n),
                                               [](const Met& a, const Met& b) { return a.stress < b.stress; }) -
                              first);
  const double highest = mean_stress(test, at - std::min(at - begin, few), std::min(at + few, end)),
               last = mean_stress(test, end - std::min(end - begin, few), end);
  return {at, at == end ? 1 : last / highest};
}

}  // namespace percal
