#include "percal/calibrate/error_budget.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "percal/calibrate/shot_problem.hpp"
#include "percal/math/distributions.hpp"

namespace percal {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// For what moves along `gradient`: Student's t with the freedom that the estimated scatters leave it.
double quantile_of(const JobFit& fit, const VectorXd& gradient, double level) {
  const double upper = 0.5 + level / 2, freedom = effective_degrees_of_freedom(fit.problem, fit.best(), gradient);
  return std::isfinite(freedom) ? student_quantile(upper, freedom) : normal_quantile(upper);
}

Estimate estimate_of(double value, double log_deviation, double quantile) {
  return {value, {value * std::exp(-quantile * log_deviation), value * std::exp(quantile * log_deviation)}};
}

// Independent errors of the data by name, each a vector of standard deviations over the data.
struct Source {
  std::string name;
  VectorXd deviation;
};

std::vector<Source> data_sources(const CalibrationJob& job, const JobModel& model, const JobFit& fit) {
  const auto n = static_cast<Eigen::Index>(fit.problem.data.size());
  std::vector<Source> sources;
  const auto source = [&](const std::string& name) -> VectorXd& {
    for (auto& known : sources)
      if (known.name == name) return known.deviation;
    sources.push_back({name, VectorXd::Zero(n)});
    return sources.back().deviation;
  };
  const VectorXd exponents = model.speed_exponents(fit.at, shots_of(job, fit.shots));
  for (Eigen::Index i = 0; i < n; ++i) {
    const Datum& datum = fit.problem.data[static_cast<std::size_t>(i)];
    if (fit.best().scatter[datum.group] > 0)
      source("scatter: " + job.groups[datum.group].name)[i] = fit.best().scatter[datum.group];
    if (i >= static_cast<Eigen::Index>(fit.shots.size())) {
      if (datum.error > 0) source("stress: " + datum.label)[i] = datum.error;
      continue;
    }
    const MeasuredShot& shot = job.shots[fit.shots[static_cast<std::size_t>(i)]];
    if (shot.depth_error > 0) source("measured depth: " + job.sets[shot.set].name)[i] = shot.depth_error / shot.depth;
    if (shot.speed_error > 0)
      source("speed: " + job.sets[shot.set].name)[i] = exponents[i] * shot.speed_error / shot.speed;
  }
  return sources;
}

// Which data the minimum hangs on: a side that is met has no pull to speak of.
VectorXd active_data(const JobFit& fit) {
  VectorXd active = VectorXd::Ones(static_cast<Eigen::Index>(fit.problem.data.size()));
  for (Eigen::Index i = 0; i < active.size(); ++i)
    if (!fit.problem.data[static_cast<std::size_t>(i)].is_number() && fit.best().residual[i] == 0) active[i] = 0;
  return active;
}

}  // namespace

ErrorBudget error_budget(const CalibrationJob& job, const JobModel& model, const JobFit& fit,
                         const LogQuantity& quantity, const VectorXd& mesh_shift) {
  const ModelAnswer answer = fit.problem.model(fit.best().searched, Want::values_and_covariance);
  const auto sources = data_sources(job, model, fit);
  const auto n = answer.value.size();
  MatrixXd covariance = answer.covariance.size() > 0 ? answer.covariance : MatrixXd::Zero(n, n);
  for (const auto& source : sources) covariance.diagonal() += source.deviation.cwiseAbs2();
  covariance.diagonal().array() += 1e-12;
  const VectorXd active = active_data(fit);
  const MatrixXd weighted =
      active.asDiagonal() * covariance.ldlt().solve(MatrixXd(active.asDiagonal() * answer.jacobian));
  // d ln quantity = pull . d data
  const VectorXd pull = weighted * fit.best().information.completeOrthogonalDecomposition().solve(quantity.gradient);

  ErrorBudget budget{.quantity = quantity.name};
  double variance = 0;
  const auto add = [&](const std::string& name, double part) {
    budget.sources.push_back({name, std::sqrt(std::max(0.0, part)), part});
    variance += part;
  };
  for (const auto& source : sources) add(source.name, pull.cwiseProduct(source.deviation).squaredNorm());
  if (answer.covariance.size() > 0) add("solver noise and emulator", pull.dot(answer.covariance * pull));
  if (mesh_shift.size() > 0) {
    const double shift = pull.head(mesh_shift.size()).dot(mesh_shift);
    add("mesh", shift * shift);
  }
  if (quantity.own_error > 0) add(quantity.own_error_name, quantity.own_error * quantity.own_error);
  for (auto& source : budget.sources) source.share = variance > 0 ? source.share / variance : 0;
  std::stable_sort(budget.sources.begin(), budget.sources.end(),
                   [](const auto& a, const auto& b) { return a.share > b.share; });
  budget.standard_deviation = std::sqrt(variance);
  budget.total = estimate_of(quantity.value, budget.standard_deviation, quantile_of(fit, quantity.gradient, job.level));
  Eigen::Index most = 0;
  if (!fit.shots.empty()) {
    pull.head(static_cast<Eigen::Index>(fit.shots.size())).cwiseAbs().maxCoeff(&most);
    budget.most_influential = fit.problem.data[static_cast<std::size_t>(most)].label;
    budget.influence = pull[most];
  }
  return budget;
}

