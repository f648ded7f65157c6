// A model of a job's data over its fitted parameters: depths of shots, stresses of curves. The finite-element model answers by an
// emulator, Dehn's by its closed form; fits, cross-validations and predictions do not know which.
#pragma once
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "percal/calibrate/job.hpp"
#include "percal/campaign/run_numbers.hpp"

namespace percal {

struct JobModel {
  std::vector<FreeParameter> parameters;
  std::vector<int> of_job;  // job parameter of each; empty where they are not the job's

  // ln of what is measured of shots into the job's materials (MeasuredShot::number) in m, of those that were fired and of others.
  std::function<ModelAnswer(const Eigen::VectorXd& searched, std::span<const MeasuredShot> shots, Want want)>
      log_depths;
  // d ln of it / d ln speed.
  std::function<Eigen::VectorXd(const Eigen::VectorXd& searched, std::span<const MeasuredShot> shots)> speed_exponents;
  // Stresses over their scales (see curve_data), all curves one after the other; empty where the model has none.
  std::function<ModelAnswer(const Eigen::VectorXd& searched, Want want)> stresses;
};

// The job's parameters that the hypothesis leaves free; depths by the emulators on a mesh of element size h. Without them, which is for
// a job without shots, there are none.
JobModel finite_element_model(const CalibrationJob& job, const Hypothesis& hypothesis,
                              std::optional<Emulators> emulators, double h);

// One drag coefficient c for all, one strength s for each material that has a parameter of its own for the modulus.
JobModel dehn_model(const CalibrationJob& job);

// A stress is fitted as a multiple of its own size, or of this share of the largest of its curve where it is smaller.
inline constexpr double smallest_stress_share = 0.02;
std::vector<double> stress_scales(const MeasuredCurve& curve);

// The curves as data: stress over scale, with the point's own standard error where its file has one, else the curve's.
std::vector<Datum> curve_data(const CalibrationJob& job);

}  // namespace percal
