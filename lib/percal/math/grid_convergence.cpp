// For a given order p the fit is linear in f0 and a: GSL solves that, and p is found by a search in one variable.
#include "percal/math/grid_convergence.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_min.h>
#include <gsl/gsl_multifit.h>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <new>
#include <set>

#include "percal/base/error.hpp"

namespace percal {
namespace {

constexpr double lowest_order = 0.5, highest_order = 2;  // of a h^p; outside, fixed orders are used
constexpr double highest_reliable_order = 2.1;           // up to it the small safety factor holds
constexpr double small_safety_factor = 1.25, large_safety_factor = 3;
constexpr double search_from = 0.02, search_to = 10;  // of p
constexpr int search_points = 31;

// The points as vectors, with weights that sum to 1.
struct Series {
  std::vector<double> h, value, weight;
  int count() const { return static_cast<int>(h.size()); }
};

std::vector<double> normalised(std::vector<double> weights) {
  double sum = 0;
  for (const double weight : weights) sum += weight;
  for (double& weight : weights) weight /= sum;
  return weights;
}

std::vector<double> noise_weights(std::span<const GridPoint> points) {
  const bool known = std::ranges::all_of(points, [](const GridPoint& point) { return point.standard_error > 0; });
  std::vector<double> weights;
  for (const auto& point : points) weights.push_back(known ? 1 / (point.standard_error * point.standard_error) : 1);
  return normalised(weights);
}

Series series_of(std::span<const GridPoint> points, bool fine_weighted) {
  Series series;
  series.weight = noise_weights(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    series.h.push_back(points[i].h);
    series.value.push_back(points[i].value);
    if (fine_weighted) series.weight[i] /= points[i].h;
  }
  series.weight = normalised(series.weight);
  return series;
}

// value = c_0 + c_1 h^orders[0] + ...: weighted least squares by GSL, the sum of weighted squares.
class LinearFit {
 public:
  LinearFit(const Series& series, int terms)
      : series_(series),
        work_(gsl_multifit_linear_alloc(series.h.size(), terms + 1), &gsl_multifit_linear_free),
        design_(gsl_matrix_alloc(series.h.size(), terms + 1), &gsl_matrix_free),
        covariance_(gsl_matrix_alloc(terms + 1, terms + 1), &gsl_matrix_free) {
    if (!work_ || !design_ || !covariance_) throw std::bad_alloc();
  }

  double solve(std::span<const double> orders) {
    for (int i = 0; i < series_.count(); ++i) {
      gsl_matrix_set(design_.get(), i, 0, 1);
      for (std::size_t k = 0; k < orders.size(); ++k)
        gsl_matrix_set(design_.get(), i, k + 1, std::pow(series_.h[i], orders[k]));
    }
    const auto values = gsl_vector_const_view_array(series_.value.data(), series_.value.size());
    const auto weights = gsl_vector_const_view_array(series_.weight.data(), series_.weight.size());
    auto found = gsl_vector_view_array(coefficients.data(), orders.size() + 1);
    double squares = 0;
    const int status = gsl_multifit_wlinear(design_.get(), &weights.vector, &values.vector, &found.vector,
                                            covariance_.get(), &squares, work_.get());
    return status == GSL_SUCCESS ? squares : std::numeric_limits<double>::infinity();
  }

  std::array<double, 3> coefficients{};

