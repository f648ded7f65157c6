#include "percal/fit/search/fit_curves.hpp"

#include <fmt/core.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "percal/base/error.hpp"

namespace percal {
namespace {

constexpr double same_objective = 1e-9;  // relative: below this two minima are equally good
constexpr double rounding = 1e-24;       // share of the sum of squares of the data that is only rounding
constexpr double singular = 1e-12;       // smallest eigenvalue of the correlations below which they are not told apart
constexpr int loss_rounds = 2;           // residuals of least squares -> scale -> fit -> scale -> fit

void need_points(const CurveProblem& problem, Model model) {
  const int needed = std::max(2, parameters_of(model));
  if (problem.different >= needed) return;
  throw BadInput(
      fmt::format("found {} different deformed point(s); accepted: curves with at least {} different deformed points "
                  "with stress, for the {} parameters of {}",
                  problem.different, needed, parameters_of(model), word(model)));
}

Hyperelastic in_pascals(const Polished& minimum, double scale) {
  Hyperelastic solid{minimum.terms};
  for (auto& term : solid.terms) term.mu *= scale;
  return solid;
}

// 1 - SSE/SST over the points of one test, or of all (test < 0).                                        (15)
std::optional<double> coefficient_of_determination(const CurveProblem& problem, const Hyperelastic& solid, int test) {
  double sum = 0, count = 0, sse = 0, sst = 0;
  const auto counts = [&](const WeightedPoint& point) { return test < 0 || point.test == test; };
  for (const auto& point : problem.points)
    if (counts(point)) sum += point.stress, ++count;
  for (const auto& point : problem.points) {
    if (!counts(point)) continue;
    const double error = point.stress - nominal_stress(solid, point.pair) / problem.scale;
    const double deviation = point.stress - sum / count;
    sse += error * error;
    sst += deviation * deviation;
  }
  if (sst == 0 || !std::isfinite(sse / sst)) return std::nullopt;
  return 1 - sse / sst;
}

// Standard errors from the covariance of (ln mu, alpha).                               docs/theory/curves.md (14)
void add_standard_errors(CurveMinimum& minimum, const CurveProblem& problem, const CurveOptions& options) {
  const auto terms = static_cast<Eigen::Index>(minimum.solid.terms.size());
  minimum.errors.resize(terms);
  const auto freedom = static_cast<int>(problem.points.size()) - parameters_of(options.model);
  if (minimum.at_bound || freedom < 1 || terms < terms_of(options.model) || options.loss != Loss::squares) return;
  const CurveResiduals residuals = residuals_of(problem, options.model, minimum.solid);
  Eigen::MatrixXd normal = residuals.jacobian.transpose() * residuals.jacobian;
  const Eigen::VectorXd size = normal.diagonal().cwiseSqrt();
  normal = size.cwiseInverse().asDiagonal() * normal * size.cwiseInverse().asDiagonal();
  if (!normal.allFinite()) return;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(normal);
  if (!(eigen.eigenvalues()(0) > singular)) return;
  const Eigen::MatrixXd inverse = normal.inverse();
  const double variance = residuals.value.squaredNorm() / freedom;
  const auto error = [&](Eigen::Index i) { return std::sqrt(variance * inverse(i, i)) / size(i); };
  const bool free = fixed_alphas(options.model).empty();
  for (Eigen::Index k = 0; k < terms; ++k) {
    minimum.errors[k].mu = std::abs(minimum.solid.terms[k].mu) * error(k);
    if (free) minimum.errors[k].alpha = error(terms + k);
  }
  if (free && terms == 1)
    minimum.correlation = std::clamp(inverse(0, 1) / std::sqrt(inverse(0, 0) * inverse(1, 1)), -1.0, 1.0);
}

CurveMinimum minimum_of(const Polished& found, const CurveProblem& problem, const CurveOptions& options) {
  CurveMinimum minimum{};
  minimum.solid = in_pascals(found, problem.scale);
  minimum.objective = found.objective * problem.objective_unit;
  minimum.converged = found.converged;
  minimum.iterations = found.iterations;
  minimum.at_bound = std::any_of(found.terms.begin(), found.terms.end(),
                                 [](const Ogden& term) { return std::abs(term.alpha) > largest_alpha * (1 - 1e-9); });
  minimum.r2 = coefficient_of_determination(problem, minimum.solid, -1);
  for (int test = 0; test < static_cast<int>(problem.tests.size()); ++test)
    minimum.r2_of_test.push_back(coefficient_of_determination(problem, minimum.solid, test));
  add_standard_errors(minimum, problem, options);
  return minimum;
}

bool is_usable(const CurveMinimum& minimum) {
  return std::isfinite(minimum.objective) && std::all_of(minimum.solid.terms.begin(), minimum.solid.terms.end(),
                                                         [](const Ogden& term) { return std::isnormal(term.mu); });
}

// Best first; of two equal ones the positive alpha first, so that the order is no matter of rounding.
void sort_and_compare(std::vector<CurveMinimum>& minima, double floor) {
  std::sort(minima.begin(), minima.end(), [](const auto& a, const auto& b) { return a.objective < b.objective; });
  const auto equal = [&](const auto& a, const auto& b) {
    return b.objective - a.objective <= same_objective * a.objective + floor;
  };
  const auto alpha = [&](std::size_t i) { return minima[i].solid.terms[0].alpha; };
  for (std::size_t i = 0; i + 1 < minima.size(); ++i)
    if (equal(minima[i], minima[i + 1]) && alpha(i) < 0 && alpha(i + 1) > 0) std::swap(minima[i], minima[i + 1]);
  for (auto& minimum : minima) {
    const double ratio = minimum.objective / minima[0].objective;
    if (std::isfinite(ratio)) minimum.above_best = ratio - 1;
    if (&minimum == &minima[0] || equal(minima[0], minimum)) minimum.above_best = 0;
  }
}

// Least squares, and for a robust loss fits with the scale that the residuals of the fit before have.
FoundMinima searched(const CurveProblem& problem, const CurveOptions& options, ScaledLoss& loss) {
  FoundMinima found = search_terms(options.model, problem.points, options.signs, {});
  if (options.loss == Loss::squares) return found;
  for (int round = 0; round < loss_rounds; ++round) {
    const Polished* best = best_of(found);
    if (!best) break;
    const double scale =
        scale_for(options.loss, residuals_of(problem, options.model, in_pascals(*best, problem.scale)).value);
    if (!(scale > 0)) break;
    loss = {options.loss, scale};
    found = search_terms(options.model, problem.points, options.signs, loss);
  }
  return found;
}

}  // namespace

CurveFit fit_curves(const CurveData& data, const CurveOptions& options) {
  const CurveProblem problem = curve_problem(data, options.residual, options.weighting);
  need_points(problem, options.model);
  ScaledLoss loss;
  const FoundMinima found = searched(problem, options, loss);

  CurveFit fit;
  fit.options = options;
  fit.tests = problem.tests;
  fit.points = static_cast<int>(problem.points.size());
  fit.left_out_zero_stress = problem.left_out_zero_stress;
  fit.left_out_no_error = problem.left_out_no_error;
  fit.points_of_mode = problem.points_of_mode;
  fit.scanned = found.scanned;
  fit.starts = found.starts;
  if (loss.loss != Loss::squares) fit.loss_scale = loss.scale * std::sqrt(problem.objective_unit);
  for (const auto& one : found.minima) {
    const CurveMinimum minimum = minimum_of(one, problem, options);
    if (is_usable(minimum)) fit.minima.push_back(minimum);
  }
  if (fit.minima.empty() && found.refused) fit.refused = in_pascals(*found.refused, problem.scale);
  const double data_squares = weighted_stress(problem.points).squaredNorm() * problem.objective_unit;
  sort_and_compare(fit.minima, rounding * data_squares);
  if (!fit.minima.empty())
    fit.aicc =
        aicc(fit.minima[0].objective / problem.objective_unit, problem.points.size(), parameters_of(options.model));
  return fit;
}

CurveFit fit_ogden(const CurveData& data, Residual residual) { return fit_curves(data, {.residual = residual}); }

}  // namespace percal
