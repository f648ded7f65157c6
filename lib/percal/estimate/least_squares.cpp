#include "percal/estimate/least_squares.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "percal/base/error.hpp"
#include "percal/estimate/frozen_fit.hpp"
#include "percal/estimate/scatter.hpp"

namespace percal {
namespace {

using Eigen::VectorXd;

constexpr double settled_change = 1e-9;  // of V, relative: the weights are what they were
constexpr double nearly_settled = 1e-5;  // what a fit may be left with and still count as converged

Place at(const std::string& key) { return {"", 0, key}; }

void check(const FreeParameter& free) {
  const Place place = at(free.name);
  if (!std::isfinite(free.low) || !std::isfinite(free.high) || free.low >= free.high)
    throw BadInput(place, "bounds " + std::to_string(free.low) + " to " + std::to_string(free.high),
                   "two finite numbers, the lower one first");
  if (free.logarithmic && free.low <= 0)
    throw BadInput(place, "lower bound " + std::to_string(free.low), "a positive one, as the logarithm is searched");
  if (!free.prior) return;
  if (!(free.prior_error > 0))
    throw BadInput(place, "prior error " + std::to_string(free.prior_error), "a positive standard deviation");
  if (!std::isfinite(*free.prior) || (free.logarithmic && *free.prior <= 0))
    throw BadInput(place, "prior " + std::to_string(*free.prior),
                   free.logarithmic ? "a positive number, as the logarithm is searched" : "a finite number");
}

void check(const Datum& datum, const std::vector<ScatterGroup>& groups) {
  const Place place = at(datum.label);
  if (datum.group < 0 || datum.group >= static_cast<int>(groups.size()))
    throw BadInput(place, "scatter group " + std::to_string(datum.group), "the index of one of the groups");
  if (!std::isfinite(datum.value) || !std::isfinite(datum.error) || datum.error < 0)
    throw BadInput(place, "value " + std::to_string(datum.value) + ", error " + std::to_string(datum.error),
                   "finite numbers, the error not negative");
  const ScatterGroup& group = groups[datum.group];
  if (!group.estimated && !(std::hypot(datum.error, group.fixed) > 0))
    throw BadInput(place, "no error, in a group whose scatter is held at 0",
                   "an error of the datum, a scatter of its group, or one that is estimated");
}

VectorXd into_box(const CalibrationProblem& problem, VectorXd searched, const std::vector<Held>& held) {
  searched = searched.cwiseMax(lower_bounds(problem)).cwiseMin(upper_bounds(problem)).eval();
  for (const Held& one : held) searched[one.parameter] = one.searched;
  return searched;
}

int degrees_of_freedom(const CalibrationProblem& problem, const VectorXd& residual, const std::vector<int>& free) {
  int count = -static_cast<int>(free.size());
  for (std::size_t i = 0; i < problem.data.size(); ++i) count += problem.data[i].is_number() || residual[i] != 0;
  for (const int k : free) count += problem.parameters[k].prior.has_value();
  return count;
}

// What the settled weights leave to be said about a point.
Minimum describe(const CalibrationProblem& problem, const Weights& weights, const ModelAnswer& answer,
                 const FrozenFit& fit, const std::vector<double>& scatter, const std::vector<int>& free) {
  Minimum minimum;
  minimum.searched = fit.searched;
  minimum.scatter = scatter;
  minimum.residual = residuals(problem, answer);
  for (std::size_t i = 0; i < problem.data.size(); ++i)
    if (side(problem.data[i].seen) * minimum.residual[i] > 0) minimum.residual[i] = 0;
  const Whitened white = whiten(problem, weights, answer, fit.searched);
  minimum.objective = white.objective();
  minimum.deviance = white.objective() + weights.log_determinant(problem.data);
  minimum.information = white.information();
  minimum.covariance = bounded_inverse(problem, minimum.information, free);
  for (int k = 0; k < fit.searched.size(); ++k)
    minimum.at_bound.push_back(at_bound(problem, fit.searched, k) != AtBound::no);
  minimum.degrees_of_freedom = degrees_of_freedom(problem, minimum.residual, free);
  return minimum;
}

// The model has no answer at the start: a point that says so.
Minimum nothing_found(const CalibrationProblem& problem, const VectorXd& start, const std::vector<int>& free) {
  const auto n = static_cast<int>(problem.data.size()), p = static_cast<int>(problem.parameters.size());
  Minimum minimum;
  minimum.searched = start;
  minimum.objective = minimum.deviance = std::numeric_limits<double>::max();
  minimum.scatter.assign(problem.groups.size(), 0);
  minimum.residual = VectorXd::Zero(n);
  minimum.information = Eigen::MatrixXd::Zero(p, p);
  minimum.covariance = bounded_inverse(problem, minimum.information, free);
  minimum.at_bound.assign(p, false);
  return minimum;
}

}  // namespace

double FreeParameter::searched(double natural) const { return logarithmic ? std::log(natural) : natural; }

double FreeParameter::natural(double searched) const { return logarithmic ? std::exp(searched) : searched; }

void check_problem(const CalibrationProblem& problem) {
  if (problem.data.empty()) throw BadInput(at("data"), "none", "one datum or more to fit to");
  if (problem.parameters.empty()) throw BadInput(at("parameters"), "none", "one free parameter or more");
  for (const auto& free : problem.parameters) check(free);
  for (const auto& group : problem.groups)
    if (!(group.fixed >= 0) || !std::isfinite(group.fixed))
      throw BadInput(at(group.name), "scatter " + std::to_string(group.fixed), "0 or a positive number");
  for (const auto& datum : problem.data) check(datum, problem.groups);
}

// Fit, look at the residuals, weigh anew, until nothing changes. In the second half of the rounds the scatter moves half the way
// only, which ends a swing between two states.
Minimum settle(Evaluator& evaluator, const VectorXd& start, const std::vector<Held>& held,
               const SearchOptions& options) {
  const CalibrationProblem& problem = evaluator.problem();
  const std::vector<int> free = free_parameters(problem, held);
  FrozenFit fit{.searched = into_box(problem, start, held)};
  ModelAnswer answer = evaluator.with_covariance(fit.searched);
  if (!finite(answer)) return nothing_found(problem, fit.searched, free);

  std::vector<double> scatter = first_scatter(problem, residuals(problem, answer));
  Weights weights = make_weights(problem.data, scatter, answer.covariance);
  double moved = 1;
  const int rounds = std::max(1, options.scatter_rounds);
  for (int round = 0; round < rounds && moved > settled_change; ++round) {
    fit = frozen_fit(evaluator, weights, fit.searched, free);
    answer = evaluator.with_covariance(fit.searched);
    auto next = restricted_scatter(problem, answer, fit.searched, scatter, free);
    if (2 * round > rounds)
      for (std::size_t g = 0; g < next.size(); ++g)
        next[g] = std::sqrt((next[g] * next[g] + scatter[g] * scatter[g]) / 2);
    scatter = next;
    const Weights before = std::exchange(weights, make_weights(problem.data, scatter, answer.covariance));
    moved = change(before, weights);
  }
  Minimum minimum = describe(problem, weights, answer, fit, scatter, free);
  minimum.converged = fit.converged && moved < nearly_settled;
  return minimum;
}

Minimum refine(const CalibrationProblem& problem, const VectorXd& start, const std::vector<Held>& held,
               const SearchOptions& options) {
  check_problem(problem);
  Evaluator evaluator(problem);
  Minimum minimum = settle(evaluator, start, held, options);
  minimum.evaluations = evaluator.evaluations();
  return minimum;
}

}  // namespace percal
