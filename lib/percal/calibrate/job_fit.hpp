// A model fitted to some of a job's shots and its curves; what it then says about any of them.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "percal/calibrate/job_model.hpp"
#include "percal/calibrate/result.hpp"

namespace percal {

struct JobFit {
  std::vector<int> shots;       // fitted
  std::vector<int> of_model;    // model parameter of each fitted one: those that no datum depends on are left out
  CalibrationProblem problem;   // data: the shots in order, then the curves
  std::vector<Minimum> minima;  // best first
  Eigen::VectorXd at;  // all of the model's parameters at the best minimum; those left out in the middle of their box

  const Minimum& best() const { return minima.front(); }
};

// What it costs to search in the rounds of training, and at the end. What goes side by side does so on so many threads.
SearchOptions quick_search(int threads = 1);
SearchOptions thorough_search();

// Global search and Ceres; from `start` (all of the model's parameters) Ceres alone. The speeds' errors count through the model's
// own exponent at the minimum. Throws BadInput where no shot and no curve is left.
JobFit fit_job(const CalibrationJob& job, const JobModel& model, const std::vector<int>& shots,
               const SearchOptions& options, const std::optional<Eigen::VectorXd>& start = {});

// The known standard deviation of ln depth of a shot: of the depth, and of the speed through the exponent.
double known_log_error(const MeasuredShot& shot, double speed_exponent);

// Degrees of freedom that tell the scatter of a group: at least what the group's own numbers leave when all parameters are theirs; of a
// group that only tells sides, as many as would tell it as well. 0 where the job says the scatter.
double scatter_freedom(const JobFit& fit, int group);

// Depth of each shot with the interval in which one such shot would lie, at the job's level: parameters, the model's own error, the
// scatter and the known error of the shot.
std::vector<ShotDepth> shot_depths(const CalibrationJob& job, const JobModel& model, const JobFit& fit,
                                   const std::vector<int>& shots);

// The stresses of each curve with the interval in which one such point would lie, at the job's level. Empty where the model has none.
std::vector<CurveStresses> curve_stresses(const CalibrationJob& job, const JobModel& model, const JobFit& fit);

// Over those of the depths whose measurement is a number.
Deviation deviation(const std::string& name, const CalibrationJob& job, const std::vector<ShotDepth>& depths);

// One for the fitted shots of each set and one for its others.
std::vector<Deviation> set_deviations(const CalibrationJob& job, const std::vector<ShotDepth>& depths);

// Shots of the job that all filters of a list choose: "COLUMN=VALUE" of the shot's row, or "set=NAME".
std::vector<int> chosen(const CalibrationJob& job, const ShotFilter& filter);
std::vector<int> used_shots(const CalibrationJob& job);
std::vector<int> all_shots(const CalibrationJob& job);
std::vector<MeasuredShot> shots_of(const CalibrationJob& job, const std::vector<int>& indices);

// Fitted to the chosen shots and the curves, then asked for the others.
CrossValidationResult cross_validate(const CalibrationJob& job, const JobModel& model, const CrossValidation& wanted,
                                     const SearchOptions& options);

// Each shot of the set from a fit to the set's others and all other used shots.
CrossValidationResult leave_one_out(const CalibrationJob& job, const JobModel& model, int set, const JobFit& full,
                                    const SearchOptions& options);

// Points of parameter space that the data do not rule out, where the emulator has to be right: `count` points (all of the model's
// parameters) of a Metropolis walk over exp(-objective / 2 / temperature) with the weights of the best minimum, thinned, the best
// point first. The walk's steps follow the fit's own covariance. The same seed gives the same points.
std::vector<Eigen::VectorXd> plausible_points(const JobFit& fit, int count, double temperature, unsigned seed);

DehnResult fit_dehn(const CalibrationJob& job);

}  // namespace percal
