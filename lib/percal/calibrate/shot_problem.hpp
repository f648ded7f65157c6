// One shot of a job at one set of material numbers, as a scene and as a dimensionless problem to run.
#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "percal/calibrate/job.hpp"
#include "percal/predict/sphere_shot.hpp"
#include "percal/problem/problem.hpp"

namespace percal {

// Natural values of all the job's parameters: those that the hypothesis holds, and `fitted` ones at a point of their searched scales.
std::vector<double> natural_values(const CalibrationJob& job, const Hypothesis& hypothesis,
                                   const std::vector<int>& fitted, const Eigen::VectorXd& searched);

// A material's numbers at natural values of the job's parameters.
struct MaterialAt : LayerMaterial {
  double mu_as_given = 0;  // Pa
};
MaterialAt material_at(const CalibrationJob& job, const Hypothesis& hypothesis, int material,
                       const std::vector<double>& natural);

// The same for what is shot into, a material with its covers.
CoveredMaterial target_at(const CalibrationJob& job, const Hypothesis& hypothesis, const CalibrationTarget& target,
                          const std::vector<double>& natural);

// The run that answers for a shot, in SI and without dimensions.
Scene shot_scene(const CalibrationJob& job, const MeasuredShot& shot, const CoveredMaterial& material,
                 double elements_per_radius);
Problem shot_problem(const CalibrationJob& job, const MeasuredShot& shot, const CoveredMaterial& material,
                     double elements_per_radius);

}  // namespace percal
