#include "percal/fit/interval/findings.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "percal/math/distributions.hpp"
#include "percal/page/numbers.hpp"

namespace percal {
namespace {

constexpr double equal = 1e-6;         // relative difference of two objectives that no data can mean
constexpr double almost_equal = 0.05;  // below the scatter of digitised curves
constexpr double almost_one = 0.25;    // alphas closer than the grid of the search

double alpha_of(const CurveMinimum& minimum) { return minimum.solid.terms[0].alpha; }

const CurveMinimum* best_of_other_sign(const CurveFit& fit) {
  const bool negative = alpha_of(fit.minima[0]) < 0;
  for (const auto& minimum : fit.minima)
    if ((alpha_of(minimum) < 0) != negative) return &minimum;
  return nullptr;
}

void sign_of_alpha(const CurveFit& fit, std::vector<std::string>& sentences) {
  const auto& best = fit.minima[0];
  const double alpha = alpha_of(best);
  const CurveMinimum* other = best_of_other_sign(fit);
  const std::string sign = alpha < 0 ? "negative" : "positive", other_sign = alpha < 0 ? "positive" : "negative";
  if (other && other->above_best && *other->above_best < equal) {
    sentences.push_back(
        fmt::format("alpha = {:.4g} and alpha = {:.4g} fit equally well: these points do not tell the sign{}.", alpha,
                    alpha_of(*other),
                    std::abs(alpha + alpha_of(*other)) < 1e-3 * std::abs(alpha)
                        ? " (planar tension and simple shear are even in alpha)"
                        : ""));
    return;
  }
  if (alpha < 0 || (other && other->above_best && *other->above_best < almost_equal)) {
    std::string text = fmt::format("The best minimum has a {} alpha ({:.4g}).", sign, alpha);
    if (!other) text += fmt::format(" There is no minimum with a {} alpha.", other_sign);
    if (other && other->above_best)
      text += fmt::format(" The best with a {} alpha ({:.4g}) has an objective {:.3g} % larger{}.", other_sign,
                          alpha_of(*other), 100 * *other->above_best,
                          *other->above_best < almost_equal ? ": the points hardly decide between the two" : "");
    sentences.push_back(text);
  }
}

double alpha_at_bound(const CurveMinimum& minimum) {
  double largest = 0;
  for (const auto& term : minimum.solid.terms)
    if (std::abs(term.alpha) > std::abs(largest)) largest = term.alpha;
  return largest;
}

void one_term(const CurveFit& fit, std::vector<std::string>& sentences) {
  const auto& best = fit.minima[0];
  sign_of_alpha(fit, sentences);
  const auto error = best.errors[0].alpha;
  if (!best.at_bound && error && std::abs(alpha_of(best)) < 2 * *error)
    sentences.push_back(
        fmt::format("alpha = {:.3g} is within two standard errors of 0: its sign is open.", alpha_of(best)));
}

void several_terms(const CurveFit& fit, std::vector<std::string>& sentences) {
  const auto& best = fit.minima[0];
  const int terms = static_cast<int>(best.solid.terms.size()), asked = terms_of(fit.options.model);
  if (terms < asked)
    sentences.push_back(
        fmt::format("{} term(s) of {} vanish: they make the fit no better than chance does.", asked - terms, asked));
  for (int k = 0; k + 1 < terms; ++k) {
    const auto &a = best.solid.terms[k], &b = best.solid.terms[k + 1];
    if (a.alpha - b.alpha < almost_one && a.mu * b.mu < 0)
      sentences.push_back(fmt::format(
          "The terms of alpha = {:.4g} and {:.4g} nearly cancel: only their difference is known, not their moduli.",
          a.alpha, b.alpha));
  }
}

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

// Why moduli of any sign make no solid: "mu_1 + mu_2 = 818 kPa - 1.5 MPa".
std::string negative_sum(const CurveFit& fit) {
  const bool mooney = fit.options.model == Model::mooney_rivlin;
  std::string names, moduli;
  for (std::size_t k = 0; k < fit.refused->terms.size(); ++k) {
    const auto& [mu, alpha] = fit.refused->terms[k];
    names += std::string(k == 0 ? "" : " + ") + (mooney ? alpha > 0 ? "C10" : "C01" : fmt::format("mu_{}", k + 1));
    moduli += (k == 0   ? ""
               : mu < 0 ? " - "
                        : " + ") +
              page::quantity((k == 0 ? mu : std::abs(mu)) / (mooney ? 2 : 1), dimension::pressure);
  }
  return fmt::format(
      "The best fit with moduli of any sign has a negative sum of them, {} = {}: that is no solid. With every "
      "modulus held positive (without --unconstrained) there may be one.",
      names, moduli);
}

}  // namespace

std::vector<std::string> findings(const CurveFit& fit) {
  if (fit.minima.empty() && fit.refused) return {negative_sum(fit)};
  if (fit.minima.empty())
    return {
        "No positive modulus fits at any alpha: the stresses have the wrong sign for the stretches, or sizes too far "
        "apart."};
  std::vector<std::string> sentences;
  const auto& best = fit.minima[0];
  const bool free = fixed_alphas(fit.options.model).empty();
  if (fit.options.model == Model::ogden)
    one_term(fit, sentences);
  else
    several_terms(fit, sentences);
  if (best.at_bound)
    sentences.push_back(
        fmt::format("alpha = {:.4g} is at the bound of the search (|alpha| <= {:.4g}): no standard errors.",
                    alpha_at_bound(best), largest_alpha));
  else if (free && !best.errors[0].alpha && fit.options.loss == Loss::squares &&
           static_cast<int>(best.solid.terms.size()) == terms_of(fit.options.model))
    sentences.push_back(terms_of(fit.options.model) == 1
                            ? "These points do not determine mu and alpha together: no standard errors."
                            : "These points do not determine all moduli and exponents together: no standard errors.");
  if (!best.converged) sentences.push_back("The best minimum did not converge within the iterations allowed.");
  return sentences;
}

std::string systematic_misfit(const std::optional<double>& neighbour_correlation, std::size_t points) {
  if (!neighbour_correlation || *neighbour_correlation < alike / std::sqrt(static_cast<double>(points))) return "";
  return fmt::format(
      "Neighbouring residuals are alike (correlation {:.2f}): the misfit is systematic, not noise, and the "
      "intervals, which take the errors as independent, are too narrow.",
      *neighbour_correlation);
}

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
  const auto shown = [&](double value) {
    return page::quantity(value, parameter.unit.empty()  ? dimension::none
                                 : parameter.unit == "s" ? dimension::time
                                                         : dimension::pressure);
  };
  const std::string end = "the end of the search at ";
  if (from_end && to_end)
    return fmt::format("{} does not determine {}: {} reaches both ends of the search, {} and {}.", range,
                       parameter.name, interval, shown(low), shown(high));
  if (from_end || to_end)
    return fmt::format("{} does not determine {}: {} goes from {}{} to {}{}.", range, parameter.name, interval,
                       from_end ? end : "", shown(low), to_end ? end : "", shown(high));
  if (!parameter.identifiable)
    return fmt::format("{} hardly determines {}: {} goes from {} to {}.", range, parameter.name, interval, shown(low),
                       shown(high));
  if (low_open || high_open)
    return fmt::format("{}'s interval ends at {} only because the search of another parameter ends there.",
                       parameter.name, shown(low_open ? low : high));
  return "";
}

