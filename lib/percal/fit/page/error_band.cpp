// The solid of a curve fit, its covariance, the band of its curve.                             docs/theory/curves.md
#include <cmath>

#include "percal/fit/page/sections.hpp"
#include "percal/math/distributions.hpp"

namespace percal::page_of_fit {
namespace {

// Standard errors of mu_1, .., mu_K and of the fitted exponents; empty where one is missing.
Eigen::VectorXd standard_errors(const Json& terms, bool free_alphas) {
  const auto count = static_cast<Eigen::Index>(terms.size());
  Eigen::VectorXd errors(free_alphas ? 2 * count : count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Json& term = terms[static_cast<std::size_t>(k)];
    const auto mu = number(term, "mu_standard_error_Pa"), alpha = number(term, "alpha_standard_error");
    if (!mu || (free_alphas && !alpha)) return {};
    errors[k] = *mu;
    if (free_alphas) errors[count + k] = *alpha;
  }
  return errors;
}

// Of the same parameters: one term's own number, several terms' matrix of the intervals.
Eigen::MatrixXd correlations(const Json& result, const Json& minimum, Eigen::Index size) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(size, size);
  if (size == 1) return matrix;
  if (const auto both = number(minimum, "correlation"); both && size == 2) {
    matrix(0, 1) = matrix(1, 0) = *both;
    return matrix;
  }
  const Json& about = list(at(result, "uncertainty"), "minima");
  const Json& rows = about.empty() ? about : list(about[0], "correlation");
  if (static_cast<Eigen::Index>(rows.size()) != size) return {};
  for (Eigen::Index i = 0; i < size; ++i) {
    const auto row = numbers(rows[static_cast<std::size_t>(i)]);
    if (static_cast<Eigen::Index>(row.size()) != size) return {};
    for (Eigen::Index j = 0; j < size; ++j) matrix(i, j) = row[static_cast<std::size_t>(j)];
  }
  return matrix.allFinite() ? matrix : Eigen::MatrixXd{};
}

}  // namespace

Hyperelastic solid_of(const Json& minimum) {
  Hyperelastic solid;
  for (const Json& term : list(minimum, "terms"))
    solid.terms.push_back({number_or(term, "mu_Pa", 0), number_or(term, "alpha", 2)});
  return solid;
}

std::optional<CurveErrors> curve_errors(const Json& result) {
  const Json& minima = list(result, "minima");
  const auto model = model_of(text(result, "model"));
  if (minima.empty() || !model || list(minima[0], "terms").empty()) return std::nullopt;
  CurveErrors errors;
  errors.free_alphas = fixed_alphas(*model).empty();
  const Eigen::VectorXd sizes = standard_errors(list(minima[0], "terms"), errors.free_alphas);
  if (sizes.size() == 0) return std::nullopt;
  const Eigen::MatrixXd correlation = correlations(result, minima[0], sizes.size());
  if (correlation.size() == 0) return std::nullopt;
  errors.covariance = sizes.asDiagonal() * correlation * sizes.asDiagonal();
  const Json& uncertainty = at(result, "uncertainty");
  errors.level = number_or(uncertainty, "level", 0.95);
  const double freedom =
      number_or(uncertainty, "degrees_of_freedom", number_or(result, "points", 0) - static_cast<double>(sizes.size()));
  if (!(freedom > 0)) return std::nullopt;
  errors.student = student_quantile((1 + errors.level) / 2, freedom);
  return errors;
}

double half_width(const Hyperelastic& solid, const CurveErrors& errors, const Strained& strained) {
  const auto count = static_cast<Eigen::Index>(solid.terms.size());
  const PrincipalPair pair = principal_pair(strained);
  Eigen::VectorXd slope(errors.covariance.rows());
  for (Eigen::Index k = 0; k < count; ++k) {
    const Ogden& term = solid.terms[static_cast<std::size_t>(k)];
    const UnitTerm unit = unit_term(term.alpha, pair);
    slope[k] = unit.stress;
    if (errors.free_alphas) slope[count + k] = term.mu * unit.by_alpha;
  }
  return errors.student * std::sqrt(std::max(slope.dot(errors.covariance * slope), 0.0));
}

Mu1 mu_over_alpha(const Ogden& term, const std::optional<CurveErrors>& errors) {
  const double value = 2 * term.mu / term.alpha;
  if (!errors || errors->covariance.rows() != (errors->free_alphas ? 2 : 1)) return {value, std::nullopt};
  Eigen::VectorXd slope(errors->covariance.rows());
  slope[0] = 2 / term.alpha;
  if (errors->free_alphas) slope[1] = -value / term.alpha;
  return {value, errors->student * std::sqrt(std::max(slope.dot(errors->covariance * slope), 0.0))};
}

}  // namespace percal::page_of_fit
