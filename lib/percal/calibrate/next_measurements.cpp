#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "percal/calibrate/error_budget.hpp"

namespace percal {
namespace {

using Eigen::VectorXd;

constexpr int speeds = 6;                     // candidates for each ball and material
constexpr double slower = 0.6, faster = 1.4;  // of the slowest and the fastest shot there is
constexpr double curve_error = 0.05;          // of a modulus from a curve, relative; of an exponent, absolute over 10
constexpr int best_shots = 3, best_curves = 2;

// Shots of every ball into every material that has been shot, at speeds around those that there are.
std::vector<MeasuredShot> imagined_shots(const CalibrationJob& job) {
  std::vector<MeasuredShot> imagined;
  std::set<std::tuple<int, double, double>> seen;
  for (const MeasuredShot& shot : job.shots) {
    if (!seen.insert({shot.target, shot.radius, shot.density}).second) continue;
    double slowest = shot.speed, fastest = shot.speed;
    for (const MeasuredShot& other : job.shots) {
      if (other.target != shot.target) continue;
      slowest = std::min(slowest, other.speed);
      fastest = std::max(fastest, other.speed);
    }
    for (int k = 0; k < speeds; ++k) {
      MeasuredShot next = shot;
      next.datum = ShotDatum::depth;
      next.number = RunNumber::depth;
      next.speed = slower * slowest + (faster * fastest - slower * slowest) * k / (speeds - 1);
      if (shot.body)
        next.label = fmt::format("a shot of {} into {} at {:.0f} m/s", shot.body->name(), job.targets[shot.target].name,
                                 next.speed);
      else
        next.label = fmt::format("a shot of {:.3g} mm, {:.0f} kg/m3 into {} at {:.0f} m/s", 2e3 * shot.radius,
                                 shot.density, job.targets[shot.target].name, next.speed);
      imagined.push_back(next);
    }
  }
  return imagined;
}

// Of the mean of three shots: each has the scatter and the speed's error.
constexpr double repeats = 3;

}  // namespace

std::vector<Advice> advise(const CalibrationJob& job, const JobModel& model, const JobFit& fit,
                           const std::vector<LogQuantity>& quantities) {
  std::vector<Candidate> shots, curves;
  const auto imagined = imagined_shots(job);
  if (!imagined.empty()) {
    const ModelAnswer answer = model.log_depths(fit.at, imagined, Want::values);
    const VectorXd exponents = model.speed_exponents(fit.at, imagined);
    for (std::size_t k = 0; k < imagined.size(); ++k) {
      const auto i = static_cast<Eigen::Index>(k);
      const MeasuredShot& shot = imagined[k];
      if (std::exp(answer.value[i]) > shot.layer_depth) continue;  // it would pass through
      const double speed = exponents[i] * shot.speed_error / shot.speed, scatter = fit.best().scatter[shot.group];
      shots.push_back({"three times " + shot.label, answer.jacobian.row(i).transpose()(fit.of_model),
                       std::sqrt((scatter * scatter + speed * speed) / repeats)});
    }
  }
  // A curve gives a material's modulus and exponent directly.
  for (std::size_t k = 0; k < fit.of_model.size(); ++k) {
    const auto& parameter = job.parameters[model.of_job[fit.of_model[k]]];
    if (parameter.kind != ParameterKind::modulus && parameter.kind != ParameterKind::exponent) continue;
    VectorXd gradient = VectorXd::Zero(static_cast<Eigen::Index>(fit.of_model.size()));
    gradient[static_cast<Eigen::Index>(k)] = 1;
    const bool modulus = parameter.kind == ParameterKind::modulus;
    curves.push_back({fmt::format("a curve that gives {} to {}", parameter.free.name, modulus ? "5 %" : "0.5"),
                      gradient, modulus ? curve_error : 10 * curve_error});
  }
  std::vector<Advice> advice;
  for (const LogQuantity& quantity : quantities) {
    for (const auto& [kind, most] : {std::pair(&shots, best_shots), std::pair(&curves, best_curves)}) {
      const auto best = next_experiments(fit.best(), quantity.gradient, *kind);
      for (int k = 0; k < std::min(most, static_cast<int>(best.size())); ++k)
        advice.push_back({quantity.name + ": " + best[static_cast<std::size_t>(k)].label,
                          best[static_cast<std::size_t>(k)].width_ratio});
    }
  }
  return advice;
}

}  // namespace percal
