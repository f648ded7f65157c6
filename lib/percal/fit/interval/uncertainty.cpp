#include "percal/fit/interval/uncertainty.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "percal/fit/interval/findings.hpp"
#include "percal/math/distributions.hpp"

namespace percal {
namespace {

constexpr double surely_out = 2;  // thresholds above the best at which a minimum is not looked at

// A robust loss counts a point as if its weight were smaller; the intervals keep what it came to at the best minimum.
void weigh_as_the_loss_does(CurveProblem& problem, const CurveFit& fit) {
  if (fit.options.loss == Loss::squares || !fit.loss_scale) return;
  const double scale = *fit.loss_scale / std::sqrt(problem.objective_unit);
  for (auto& point : problem.points) {
    const double model = nominal_stress(fit.minima[0].solid, point.pair) / problem.scale;
    point.weight *= std::sqrt(weight_of({fit.options.loss}, point.weight * (point.stress - model) / scale));
  }
}

Eigen::VectorXd residuals(const CurveProblem& problem, const Hyperelastic& solid) {
  Eigen::VectorXd all(static_cast<Eigen::Index>(problem.points.size()));
  Eigen::Index i = 0;
  for (const auto& point : problem.points)
    all[i++] = point.weight * (point.stress - nominal_stress(solid, point.pair) / problem.scale);
  return all;
}

// The rise of the objective, in units of the points' variance, that ends an interval.
double threshold(ErrorSource errors, double level, int degrees) {
  if (errors == ErrorSource::standard_errors) return chi_squared_quantile(level, 1);
  const double t = student_quantile((1 + level) / 2, degrees);
  return t * t;
}

void add_bootstrap(MinimumUncertainty& result, const CalibrationProblem& problem, const Minimum& minimum,
                   const UncertaintyOptions& options) {
  const SearchOptions search;
  const auto points = bootstrap_over_points(problem, minimum, options.bootstrap, options.level, options.seed, search);
  const auto of_kind = [&](BootstrapKind kind) {
    return bootstrap(problem, minimum, kind, options.bootstrap, options.level, options.seed, search);
  };
  const Bootstrap residual = of_kind(BootstrapKind::residual), parametric = of_kind(BootstrapKind::parametric);
  result.bootstrap_failed = points.failed + residual.failed + parametric.failed;
  for (std::size_t k = 0; k < result.parameters.size(); ++k)
    if (k < points.intervals.size() && k < residual.intervals.size() && k < parametric.intervals.size())
      result.parameters[k].bootstrap = {points.intervals[k], residual.intervals[k], parametric.intervals[k]};
}

// mu = sum mu_k, whose logarithm has the derivatives mu_k/mu by ln mu_k.
std::optional<Interval> small_strain_interval(const CalibrationProblem& problem, const Hyperelastic& solid,
                                              const Minimum& minimum, double deviations) {
  const double mu = small_strain_modulus(solid);
  if (solid.terms.size() < 2 || !(mu > 0)) return std::nullopt;
  Eigen::VectorXd slope = Eigen::VectorXd::Zero(minimum.searched.size());
  for (std::size_t k = 0; k < solid.terms.size(); ++k)
    slope[static_cast<Eigen::Index>(k)] = (problem.parameters[k].logarithmic ? solid.terms[k].mu : 1.0) / mu;
  const double half = deviations * std::sqrt(slope.dot(minimum.covariance * slope));
  return Interval{mu * std::exp(-half), mu * std::exp(half)};
}

bool hopeless(const FreeParameter& parameter, const Interval& interval) {
  return parameter.unit.empty() && interval.high - interval.low > hopeless_width;
}

// None where the points rule the minimum out beside the best, whose deviance is `best`; the first sets it.
std::optional<MinimumUncertainty> about(int index, const CurveProblem& curve, const CurveFit& fit, ErrorSource errors,
                                        double deviations, const UncertaintyOptions& options,
                                        std::optional<double>& best) {
  const Hyperelastic& solid = fit.minima[static_cast<std::size_t>(index)].solid;
  const CalibrationProblem problem = calibration_of(curve, fit.options, solid, errors);
  const SearchOptions search;
  const Minimum minimum = refine(problem, searched(problem, solid), {}, search);
  if (!best) best = minimum.deviance;
  const auto profiles =
      profile_intervals(problem, minimum, options.level, search, std::max(0.0, minimum.deviance - *best));
  if (profiles.empty()) return std::nullopt;
  MinimumUncertainty result;
  result.minimum = index;
  result.correlation = correlation(minimum);
  for (const auto& profile : profiles) {
    const auto& parameter = problem.parameters[static_cast<std::size_t>(profile.parameter)];
    result.parameters.push_back({.name = parameter.name,
                                 .unit = parameter.unit,
                                 .value = parameter.natural(minimum.searched[profile.parameter]),
                                 .interval = profile.interval,
                                 .searched_low = parameter.low,
                                 .searched_high = parameter.high,
                                 .identifiable = profile.identifiable && !hopeless(parameter, profile.interval),
                                 .bootstrap = {}});
  }
  result.small_strain_modulus = small_strain_interval(problem, solid, minimum, deviations);
  if (options.bootstrap > 0) add_bootstrap(result, problem, minimum, options);
  return result;
}

// The pieces of all minima, by parameter.
std::vector<ParameterRegion> region_of(const std::vector<MinimumUncertainty>& minima) {
  std::vector<ParameterRegion> region;
  const auto add = [&](const std::string& name, const std::string& unit, const Interval& piece) {
    const auto same = std::find_if(region.begin(), region.end(), [&](const auto& one) { return one.name == name; });
    if (same == region.end())
      region.push_back({name, unit, {piece}});
    else
      same->pieces.push_back(piece);
  };
  for (const MinimumUncertainty& one : minima) {
    for (const auto& parameter : one.parameters) add(parameter.name, parameter.unit, parameter.interval);
    if (one.small_strain_modulus) add("small_strain_mu", "Pa", *one.small_strain_modulus);
  }
  for (ParameterRegion& one : region) one.pieces = united(one.pieces);
  return region;
}

// A parameter that each piece would tell is unknown where all of them together are too wide.
void judge_by_the_region(Uncertainty& uncertainty) {
  for (MinimumUncertainty& one : uncertainty.minima)
    for (ParameterUncertainty& parameter : one.parameters)
      for (const ParameterRegion& region : uncertainty.region) {
        if (region.name != parameter.name) continue;
        const Interval all = hull(region.pieces);
        const bool modulus = !parameter.unit.empty();
        if (modulus ? all.low > 0 && all.high > hopeless_factor * all.low : all.high - all.low > hopeless_width)
          parameter.identifiable = false;
      }
}

}  // namespace

Uncertainty uncertainty_of(const CurveData& data, const CurveFit& fit, const UncertaintyOptions& options) {
  Uncertainty result;
  result.options = options;
  if (fit.minima.empty()) return result;
  CurveProblem problem = curve_problem(data, fit.options.residual, fit.options.weighting);
  weigh_as_the_loss_does(problem, fit);
  const auto& best = fit.minima[0].solid;
  const Eigen::VectorXd residual = residuals(problem, best);
  const double sum = residual.squaredNorm();
  const int parameters = static_cast<int>(best.terms.size()) * (fixed_alphas(fit.options.model).empty() ? 2 : 1);
  result.degrees_of_freedom = static_cast<int>(residual.size()) - parameters;
  if (result.degrees_of_freedom < 1 || lies_on_the_model(problem, sum)) {
    result.findings.push_back(result.degrees_of_freedom < 1
                                  ? "There are no more points than parameters: no intervals."
                                  : "The points lie on the model exactly: no scatter to make intervals of.");
    return result;
  }
  const double variance = sum / result.degrees_of_freedom;
  result.scatter = std::sqrt(variance * problem.objective_unit);
  result.neighbour_correlation = neighbour_correlation(problem, residual);
  result.errors = error_source(problem, fit.options, sum, result.degrees_of_freedom);
  const double highest = threshold(result.errors, options.level, result.degrees_of_freedom);
  std::optional<double> best_deviance;
  for (int k = 0; k < static_cast<int>(fit.minima.size()); ++k) {
    const double rise = residuals(problem, fit.minima[static_cast<std::size_t>(k)].solid).squaredNorm() - sum;
    if (rise > surely_out * highest * (result.errors == ErrorSource::standard_errors ? 1 : variance)) continue;
    if (auto one = about(k, problem, fit, result.errors, std::sqrt(highest), options, best_deviance))
      result.minima.push_back(std::move(*one));
  }
  result.region = region_of(result.minima);
  result.findings = uncertainty_findings(result, data, problem, fit);
  if (!even_in_alpha(problem)) judge_by_the_region(result);
  return result;
}

std::string word(ErrorSource errors) { return errors == ErrorSource::residuals ? "residuals" : "standard errors"; }

}  // namespace percal
