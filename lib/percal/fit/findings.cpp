// What a reader must know beside the numbers of a fit.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "percal/fit/fit_ogden.hpp"

namespace percal {
namespace {

constexpr double equal = 1e-6;         // relative difference of two objectives that no data can mean
constexpr double almost_equal = 0.05;  // below the scatter of digitised curves

const OgdenMinimum* best_of_other_sign(const OgdenFit& fit) {
  const bool negative = fit.minima[0].solid.alpha < 0;
  for (const auto& minimum : fit.minima)
    if ((minimum.solid.alpha < 0) != negative) return &minimum;
  return nullptr;
}

void sign_of_alpha(const OgdenFit& fit, std::vector<std::string>& sentences) {
  const auto& best = fit.minima[0];
  const double alpha = best.solid.alpha;
  const OgdenMinimum* other = best_of_other_sign(fit);
  const std::string sign = alpha < 0 ? "negative" : "positive", other_sign = alpha < 0 ? "positive" : "negative";
  if (other && other->above_best && *other->above_best < equal) {
    sentences.push_back(
        fmt::format("alpha = {:.4g} and alpha = {:.4g} fit equally well: these points do not tell the sign{}.", alpha,
                    other->solid.alpha,
                    std::abs(alpha + other->solid.alpha) < 1e-3 * std::abs(alpha)
                        ? " (planar tension and simple shear are even in alpha)"
                        : ""));
    return;
  }
  if (alpha < 0 || (other && other->above_best && *other->above_best < almost_equal)) {
    std::string text = fmt::format("The best minimum has a {} alpha ({:.4g}).", sign, alpha);
    if (!other) text += fmt::format(" There is no minimum with a {} alpha.", other_sign);
    if (other && other->above_best)
      text += fmt::format(" The best with a {} alpha ({:.4g}) has an objective {:.3g} % larger{}.", other_sign,
                          other->solid.alpha, 100 * *other->above_best,
                          *other->above_best < almost_equal ? ": the points hardly decide between the two" : "");
    sentences.push_back(text);
  }
}

}  // namespace

std::vector<std::string> findings(const OgdenFit& fit) {
  if (fit.minima.empty())
    return {
        "No positive modulus fits at any alpha: the stresses have the wrong sign for the stretches, or sizes too far "
        "apart."};
  std::vector<std::string> sentences;
  const auto& best = fit.minima[0];
  sign_of_alpha(fit, sentences);
  if (best.at_bound)
    sentences.push_back(
        fmt::format("alpha = {:.4g} is at the bound of the search (|alpha| <= {:.4g}): no standard errors.",
                    best.solid.alpha, largest_alpha));
  else if (!best.alpha_standard_error)
    sentences.push_back("These points do not determine mu and alpha together: no standard errors.");
  else if (std::abs(best.solid.alpha) < 2 * *best.alpha_standard_error)
    sentences.push_back(
        fmt::format("alpha = {:.3g} is within two standard errors of 0: its sign is open.", best.solid.alpha));
  if (!best.converged) sentences.push_back("The best minimum did not converge within the iterations allowed.");
  return sentences;
}

}  // namespace percal
