// Dehn's closed form as a model of a job's shots, fitted by the same machinery: what the finite elements have to be better than.
#include "percal/invert/dehn.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "percal/calibrate/job_fit.hpp"

namespace percal {
namespace {

// Generous: the drag coefficient of a sphere is about 0.2, and strengths run from jelly to steel.
constexpr double lowest_c = 1e-3, highest_c = 10;
constexpr double lowest_s = 1e2, highest_s = 1e10;

// Materials with one and the same modulus are one to Dehn's model.
std::vector<int> strengths(const CalibrationJob& job, std::vector<FreeParameter>& parameters) {
  std::map<int, int> of_parameter;
  std::vector<int> place;
  for (const auto& material : job.materials) {
    const auto* shared = std::get_if<SharedParameter>(&material.mu);
    if (shared && of_parameter.contains(shared->index)) {
      place.push_back(of_parameter[shared->index]);
      continue;
    }
    place.push_back(static_cast<int>(parameters.size()));
    if (shared) of_parameter[shared->index] = place.back();
    parameters.push_back({.name = "s of " + material.name, .unit = "Pa", .low = lowest_s, .high = highest_s});
  }
  return place;
}

}  // namespace

JobModel dehn_model(const CalibrationJob& job) {
  JobModel model;
  model.parameters.push_back({.name = "c", .unit = "", .low = lowest_c, .high = highest_c});
  const std::vector<int> place = strengths(job, model.parameters);
  const auto shot_depth = [job, place](const Eigen::VectorXd& searched, const MeasuredShot& shot) {
    return dehn_depth({.radius = shot.radius,
                       .density = shot.density,
                       .speed = shot.speed,
                       .target_density = job.materials[shot.target].density},
                      std::exp(searched[0]), std::exp(searched[place[shot.target]]));
  };
  model.log_depths = [=](const Eigen::VectorXd& searched, std::span<const MeasuredShot> shots, Want) {
    ModelAnswer answer;
    answer.value.resize(static_cast<Eigen::Index>(shots.size()));
    answer.jacobian = Eigen::MatrixXd::Zero(answer.value.size(), searched.size());
    for (std::size_t k = 0; k < shots.size(); ++k) {
      const DehnDepth depth = shot_depth(searched, shots[k]);
      answer.value[k] = depth.log_depth;
      answer.jacobian(k, 0) = depth.gradient[0];
      answer.jacobian(k, place[shots[k].target]) = depth.gradient[1];
    }
    return answer;
  };
  // The depth depends on the speed through s/v^2 alone.
  model.speed_exponents = [=](const Eigen::VectorXd& searched, std::span<const MeasuredShot> shots) {
    Eigen::VectorXd exponents(static_cast<Eigen::Index>(shots.size()));
    for (std::size_t k = 0; k < shots.size(); ++k) exponents[k] = -2 * shot_depth(searched, shots[k]).gradient[1];
    return exponents;
  };
  return model;
}

namespace {

// What another number tells of the deepest depth, the only one that the closed form has: a sphere was at least as deep as it rests.
void bound_the_depth(MeasuredShot& shot) {
  const bool is_deeper = kind_of(shot.number).over_depth && shot.datum != ShotDatum::at_most;
  shot.number = RunNumber::depth;
  shot.datum = is_deeper ? ShotDatum::at_least : ShotDatum::none;
  shot.used = shot.used && is_deeper;
}

// The closed form is of spheres alone.
bool are_spheres(const CalibrationJob& job, const std::vector<int>& shots) {
  return std::ranges::none_of(shots, [&](int i) { return job.shots[i].body != nullptr; });
}

std::vector<int> spheres_among(const CalibrationJob& job, std::vector<int> shots) {
  std::erase_if(shots, [&](int i) { return job.shots[i].body != nullptr; });
  return shots;
}

std::vector<int> shots_of_set(const CalibrationJob& job, std::size_t set) {
  std::vector<int> shots = all_shots(job);
  std::erase_if(shots, [&](int i) { return job.shots[i].set != static_cast<int>(set); });
  return shots;
}

}  // namespace

DehnResult fit_dehn(const CalibrationJob& whole) {
  CalibrationJob job = whole;
  for (MeasuredShot& shot : job.shots) shot.used = shot.used && !shot.body;
  for (MeasuredShot& shot :
       job.shots) {  // its depth is that of a body without end: nothing of the speed left behind a layer
    if (shot.datum == ShotDatum::speed_left) {
      shot.datum = ShotDatum::passed;
      shot.depth = shot.layer_depth;
    }
    if (shot.number != RunNumber::depth) bound_the_depth(shot);
  }
  const JobModel model = dehn_model(job);
  const JobFit fit = fit_job(job, model, used_shots(job), thorough_search());
  DehnResult result;
  result.parameters = fit.problem.parameters;
  result.minimum = fit.best();
  result.intervals = region_intervals(fit.problem, fit.minima, job.level, quick_search());
  result.shots = shot_depths(job, model, fit, spheres_among(job, all_shots(job)));
  result.sets = set_deviations(job, result.shots);
  for (const CrossValidation& wanted : job.cross_validations)
    if (are_spheres(job, chosen(job, wanted.fit)) && are_spheres(job, chosen(job, wanted.predict)))
      result.cross_validations.push_back(cross_validate(job, model, wanted, thorough_search()));
  for (std::size_t s = 0; s < job.sets.size(); ++s)
    if (job.sets[s].leave_one_out && are_spheres(job, shots_of_set(job, s)))
      result.leave_one_out.push_back(leave_one_out(job, model, static_cast<int>(s), fit, quick_search()));
  return result;
}

}  // namespace percal