 private:
  const Series& series_;
  std::unique_ptr<gsl_multifit_linear_workspace, decltype(&gsl_multifit_linear_free)> work_;
  std::unique_ptr<gsl_matrix, decltype(&gsl_matrix_free)> design_, covariance_;
};

double standard_deviation(double squares, int points, int parameters) {
  return std::sqrt(points * std::max(0.0, squares) / (points - parameters));
}

GridFit fit_fixed(const Series& series, bool fine_weighted, ErrorForm form) {
  const bool is_mixed = form == ErrorForm::first_and_second_order;
  LinearFit linear(series, is_mixed ? 2 : 1);
  const double order = form == ErrorForm::second_order ? 2 : 1;
  const std::array<double, 2> orders{order, 2};
  const double squares = linear.solve(std::span(orders).first(is_mixed ? 2 : 1));
  GridFit fit{.form = form, .fine_weighted = fine_weighted};
  fit.limit = linear.coefficients[0];
  fit.a = linear.coefficients[1];
  fit.b = is_mixed ? linear.coefficients[2] : 0;
  fit.order = is_mixed ? 0 : order;
  fit.standard_deviation = standard_deviation(squares, series.count(), is_mixed ? 3 : 2);
  return fit;
}

double squares_at(double log_order, void* linear) {
  const std::array<double, 1> order{std::exp(log_order)};
  return static_cast<LinearFit*>(linear)->solve(order);
}

// ln p of the smallest sum of squares: the best of a scan, made exact between its neighbours.
double best_log_order(LinearFit& linear) {
  const double from = std::log(search_from), step = (std::log(search_to) - from) / (search_points - 1);
  int best = 0;
  std::vector<double> squares;
  for (int k = 0; k < search_points; ++k) {
    squares.push_back(squares_at(from + k * step, &linear));
    if (squares[k] < squares[best]) best = k;
  }
  if (best == 0 || best == search_points - 1) return from + best * step;
  gsl_function function{&squares_at, &linear};
  const std::unique_ptr<gsl_min_fminimizer, decltype(&gsl_min_fminimizer_free)> search(
      gsl_min_fminimizer_alloc(gsl_min_fminimizer_brent), &gsl_min_fminimizer_free);
  if (!search) throw std::bad_alloc();
  const double centre = from + best * step;
  if (gsl_min_fminimizer_set_with_values(search.get(), &function, centre, squares[best], centre - step,
                                         squares[best - 1], centre + step, squares[best + 1]) != GSL_SUCCESS)
    return centre;
  for (int iteration = 0; iteration < 100; ++iteration) {
    if (gsl_min_fminimizer_iterate(search.get()) != GSL_SUCCESS) break;
    if (gsl_min_fminimizer_x_upper(search.get()) - gsl_min_fminimizer_x_lower(search.get()) < 1e-7) break;  // of ln p
  }
  return gsl_min_fminimizer_x_minimum(search.get());
}

GridFit fit_free(const Series& series, bool fine_weighted) {
  LinearFit linear(series, 1);
  const double log_order = best_log_order(linear);
  const double squares = squares_at(log_order, &linear);
  GridFit fit{.form = ErrorForm::free_order, .fine_weighted = fine_weighted};
  fit.order = std::exp(log_order);
  fit.limit = linear.coefficients[0];
  fit.a = linear.coefficients[1];
  fit.standard_deviation = standard_deviation(squares, series.count(), 3);
  return fit;
}

// Of values that are all the same: what a fit finds besides their value is round-off.
GridFit constant(double value) { return {.form = ErrorForm::first_order, .limit = value, .order = 1}; }

bool is_reasonable(double order) { return order >= lowest_order && order <= highest_order; }

const GridFit& tightest(const std::vector<GridFit>& fits) {
  return *std::ranges::min_element(fits, {}, &GridFit::standard_deviation);
}

// By weights of noise alone, and of fine meshes besides.
using WeightedSeries = std::array<Series, 2>;

void add_fixed(const WeightedSeries& series, ErrorForm form, std::vector<GridFit>& fits) {
  for (const bool fine_weighted : {false, true}) fits.push_back(fit_fixed(series[fine_weighted], fine_weighted, form));
}

void fit_given(const WeightedSeries& series, ErrorForm form, GridConvergence& found) {
  std::vector<GridFit> candidates;
  add_fixed(series, form, candidates);
  found.fit = tightest(candidates);
  found.observed_order = found.fit.order;
  found.order_is_reasonable = true;
}

void fit_any(const WeightedSeries& series, GridConvergence& found) {
  const std::vector<GridFit> free{fit_free(series[0], false), fit_free(series[1], true)};
  std::vector<GridFit> candidates;
  for (const auto& fit : free)
    if (is_reasonable(fit.order)) candidates.push_back(fit);
  found.order_is_reasonable = !candidates.empty();
  found.observed_order = tightest(candidates.empty() ? free : candidates).order;
  if (candidates.empty()) {
    add_fixed(series, ErrorForm::first_order, candidates);
    add_fixed(series, ErrorForm::second_order, candidates);
    if (found.observed_order < lowest_order) add_fixed(series, ErrorForm::first_and_second_order, candidates);
  }
  found.fit = tightest(candidates);
}

void require_usable(std::span<const GridPoint> points) {
  for (const auto& point : points)
    if (!(point.h > 0) || !std::isfinite(point.h) || !std::isfinite(point.value) || !(point.standard_error >= 0) ||
        !std::isfinite(point.standard_error))
      throw BadInput("grid convergence: found h = " + std::to_string(point.h) + ", value " +
                     std::to_string(point.value) + " +- " + std::to_string(point.standard_error) +
                     "; accepted: a positive h, a finite value, an error not below zero");
}

// The uncertainty of each point, from the error estimate, the scatter and the point's own distance from the fit.
std::vector<double> uncertainties(std::span<const GridPoint> points, const GridConvergence& found) {
  const double deviation = found.fit.standard_deviation;
  std::vector<double> all;
  for (const auto& point : points) {
    const double error = std::abs(found.fit.error_at(point.h));
    const double misfit = deviation + std::abs(point.value - found.fit.at(point.h));
    if (found.is_smooth())
      all.push_back(found.safety_factor * error + misfit);
    else
      all.push_back(3 * deviation / found.data_range * (error + misfit));
  }
  return all;
}

}  // namespace

std::string word(ErrorForm form) {
  switch (form) {
    case ErrorForm::free_order: return "a h^p";
    case ErrorForm::first_order: return "a h";
    case ErrorForm::second_order: return "a h^2";
    case ErrorForm::first_and_second_order: break;
  }
  return "a h + b h^2";
}

std::string word(GridOutcome outcome) { return outcome == GridOutcome::fitted ? "fitted" : "too few grids"; }

double GridFit::error_at(double h) const {
  return form == ErrorForm::first_and_second_order ? a * h + b * h * h : a * std::pow(h, order);
}

GridConvergence grid_convergence(std::span<const GridPoint> points, std::optional<ErrorForm> form) {
  require_usable(points);
  std::set<double> sizes;
  for (const auto& point : points) sizes.insert(point.h);
  GridConvergence found;
  if (sizes.size() < fewest_grids) return found;
  gsl_set_error_handler_off();
  found.outcome = GridOutcome::fitted;
  const WeightedSeries series{series_of(points, false), series_of(points, true)};
  if (form)
    fit_given(series, *form, found);
  else
    fit_any(series, found);
  const auto [low, high] = std::ranges::minmax(points, {}, &GridPoint::value);
  found.data_range = (high.value - low.value) / static_cast<double>(points.size() - 1);
  if (found.data_range == 0) found.fit = constant(low.value);
  const bool is_reliable =
      found.observed_order >= lowest_order && found.observed_order < highest_reliable_order && found.is_smooth();
  found.safety_factor = is_reliable ? small_safety_factor : large_safety_factor;
  found.uncertainty = uncertainties(points, found);
  return found;
}

std::vector<std::vector<GridPoint>> resampled(std::span<const GridPoint> points, const GridFit& fit, int count,
                                              std::uint64_t seed) {
  const std::unique_ptr<gsl_rng, decltype(&gsl_rng_free)> random(gsl_rng_alloc(gsl_rng_mt19937), &gsl_rng_free);
  if (!random) throw std::bad_alloc();
  gsl_rng_set(random.get(), seed);
  const auto weights = noise_weights(points);
  std::vector<std::vector<GridPoint>> all(count, {points.begin(), points.end()});
  for (auto& series : all)
    for (std::size_t i = 0; i < series.size(); ++i) {
      const double scatter = fit.standard_deviation / std::sqrt(static_cast<double>(points.size()) * weights[i]);
      series[i].value =
          fit.at(series[i].h) + gsl_ran_gaussian(random.get(), std::max(points[i].standard_error, scatter));
    }
  return all;
}

double quantile(std::vector<double> values, double share) {
  std::ranges::sort(values);
  return gsl_stats_quantile_from_sorted_data(values.data(), 1, values.size(), share);
}

}  // namespace percal