// Minima that fit about as well, and what of each parameter they leave.
void several_pieces(const Uncertainty& uncertainty, std::vector<std::string>& sentences) {
  std::string pieces;
  for (const ParameterRegion& region : uncertainty.region) {
    if (region.pieces.size() < 2) continue;
    const auto& unit = region.unit.empty() ? dimension::none : dimension::pressure;
    pieces += (pieces.empty() ? "" : "; ") + region.name + " " +
              words_of(region.pieces, [&](double value) { return page::quantity(value, unit); });
  }
  if (pieces.empty()) return;
  sentences.push_back(fmt::format("The data do not choose between {} minima: the {:g} % interval is {}.",
                                  uncertainty.minima.size(), 100 * uncertainty.options.level, pieces));
}

std::vector<std::string> uncertainty_findings(const Uncertainty& uncertainty, const CurveData& data,
                                              const CurveProblem& problem, const CurveFit& fit) {
  std::vector<std::string> sentences;
  const std::string range = range_of(data);
  if (!even_in_alpha(problem)) several_pieces(uncertainty, sentences);
  for (const auto& about : uncertainty.minima)
    for (const auto& parameter : about.parameters) {
      const std::string sentence = undetermined(parameter, range, uncertainty.options.level);
      if (!sentence.empty()) sentences.push_back(sentence + at_minimum(about, uncertainty, fit));
    }
  if (even_in_alpha(problem) && !uncertainty.minima.empty())
    sentences.push_back(
        "Planar tension and simple shear are even in alpha: each interval of alpha holds for its own sign.");
  standard_errors(uncertainty, fit, sentences);
  if (const auto misfit = systematic_misfit(uncertainty.neighbour_correlation, problem.points.size()); !misfit.empty())
    sentences.push_back(misfit);
  return sentences;
}

}  // namespace percal
