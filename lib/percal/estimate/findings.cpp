#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "percal/estimate/frozen_fit.hpp"
#include "percal/estimate/intervals.hpp"
#include "percal/math/distributions.hpp"

namespace percal {
namespace {

using Eigen::VectorXd;
using Sentences = std::vector<std::string>;

constexpr double negligible = 0.05;  // component of a combination, of its largest

std::string quantity(const FreeParameter& free, double natural) {
  if (free.unit.empty()) return fmt::format("{:.3g}", natural);
  if (free.unit == "m") {
    const bool small = natural < 1e-4;
    return fmt::format("{:.3g} {}", natural * (small ? 1e6 : 1e3), small ? "um" : "mm");
  }
  if (free.unit != "Pa") return fmt::format("{:.3g} {}", natural, free.unit);
  return natural >= 1e6 ? fmt::format("{:.3g} MPa", natural / 1e6) : fmt::format("{:.3g} kPa", natural / 1e3);
}

std::string reach(const FreeParameter& free, const Interval& interval) {
  if (interval.low == free.low && interval.high == free.high) return "reaches both bounds";
  if (interval.low_open && interval.high_open) return "ends only where bounds cut it off";
  if (interval.low_open) return "is cut off by a bound below";
  if (interval.high_open) return "is cut off by a bound above";
  return fmt::format("spans a factor of {:.2g}", interval.high / interval.low);
}

void add_unidentifiable(const CalibrationProblem& problem, const std::vector<ProfileInterval>& intervals,
                        Sentences& sentences) {
  for (const ProfileInterval& one : intervals) {
    const FreeParameter& free = problem.parameters[one.parameter];
    const Interval& interval = one.interval;
    if (!one.identifiable)
      sentences.push_back(fmt::format("{} cannot be known from these data: its {:g} % interval, {} to {}, {}.",
                                      free.name, 100 * one.level, quantity(free, interval.low),
                                      quantity(free, interval.high), reach(free, interval)));
    else if (interval.low_open || interval.high_open)
      sentences.push_back(
          fmt::format("The data set no {} limit to {}: its {:g} % interval ends at {} because a bound is met there.",
                      interval.low_open ? "lower" : "upper", free.name, 100 * one.level,
                      quantity(free, interval.low_open ? interval.low : interval.high)));
  }
}

// Of a parameter whose region lies in pieces.
void add_pieces(const CalibrationProblem& problem, const std::vector<ProfileInterval>& intervals,
                Sentences& sentences) {
  for (const ProfileInterval& one : intervals) {
    if (one.region.size() < 2) continue;
    const FreeParameter& free = problem.parameters[one.parameter];
    sentences.push_back(fmt::format(
        "The data do not choose between {} minima: {} is {} ({:g} % interval).", one.region.size(), free.name,
        words_of(one.region, [&](double value) { return quantity(free, value); }), 100 * one.level));
  }
}

// How far a parameter goes where the combination's weight is w: "mu rises by 10 %", "alpha falls by 1.2".
std::string movement(const FreeParameter& free, double change) {
  const std::string verb = change > 0 ? "rises" : "falls";
  if (free.logarithmic) return fmt::format("{} {} by {:.2g} %", free.name, verb, 100 * std::abs(std::expm1(change)));
  return fmt::format("{} {} by {:.2g}", free.name, verb, std::abs(change));
}

std::vector<int> large_components(const VectorXd& weight) {
  std::vector<int> large;
  for (int k = 0; k < weight.size(); ++k)
    if (std::abs(weight[k]) >= negligible * weight.cwiseAbs().maxCoeff()) large.push_back(k);
  std::ranges::stable_sort(large, std::greater{}, [&](int k) { return std::abs(weight[k]); });
  return large;
}

// The parameters that move together while the fit stays as good: scaled so that the first of them changes by a tenth.
void add_ridge(const CalibrationProblem& problem, const Combination& free_direction, Sentences& sentences) {
  const auto moving = large_components(free_direction.weight);
  if (moving.size() < 2) return;
  const double scale = std::log(1.1) / free_direction.weight[moving[0]];
  std::string list;
  for (std::size_t i = 0; i < moving.size(); ++i)
    list += (i == 0   ? ""
             : i == 1 ? " where "
                      : " and ") +
            movement(problem.parameters[moving[i]], scale * free_direction.weight[moving[i]]);
  sentences.push_back(fmt::format("Near the best fit, the objective stays as low along a ridge: {}.", list));
}

// "mu * erosion_strain^0.8", or "ln mu - 0.3 alpha" where one of them is not logarithmic; the largest weight is 1.
std::string formula(const CalibrationProblem& problem, const VectorXd& weight, const std::vector<int>& members) {
  const bool product = std::ranges::all_of(members, [&](int k) { return problem.parameters[k].logarithmic; });
  std::string text;
  for (const int k : members) {
    const FreeParameter& free = problem.parameters[k];
    const double share = weight[k] / weight[members[0]];
    const std::string number = fmt::format("{:.2g}", std::abs(share));
    if (product) {
      text += text.empty() ? "" : share > 0 ? " * " : " / ";
      text += free.name + (number == "1" ? "" : "^" + number);
    } else {
      text += text.empty() ? "" : share > 0 ? " + " : " - ";
      text += (number == "1" ? "" : number + " ") + (free.logarithmic ? "ln " : "") + free.name;
    }
  }
  return text;
}

void add_determined(const CalibrationProblem& problem, const Combination& combination, double t, Sentences& sentences) {
  const auto members = large_components(combination.weight);
  if (members.size() < 2) return;
  const double deviation = t * combination.standard_deviation / std::abs(combination.weight[members[0]]);
  const bool product = std::ranges::all_of(members, [&](int k) { return problem.parameters[k].logarithmic; });
  sentences.push_back(fmt::format("What the data do determine: {}, to within {:.2g}{}.",
                                  formula(problem, combination.weight, members),
                                  product ? 100 * std::expm1(deviation) : deviation, product ? " %" : ""));
}

void add_combinations(const CalibrationProblem& problem, const Minimum& best,
                      const std::vector<ProfileInterval>& intervals, Sentences& sentences) {
  const auto found = combinations(problem, best);
  const bool any_free = std::ranges::any_of(found, [](const Combination& one) { return !one.determined; });
  const bool any_unknown = std::ranges::any_of(intervals, [](const auto& one) { return !one.identifiable; });
  if (!any_free || !any_unknown) return;
  for (const Combination& one : found)
    if (!one.determined) add_ridge(problem, one, sentences);
  const double level = intervals[0].level;
  for (const Combination& one : found)
    if (one.determined)
      add_determined(problem, one, student_quantile((1 + level) / 2, intervals[0].degrees_of_freedom), sentences);
}

void add_bounds(const CalibrationProblem& problem, const Minimum& best, Sentences& sentences) {
  for (int k = 0; k < static_cast<int>(problem.parameters.size()); ++k) {
    if (!best.at_bound[k]) continue;
    const FreeParameter& free = problem.parameters[k];
    const bool low = at_bound(problem, best.searched, k) == AtBound::low;
    sentences.push_back(fmt::format("The best fit has {} at its {} bound, {}: a better one may lie beyond.", free.name,
                                    low ? "lower" : "upper", quantity(free, low ? free.low : free.high)));
  }
}

// Minima whose likelihood ratio to the best one a test at 95 % would let pass.
void add_rivals(const CalibrationProblem& problem, const std::vector<Minimum>& minima, Sentences& sentences) {
  const double threshold = chi_squared_quantile(0.95, 1);
  for (std::size_t i = 1; i < minima.size(); ++i) {
    const double more = minima[i].deviance - minima[0].deviance;
    if (!minima[i].converged || more > threshold) continue;
    std::string list;
    for (int k = 0; k < static_cast<int>(problem.parameters.size()); ++k) {
      const FreeParameter& free = problem.parameters[k];
      list +=
          fmt::format("{}{} = {}", k == 0 ? "" : ", ", free.name, quantity(free, free.natural(minima[i].searched[k])));
    }
    sentences.push_back(
        fmt::format("A second minimum fits about as well (-2 ln likelihood is {:.2g} more): {}.", more, list));
  }
}

// Of data of a group that tell sides, no one on the wrong side.
bool all_sides_met(const CalibrationProblem& problem, const Minimum& best, int group) {
  bool any = false;
  for (std::size_t i = 0; i < problem.data.size(); ++i) {
    if (problem.data[i].group != group || problem.data[i].is_number()) continue;
    if (best.residual[static_cast<Eigen::Index>(i)] != 0) return false;
    any = true;
  }
  return any;
}

// A group of which one datum each is fitted exactly says nothing of its scatter.
void add_unknown_scatter(const CalibrationProblem& problem, const Minimum& best, Sentences& sentences) {
  for (int g = 0; g < static_cast<int>(problem.groups.size()); ++g) {
    if (!problem.groups[g].estimated) continue;
    const auto of_group = [g](const Datum& datum) { return datum.group == g; };
    const auto count =
        std::ranges::count_if(problem.data, [&](const Datum& d) { return of_group(d) && d.is_number(); });
    if (count == 0 && all_sides_met(problem, best, g))
      sentences.push_back(fmt::format(
          "In {} nothing went one way that a more severe one did not: how far they scatter is told by the gap between "
          "them alone, and {:.2g} was taken.",
          problem.groups[g].name, best.scatter[g]));
    if (count != 1) continue;
    sentences.push_back(
        fmt::format("The scatter of {} cannot be estimated from one datum; {} was taken, beside the datum's own error.",
                    problem.groups[g].name, best.scatter[g] > 0 ? fmt::format("{:.2g}", best.scatter[g]) : "none"));
  }
}

}  // namespace

std::vector<std::string> findings(const CalibrationProblem& problem, const std::vector<Minimum>& minima,
                                  const std::vector<ProfileInterval>& intervals) {
  Sentences sentences;
  if (minima.empty()) return sentences;
  const Minimum& best = minima[0];
  if (!best.converged) sentences.push_back("The search did not converge: the numbers below are where it stopped.");
  add_pieces(problem, intervals, sentences);
  add_unidentifiable(problem, intervals, sentences);
  add_combinations(problem, best, intervals, sentences);
  add_bounds(problem, best, sentences);
  add_rivals(problem, minima, sentences);
  add_unknown_scatter(problem, best, sentences);
  return sentences;
}

}  // namespace percal
