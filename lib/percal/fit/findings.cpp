// What a reader must know beside the numbers of a fit.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "percal/fit/fit_curves.hpp"

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
    sentences.push_back(fmt::format("{} term(s) of {} vanish: no positive modulus of theirs makes the fit better.",
                                    asked - terms, asked));
  for (int k = 0; k + 1 < terms; ++k) {
    const auto &a = best.solid.terms[k], &b = best.solid.terms[k + 1];
    if (a.alpha - b.alpha < almost_one && a.mu * b.mu < 0)
      sentences.push_back(fmt::format(
          "The terms of alpha = {:.4g} and {:.4g} nearly cancel: only their difference is known, not their moduli.",
          a.alpha, b.alpha));
  }
}

}  // namespace

std::vector<std::string> findings(const CurveFit& fit) {
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

}  // namespace percal