std::optional<Interval> interval_of(const JobModel& model, const JobFit& fit, const MaterialNumber& number,
                                    const std::vector<ProfileInterval>& profiles) {
  const auto* shared = std::get_if<SharedParameter>(&number);
  if (!shared) return std::nullopt;
  for (const ProfileInterval& profile : profiles)
    if (model.of_job[fit.of_model[profile.parameter]] == shared->index) return profile.interval;
  return std::nullopt;
}

namespace {

// Widened by what the number has besides, in squares of the logarithms, on each side of its own.
Estimate widened(const Estimate& of, double ratio, double own_error, double quantile) {
  const double down = std::hypot(std::log(of.value / of.interval.low), quantile * own_error);
  const double up = std::hypot(std::log(of.interval.high / of.value), quantile * own_error);
  Estimate estimate{of.value * ratio, of.interval};
  estimate.interval.low = of.value * ratio * std::exp(-down);
  estimate.interval.high = of.value * ratio * std::exp(up);
  return estimate;
}

}  // namespace

LogQuantity stiffness_quantity(const CalibrationJob& job, const Hypothesis& hypothesis, const JobModel& model,
                               const JobFit& fit, int material) {
  const CalibrationMaterial& m = job.materials[material];
  const auto natural = natural_values(job, hypothesis, model.of_job, fit.at);
  const MaterialAt at = material_at(job, hypothesis, material, natural);
  LogQuantity quantity;
  quantity.name = m.rate_factor ? "quasi-static E of " + m.name : "mu of " + m.name;
  quantity.value = m.rate_factor ? 3 * at.mu_true / *m.rate_factor : at.mu_true;
  quantity.own_error = m.rate_factor_error;
  quantity.own_error_name = "rate factor";
  quantity.gradient = VectorXd::Zero(static_cast<Eigen::Index>(fit.of_model.size()));
  for (std::size_t k = 0; k < fit.of_model.size(); ++k) {
    const int job_parameter = model.of_job[fit.of_model[k]];
    const FreeParameter& parameter = job.parameters[job_parameter].free;
    const auto is = [&](const MaterialNumber& number) {
      const auto* shared = std::get_if<SharedParameter>(&number);
      return shared && shared->index == job_parameter;
    };
    double& slope = quantity.gradient[static_cast<Eigen::Index>(k)];
    if (is(m.mu)) slope += parameter.logarithmic ? 1 : 1 / at.mu_as_given;
    if (is(m.alpha) && hypothesis.convention == ModulusConvention::mu_over_alpha)
      slope += (parameter.logarithmic ? at.alpha : 1) / at.alpha;
  }
  return quantity;
}

std::vector<MaterialModuli> material_moduli(const CalibrationJob& job, const Hypothesis& hypothesis,
                                            const JobModel& model, const JobFit& fit,
                                            const std::vector<ProfileInterval>& profiles) {
  const auto natural = natural_values(job, hypothesis, model.of_job, fit.at);
  std::vector<MaterialModuli> all;
  for (std::size_t i = 0; i < job.materials.size(); ++i) {
    const CalibrationMaterial& m = job.materials[i];
    const MaterialAt at = material_at(job, hypothesis, static_cast<int>(i), natural);
    const LogQuantity quantity = stiffness_quantity(job, hypothesis, model, fit, static_cast<int>(i));
    // ln MU1 = ln mu - ln alpha + ln 2
    VectorXd of_mu1 = quantity.gradient;
    if (const auto* alpha = std::get_if<SharedParameter>(&m.alpha))
      for (std::size_t k = 0; k < fit.of_model.size(); ++k)
        if (model.of_job[fit.of_model[k]] == alpha->index)
          of_mu1[static_cast<Eigen::Index>(k)] -=
              (job.parameters[alpha->index].free.logarithmic ? at.alpha : 1) / at.alpha;
    const auto deviation = [&](const VectorXd& g) {
      return std::sqrt(std::max(0.0, g.dot(fit.best().covariance * g)));
    };
    const double true_error = deviation(quantity.gradient), mu1_error = deviation(of_mu1);
    const double quantile = quantity.gradient.isZero() ? normal_quantile(0.5 + job.level / 2)
                                                       : quantile_of(fit, quantity.gradient, job.level);
    MaterialModuli moduli{.material = m.name, .curve_modulus = m.curve_modulus};
    const double mu1 = modulus_as_given(at.mu_true, at.alpha, ModulusConvention::mu_over_alpha);
    moduli.mu_true = estimate_of(at.mu_true, true_error, quantile);
    moduli.mu_over_alpha = estimate_of(mu1, mu1_error, quantile);
    if (const auto profile = interval_of(model, fit, m.mu, profiles)) {
      const bool is_mu1 = hypothesis.convention == ModulusConvention::mu_over_alpha;
      (is_mu1 ? moduli.mu_over_alpha : moduli.mu_true).interval = *profile;
    }
    if (m.rate_factor) {
      const double ratio = 3 / *m.rate_factor;
      moduli.youngs_quasi_static_true = widened(moduli.mu_true, ratio, m.rate_factor_error, quantile);
      moduli.youngs_quasi_static_over_alpha = widened(moduli.mu_over_alpha, ratio, m.rate_factor_error, quantile);
    }
    all.push_back(moduli);
  }
  return all;
}

}  // namespace percal
