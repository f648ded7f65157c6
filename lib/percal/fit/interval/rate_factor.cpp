#include "percal/fit/interval/rate_factor.hpp"

#include <fmt/core.h>

#include <cmath>
#include <limits>
#include <utility>

#include "percal/base/error.hpp"
#include "percal/fit/interval/findings.hpp"
#include "percal/math/distributions.hpp"

namespace percal {
namespace {

constexpr double factor_reach = 1e4;  // the factor is searched this far to both sides of its first guess

// A curve with the fit of its own, by whose errors its points are weighted.
struct FittedAlone {
  CurveProblem problem;
  RateCurve curve;
  double sum_of_squares = 0;  // weighted
};

FittedAlone fit_alone(const CurveData& data, Residual residual, const char* which) {
  const Place place{data.sources.empty() ? "" : data.sources[0].file, 0, which};
  const CurveFit fit = fit_curves(data, {.residual = residual});
  if (fit.minima.empty()) throw BadInput(place, "a curve that no positive modulus fits", "the curve of a soft solid");
  const Uncertainty uncertainty = uncertainty_of(data, fit, {});
  if (uncertainty.minima.empty())
    throw BadInput(place, uncertainty.findings[0], "a curve of three points or more, with scatter");
  FittedAlone alone;
  alone.curve = {.points = fit.points,
                 .errors = uncertainty.errors,
                 .scatter = uncertainty.scatter,
                 .alone = fit.minima[0].solid.terms[0]};
  alone.problem = curve_problem(data, residual);
  const bool known = uncertainty.errors == ErrorSource::standard_errors;
  const double error = known ? 1 : uncertainty.scatter / std::sqrt(alone.problem.objective_unit);
  for (auto& point : alone.problem.points) point.weight /= error;
  alone.sum_of_squares = uncertainty.degrees_of_freedom * (known ? uncertainty.scatter * uncertainty.scatter : 1);
  return alone;
}

// Which modulus is a parameter beside the factor; the other one follows.
enum class Base { slow, fast };

// Parameters: ln of the base's modulus, ln factor, alpha. The low rate's points come first.
struct SharedShape {
  const FittedAlone &slow, &fast;
  Base base;

