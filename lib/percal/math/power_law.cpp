// y = k x^n by least squares, with GSL. The free exponent is fitted as y = exp(p0) (x/x0)^p1 with x0 the geometric mean
// of x, in which the two parameters hardly depend on each other; k = exp(p0) x0^-p1.
#include <gsl/gsl_blas.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_fit.h>
#include <gsl/gsl_multifit_nlinear.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "percal/base/error.hpp"
#include "percal/math/statistics.hpp"

namespace percal {
namespace {

void require_positive(std::span<const double> values, const char* which) {
  for (double value : values)
    if (!(value > 0) || !std::isfinite(value))
      throw BadInput(std::string("power law: found ") + which + " = " + std::to_string(value) +
                     "; accepted: positive numbers");
}

void require_points(std::span<const double> x, std::span<const double> y, std::size_t parameters) {
  if (x.size() != y.size())
    throw BadInput("power law: found " + std::to_string(x.size()) + " x and " + std::to_string(y.size()) + " y");
  require_positive(x, "x");
  require_positive(y, "y");
  std::vector<double> different(x.begin(), x.end());
  std::sort(different.begin(), different.end());
  const auto end = std::unique(different.begin(), different.end());
  auto count = static_cast<std::size_t>(end - different.begin());
  if (count < parameters)
    throw BadInput("power law: found " + std::to_string(count) +
                   " different x; accepted: " + std::to_string(parameters) + " or more");
}

// The points with the weights that turn both misfits into one sum of (weight (y - k x^n))^2.
struct Points {
  std::vector<double> log_x;  // ln(x/x0)
  std::vector<double> y;
  std::vector<double> weight;
};

double weight_of(double y, double largest, Misfit misfit) { return 1 / (misfit == Misfit::relative ? y : largest); }

int residuals(const gsl_vector* p, void* data, gsl_vector* out) {
  const auto& points = *static_cast<const Points*>(data);
  for (std::size_t i = 0; i < points.y.size(); ++i) {
    double model = std::exp(gsl_vector_get(p, 0) + gsl_vector_get(p, 1) * points.log_x[i]);
    gsl_vector_set(out, i, points.weight[i] * (model - points.y[i]));
  }
  return GSL_SUCCESS;
}

int jacobian(const gsl_vector* p, void* data, gsl_matrix* out) {
  const auto& points = *static_cast<const Points*>(data);
  for (std::size_t i = 0; i < points.y.size(); ++i) {
    double model = points.weight[i] * std::exp(gsl_vector_get(p, 0) + gsl_vector_get(p, 1) * points.log_x[i]);
    gsl_matrix_set(out, i, 0, model);
    gsl_matrix_set(out, i, 1, model * points.log_x[i]);
  }
  return GSL_SUCCESS;
}

FitOutcome outcome_of(int status) {
  if (status == GSL_SUCCESS) return FitOutcome::converged;
  return status == GSL_EMAXITER ? FitOutcome::out_of_iterations : FitOutcome::no_progress;
}

}  // namespace

double PowerLaw::at(double x) const { return factor * std::pow(x, exponent); }

PowerLaw fit_power_law(std::span<const double> x, std::span<const double> y, double exponent, Misfit misfit) {
  require_points(x, y, 1);
  double largest = *std::ranges::max_element(y);
  std::vector<double> base, target;
  for (std::size_t i = 0; i < x.size(); ++i) {
    double weight = weight_of(y[i], largest, misfit);
    base.push_back(weight * std::pow(x[i], exponent));
    target.push_back(weight * y[i]);
  }
  double factor, variance, squares;
  gsl_set_error_handler_off();
  int status = gsl_fit_mul(base.data(), 1, target.data(), 1, base.size(), &factor, &variance, &squares);

  PowerLaw law;
  law.factor = factor;
  law.exponent = exponent;
  law.points = static_cast<int>(x.size());
  law.outcome = outcome_of(status);
  if (x.size() > 1) law.factor_error = std::sqrt(variance);
  law.objective = misfit == Misfit::relative ? squares : squares * largest * largest;
  return law;
}

PowerLaw fit_power_law(std::span<const double> x, std::span<const double> y, Misfit misfit) {
  require_points(x, y, 2);
  double largest = *std::ranges::max_element(y);
  Points points{.log_x = {}, .y = {y.begin(), y.end()}, .weight = {}};
  std::vector<double> log_y;
  double log_x0 = 0;
  for (double value : x) log_x0 += std::log(value) / static_cast<double>(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    points.log_x.push_back(std::log(x[i]) - log_x0);
    points.weight.push_back(weight_of(y[i], largest, misfit));
    log_y.push_back(std::log(y[i]));
  }
  auto start = linear_trend(points.log_x, log_y);

  gsl_set_error_handler_off();
  gsl_multifit_nlinear_fdf problem{};
  problem.f = residuals;
  problem.df = jacobian;
  problem.n = x.size();
  problem.p = 2;
  problem.params = &points;
  auto parameters = gsl_multifit_nlinear_default_parameters();
  std::unique_ptr<gsl_multifit_nlinear_workspace, decltype(&gsl_multifit_nlinear_free)> work(
      gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &parameters, problem.n, problem.p),
      &gsl_multifit_nlinear_free);
  if (!work) throw std::bad_alloc();
  double first[2] = {start.intercept, start.slope};
  auto first_view = gsl_vector_const_view_array(first, 2);
  PowerLaw law;
  law.points = static_cast<int>(x.size());
  int status = gsl_multifit_nlinear_init(&first_view.vector, &problem, work.get());
  // 1e-15 in the step: as far as double precision goes. Points exactly on a law end as "no progress" at a zero
  // residual.
  int info = 0;
  if (status == GSL_SUCCESS)
    status = gsl_multifit_nlinear_driver(200, 1e-12, 1e-15, 0, nullptr, nullptr, &info, work.get());
  law.outcome = outcome_of(status);

  const auto* best = gsl_multifit_nlinear_position(work.get());
  law.exponent = gsl_vector_get(best, 1);
  law.factor = std::exp(gsl_vector_get(best, 0) - law.exponent * log_x0);
  double squares = 0;
  const auto* left = gsl_multifit_nlinear_residual(work.get());
  gsl_blas_ddot(left, left, &squares);
  law.objective = misfit == Misfit::relative ? squares : squares * largest * largest;
  if (squares < 1e-28 * static_cast<double>(x.size())) law.outcome = FitOutcome::converged;

  double covariance[4];
  auto view = gsl_matrix_view_array(covariance, 2, 2);
  if (x.size() > 2 &&
      gsl_multifit_nlinear_covar(gsl_multifit_nlinear_jac(work.get()), 0, &view.matrix) == GSL_SUCCESS) {
    double scatter = squares / static_cast<double>(x.size() - 2);
    // ln k = p0 - p1 ln x0
    double variance = covariance[0] - 2 * log_x0 * covariance[1] + log_x0 * log_x0 * covariance[3];
    law.factor_error = law.factor * std::sqrt(scatter * variance);
    law.exponent_error = std::sqrt(scatter * covariance[3]);
  }
  return law;
}

}  // namespace percal
