#include "percal/fit/search/compare_models.hpp"

#include <fmt/core.h>

#include <cmath>

#include "percal/base/error.hpp"
#include "percal/page/numbers.hpp"

namespace percal {
namespace {

struct Split {
  CurveData fitted, left_out;
};

Split without(const CurveData& data, const CurveTest& test) {
  Split split{{{}, data.sources}, {{}, data.sources}};
  for (const auto& point : data.points)
    (belongs(point, data, test) ? split.left_out : split.fitted).points.push_back(point);
  return split;
}

// The weights that the remaining tests have been given.
Weighting without(const Weighting& weighting, const std::vector<CurveTest>& tests, const CurveTest& left_out) {
  const auto* named = std::get_if<EqualTests>(&weighting);
  if (!named) return weighting;
  EqualTests kept;
  for (const auto& entry : named->of_test)
    for (const auto& test : tests)
      if (&test != &left_out && is_meant(entry.first, test)) {
        kept.of_test.push_back(entry);
        break;
      }
  return kept;
}

std::optional<double> finite(double number) { return std::isfinite(number) ? std::optional(number) : std::nullopt; }

LeftOutTest predicted(const std::string& name, const Hyperelastic& solid, const CurveData& measured) {
  double relative = 0, counted = 0, deviation = 0, stress = 0;
  for (const auto& point : measured.points) {
    const double error = std::abs(nominal_stress(solid, point.strained) - point.nominal_stress);
    deviation += error;
    stress += std::abs(point.nominal_stress);
    if (point.nominal_stress != 0) relative += error / std::abs(point.nominal_stress), ++counted;
  }
  return {name, finite(relative / counted), finite(deviation / stress)};
}

LeftOutTest leave_out(const CurveData& data, CurveOptions options, const std::vector<CurveTest>& tests,
                      const CurveTest& test) {
  const Split split = without(data, test);
  options.weighting = without(options.weighting, tests, test);
  try {
    const CurveFit fit = fit_curves(split.fitted, options);
    if (!fit.minima.empty()) return predicted(test.name, fit.minima[0].solid, split.left_out);
  } catch (const BadInput&) {  // too few points are left
  }
  return {test.name, {}, {}};
}

std::optional<double> mean_of(const std::vector<LeftOutTest>& tests, std::optional<double> LeftOutTest::*figure) {
  double sum = 0;
  for (const auto& test : tests) {
    if (!(test.*figure)) return std::nullopt;
    sum += *(test.*figure);
  }
  return tests.empty() ? std::nullopt : std::optional(sum / static_cast<double>(tests.size()));
}

constexpr double nothing = 1e-9;  // a term's modulus, of the sum

// A fit that the bound of the search made, or a term that stands for a point or two, says nothing of the model.
std::string not_ranked(const CurveFit& fit) {
  if (fit.minima.empty()) return "";
  const CurveMinimum& best = fit.minima[0];
  const double sum = small_strain_modulus(best.solid);
  for (const auto& [mu, alpha] : best.solid.terms) {
    const bool is_nothing = std::abs(mu)<nothing * sum, bound = std::abs(alpha)> largest_alpha * (1 - 1e-9);
    if (is_nothing || bound)
      return fmt::format("its term at alpha = {:.4g}{}{}", alpha, bound ? ", the bound of the search," : "",
                         is_nothing
                             ? " has a modulus of " + page::quantity(mu, dimension::pressure) + ", which is nothing"
                             : " is at no minimum");
  }
  return "";
}

ComparedModel compared(const CurveData& data, const CurveOptions& options) {
  ComparedModel result{options.model, {}, {}, {}, {}, {}};
  try {
    result.fit = fit_curves(data, options);
  } catch (const BadInput& error) {
    result.why_not = error.what();
    return result;
  }
  result.not_ranked = not_ranked(*result.fit);
  const auto& tests = result.fit->tests;
  if (tests.size() > 1)
    for (const auto& test : tests) result.left_out.push_back(leave_out(data, options, tests, test));
  result.mean_relative_deviation = mean_of(result.left_out, &LeftOutTest::mean_relative_deviation);
  result.relative_to_sum = mean_of(result.left_out, &LeftOutTest::relative_to_sum);
  return result;
}

}  // namespace

std::vector<ComparedModel> compare_models(const CurveData& data, const CurveOptions& options) {
  curve_problem(data, options.residual, options.weighting);  // what no model can use is refused
  std::vector<ComparedModel> all;
  for (const Model model : all_models) {
    CurveOptions one = options;
    one.model = model;
    all.push_back(compared(data, one));
  }
  return all;
}

}  // namespace percal
