#include "percal/fit/interval/rulers.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "percal/page/numbers.hpp"

namespace percal {
namespace {

constexpr double most_of_it = 0.99;  // of the sum of squares
constexpr double few_points = 1 / 3.0;

// Of the points that make up most of the sum of squares, when the others are followed.
struct Rule {
  std::size_t count = 0, of = 0;
  double share = 0;
  double low = std::numeric_limits<double>::infinity(), high = -low;  // stretch, or shear
  double least = low, most = -low;                                    // stress, Pa
};

Rule rule_of(const CurveProblem& problem, const CurveData& data, const Hyperelastic& solid) {
  std::vector<double> squares;
  for (const auto& point : problem.points)
    squares.push_back(std::pow(point.weight * (point.stress - nominal_stress(solid, point.pair) / problem.scale), 2));
  std::vector<std::size_t> order(squares.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return squares[a] > squares[b]; });
  const double all = std::accumulate(squares.begin(), squares.end(), 0.0);
  std::vector<const StressPoint*> used;  // those of the problem, in its order
  for (const auto& point : data.points)
    if (!(problem.residual == Residual::relative && point.nominal_stress == 0) &&
        !(problem.residual == Residual::error && !(point.standard_error && *point.standard_error > 0)))
      used.push_back(&point);
  Rule rule{.of = order.size()};
  for (double sum = 0; rule.count < order.size() && sum < most_of_it * all; ++rule.count) {
    sum += squares[order[rule.count]];
    rule.share = sum / all;
    const StressPoint& point = *used[order[rule.count]];
    rule.low = std::min(rule.low, point.strained.amount), rule.high = std::max(rule.high, point.strained.amount);
    rule.least = std::min(rule.least, point.nominal_stress), rule.most = std::max(rule.most, point.nominal_stress);
  }
  return rule;
}

std::string result_of(const CurveMinimum& minimum) {
  std::string text = "mu " + page::quantity(small_strain_modulus(minimum.solid), dimension::pressure);
  if (minimum.solid.terms.size() == 1) text += fmt::format(", alpha {:.3g}", minimum.solid.terms[0].alpha);
  return text + fmt::format(", R^2 {:.3f}", minimum.r2.value_or(NAN));
}

}  // namespace

std::vector<std::string> rulers(const CurveData& data, const CurveFit& fit) {
  if (fit.minima.empty() || fit.minima[0].r2.value_or(1) >= poor_fit) return {};
  std::string sentence = fmt::format("R^2 is {:.2g}: the fit misses the curve.", *fit.minima[0].r2);
  CurveOptions options = fit.options;
  options.residual = Residual::absolute;
  const CurveFit absolute = fit.options.residual == Residual::absolute ? fit : fit_curves(data, options);
  if (absolute.minima.empty()) return {sentence};
  const CurveProblem problem = curve_problem(data, fit.options.residual, fit.options.weighting);
  const Rule rule = rule_of(problem, data, absolute.minima[0].solid);
  if (static_cast<double>(rule.count) <= few_points * static_cast<double>(rule.of))
    sentence += fmt::format(
        " {} of {} points rule{} it, at stretches {:.4g} to {:.4g} with stresses {} to {}: with {} residuals "
        "{:.3g} % of the sum of squares is theirs where the others are followed.",
        rule.count, rule.of, rule.count == 1 ? "s" : "", rule.low, rule.high,
        page::quantity(rule.least, dimension::pressure), page::quantity(rule.most, dimension::pressure),
        word(fit.options.residual), 100 * rule.share);
  if (fit.options.residual != Residual::absolute && absolute.minima[0].r2.value_or(0) > *fit.minima[0].r2)
    sentence +=
        " --residual absolute gives " + result_of(absolute.minima[0]) + "; or leave such points out with --where.";
  return {sentence};
}

}  // namespace percal