  ModelAnswer operator()(const Eigen::VectorXd& at, Want) const {
    const auto rows = static_cast<Eigen::Index>(slow.problem.points.size() + fast.problem.points.size());
    ModelAnswer answer{Eigen::VectorXd(rows), Eigen::MatrixXd(rows, 3), {}};
    Eigen::Index row = 0;
    const auto add = [&](const CurveProblem& problem, double power) {  // mu = base's mu * factor^power
      const double mu = std::exp(at[0] + power * at[1]) / problem.scale;
      for (const auto& point : problem.points) {
        const UnitTerm unit = unit_term(at[2], point.pair);
        const double stress = point.weight * mu * unit.stress;
        answer.value[row] = stress;
        answer.jacobian.row(row++) << stress, power * stress, point.weight * mu * unit.by_alpha;
      }
    };
    add(slow.problem, base == Base::slow ? 0 : -1);
    add(fast.problem, base == Base::slow ? 1 : 0);
    return answer;
  }
};

bool errors_known(const FittedAlone& slow, const FittedAlone& fast) {
  return slow.curve.errors == ErrorSource::standard_errors && fast.curve.errors == ErrorSource::standard_errors;
}

CalibrationProblem joint_problem(const FittedAlone& slow, const FittedAlone& fast, Base base) {
  const bool from_slow = base == Base::slow, known = errors_known(slow, fast);
  const double mu = (from_slow ? slow : fast).curve.alone.mu, factor = fast.curve.alone.mu / slow.curve.alone.mu;
  CalibrationProblem problem;
  problem.parameters = {
      {from_slow ? "mu at the low rate" : "mu at the high rate", "Pa", mu / modulus_reach, mu * modulus_reach, true},
      {"the rate factor", "", factor / factor_reach, factor * factor_reach, true},
      {"alpha", "", -largest_alpha, largest_alpha, false}};
  problem.groups = {{.name = "points", .estimated = !known, .fixed = 0}};
  for (const FittedAlone* one : {&slow, &fast})
    for (const auto& point : one->problem.points)
      problem.data.push_back({.label = "", .value = point.weight * point.stress, .error = known ? 1.0 : 0.0});
  problem.model = SharedShape{slow, fast, base};
  return problem;
}

// From the alpha of either curve alone, which one shape lies between.
Minimum better_of_two_starts(const CalibrationProblem& problem, const FittedAlone& slow, const FittedAlone& fast,
                             Base base) {
  const auto from = [&](double alpha) {
    const double mu = (base == Base::slow ? slow : fast).curve.alone.mu;
    const Eigen::Vector3d start(std::log(mu), std::log(fast.curve.alone.mu / slow.curve.alone.mu), alpha);
    return refine(problem, start, {}, SearchOptions{});
  };
  const Minimum first = from(slow.curve.alone.alpha), second = from(fast.curve.alone.alpha);
  return second.residual.squaredNorm() < first.residual.squaredNorm() ? second : first;
}

ParameterUncertainty interval_of(const CalibrationProblem& problem, const Minimum& minimum,
                                 const ProfileInterval& profile) {
  const auto& parameter = problem.parameters[static_cast<std::size_t>(profile.parameter)];
  return {.name = parameter.name,
          .unit = parameter.unit,
          .value = parameter.natural(minimum.searched[profile.parameter]),
          .interval = profile.interval,
          .searched_low = parameter.low,
          .searched_high = parameter.high,
          .identifiable = profile.identifiable,
          .bootstrap = {}};
}

// Known errors are the limit of infinitely many degrees of freedom.
OneShape compare_shapes(double with_one_alpha, const FittedAlone& slow, const FittedAlone& fast) {
  const double with_two = slow.sum_of_squares + fast.sum_of_squares;
  OneShape shape;
  shape.degrees_of_freedom = slow.curve.points + fast.curve.points - 4;
  const bool known = errors_known(slow, fast);
  shape.f = std::max(0.0, with_one_alpha - with_two) / (known ? 1 : with_two / shape.degrees_of_freedom);
  shape.chance = f_tail(shape.f, 1, known ? std::numeric_limits<double>::infinity() : shape.degrees_of_freedom);
  shape.serves = shape.chance > shape_refuted;
  return shape;
}

std::vector<std::string> findings_of(const RateFactor& rate, const std::string& range) {
  std::vector<std::string> sentences;
  const double difference = rate.fast.alone.alpha - rate.slow.alone.alpha;
  sentences.push_back(
      rate.one_shape.serves
          ? fmt::format(
                "One shape serves both rates: an alpha for each would differ by {:.2g}, which chance alone does in "
                "{:.2g} of 100 such pairs.",
                std::abs(difference), 100 * rate.one_shape.chance)
          : fmt::format(
                "One shape does not serve both rates: the curves alone want alpha = {:.4g} and {:.4g}, which chance "
                "alone does in {:.2g} of 100 such pairs. The factor changes with the stretch.",
                rate.slow.alone.alpha, rate.fast.alone.alpha, 100 * rate.one_shape.chance));
  for (const auto* parameter : {&rate.factor, &rate.mu_slow, &rate.mu_fast, &rate.alpha})
    if (const std::string sentence = undetermined(*parameter, range, rate.level); !sentence.empty())
      sentences.push_back(sentence);
  if (!rate.converged) sentences.push_back("The fit did not converge within the iterations allowed.");
  return sentences;
}

CurveData together(CurveData slow, const CurveData& fast) {
  slow.points.insert(slow.points.end(), fast.points.begin(), fast.points.end());
  return slow;
}

}  // namespace

RateFactor fit_rate_factor(const CurveData& slow, const CurveData& fast, Residual residual, double level) {
  const FittedAlone at_low = fit_alone(slow, residual, "low rate"), at_high = fit_alone(fast, residual, "high rate");
  RateFactor rate;
  rate.level = level;
  rate.residual = residual;
  rate.slow = at_low.curve;
  rate.fast = at_high.curve;
  for (const Base base : {Base::slow, Base::fast}) {
    const CalibrationProblem problem = joint_problem(at_low, at_high, base);
    const Minimum minimum = better_of_two_starts(problem, at_low, at_high, base);
    const auto profiles = profile_intervals(problem, minimum, level, SearchOptions{});
    (base == Base::slow ? rate.mu_slow : rate.mu_fast) = interval_of(problem, minimum, profiles[0]);
    if (base == Base::fast) continue;
    rate.factor = interval_of(problem, minimum, profiles[1]);
    rate.alpha = interval_of(problem, minimum, profiles[2]);
    rate.one_shape = compare_shapes(minimum.residual.squaredNorm(), at_low, at_high);
    rate.degrees_of_freedom = minimum.degrees_of_freedom;
    rate.converged = minimum.converged;
  }
  rate.findings = findings_of(rate, range_of(together(slow, fast)));
  return rate;
}

}  // namespace percal
