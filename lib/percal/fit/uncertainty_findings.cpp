#include "percal/fit/uncertainty_findings.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "percal/math/distributions.hpp"

namespace percal {
namespace {

constexpr double surely = 0.01;  // chance below which residuals and standard errors contradict each other
constexpr double alike = 2.5;    // standard deviations of a correlation of independent residuals

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void add(double amount) { low = std::min(low, amount), high = std::max(high, amount); }
};

// Several minima are told apart by their alpha.
std::string at_minimum(const MinimumUncertainty& about, const Uncertainty& uncertainty, const CurveFit& fit) {
  if (uncertainty.minima.size() < 2) return "";
  const auto& terms = fit.minima[static_cast<std::size_t>(about.minimum)].solid.terms;
  return fmt::format(" About the minimum at alpha = {:.4g}.", terms[0].alpha);
}

void standard_errors(const Uncertainty& uncertainty, const CurveFit& fit, std::vector<std::string>& sentences) {
  if (fit.options.residual != Residual::error) return;
  const double chi_squared = uncertainty.scatter * uncertainty.scatter * uncertainty.degrees_of_freedom;
  const double chance_of_more = chi_squared_tail(chi_squared, uncertainty.degrees_of_freedom);
  if (uncertainty.errors == ErrorSource::residuals)
    sentences.push_back(
        fmt::format("The residuals are {:.3g} times as large as the standard errors say, so the intervals are made "
                    "from the residuals.",
                    uncertainty.scatter));
  else if (chance_of_more > 1 - surely)
    sentences.push_back(
        fmt::format("The residuals are only {:.2g} of what the standard errors say: the errors of neighbouring points "
                    "cannot be independent, and the intervals, which take them as independent, may be too narrow.",
                    uncertainty.scatter));
}

void systematic_misfit(const Uncertainty& uncertainty, int points, std::vector<std::string>& sentences) {
  const auto& correlation = uncertainty.neighbour_correlation;
  if (!correlation || *correlation < alike / std::sqrt(points)) return;
  sentences.push_back(
      fmt::format("Neighbouring residuals are alike (correlation {:.2f}): the misfit is systematic, not noise, and the "
                  "intervals, which take the errors as independent, are too narrow.",
                  *correlation));
}

}  // namespace

std::string range_of(const CurveData& data) {
  Range stretch, shear;
  for (const auto& point : data.points) {
    const auto& strained = point.strained;
    (strained.deformation == Deformation::simple_shear ? shear : stretch).add(strained.amount);
    if (strained.deformation == Deformation::biaxial) stretch.add(strained.across);
  }
  std::string text;
  if (stretch.low <= stretch.high) text = fmt::format("The stretch range {:.4g} to {:.4g}", stretch.low, stretch.high);
  if (shear.low <= shear.high)
    text += fmt::format("{} shear range {:.4g} to {:.4g}", text.empty() ? "The" : " with the", shear.low, shear.high);
  return text;
}

std::string undetermined(const ParameterUncertainty& parameter, const std::string& range, double level) {
  const auto& [low, high, low_open, high_open] = parameter.interval;
  const bool from_end = low_open && low == parameter.searched_low,
             to_end = high_open && high == parameter.searched_high;
  const std::string interval = fmt::format("its {:g} % interval", 100 * level);
  const std::string unit = parameter.unit.empty() ? "" : " " + parameter.unit;
  if (from_end && to_end)
    return fmt::format("{} does not determine {}: {} reaches both ends of the search, {:.4g} and {:.4g}{}.", range,
                       parameter.name, interval, low, high, unit);
  if (from_end || to_end)
    return fmt::format("{} does not determine {}: {} goes from {}{:.4g} to {}{:.4g}{}.", range, parameter.name,
                       interval, from_end ? "the end of the search at " : "", low,
                       to_end ? "the end of the search at " : "", high, unit);
  if (!parameter.identifiable)
    return fmt::format("{} hardly determines {}: {} goes from {:.4g} to {:.4g}{}.", range, parameter.name, interval,
                       low, high, unit);
  if (low_open || high_open)
    return fmt::format("{}'s interval ends at {:.4g}{} only because the search of another parameter ends there.",
                       parameter.name, low_open ? low : high, unit);
  return "";
}

std::vector<std::string> uncertainty_findings(const Uncertainty& uncertainty, const CurveData& data,
                                              const CurveProblem& problem, const CurveFit& fit) {
  std::vector<std::string> sentences;
  const std::string range = range_of(data);
  for (const auto& about : uncertainty.minima)
    for (const auto& parameter : about.parameters) {
      const std::string sentence = undetermined(parameter, range, uncertainty.options.level);
      if (!sentence.empty()) sentences.push_back(sentence + at_minimum(about, uncertainty, fit));
    }
  if (even_in_alpha(problem) && !uncertainty.minima.empty())
    sentences.push_back(
        "Planar tension and simple shear are even in alpha: each interval of alpha holds for its own sign.");
  standard_errors(uncertainty, fit, sentences);
  systematic_misfit(uncertainty, static_cast<int>(problem.points.size()), sentences);
  return sentences;
}

}  // namespace percal
