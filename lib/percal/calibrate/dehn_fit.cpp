#include "percal/calibrate/dehn_fit.hpp"

#include "percal/calibrate/hypothesis.hpp"

namespace percal {

DehnResult fit_dehn(const CalibrationJob& job) {
  const JobModel model = dehn_model(job);
  const JobFit fit = fit_job(job, model, used_shots(job), thorough_search());
  DehnResult result;
  result.parameters = fit.problem.parameters;
  result.minimum = fit.best();
  result.intervals = profile_intervals(fit.problem, fit.best(), job.level, quick_search());
  std::vector<int> all;
  for (std::size_t i = 0; i < job.shots.size(); ++i) all.push_back(static_cast<int>(i));
  result.shots = shot_depths(job, model, fit, all);
  result.sets = set_deviations(job, result.shots);
  for (const CrossValidation& wanted : job.cross_validations)
    result.cross_validations.push_back(cross_validate(job, model, wanted, thorough_search()));
  for (std::size_t s = 0; s < job.sets.size(); ++s)
    if (job.sets[s].leave_one_out)
      result.leave_one_out.push_back(leave_one_out(job, model, static_cast<int>(s), fit, quick_search()));
  return result;
}

}  // namespace percal
