// One shot of a job at one set of material numbers: as a dimensionless problem to run, and as inputs of the emulator.
#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "percal/calibrate/job.hpp"
#include "percal/invert/emulator.hpp"
#include "percal/problem/problem.hpp"

namespace percal {

// Natural values of all the job's parameters: those that the hypothesis holds, and `fitted` ones at a point of their searched scales.
std::vector<double> natural_values(const CalibrationJob& job, const Hypothesis& hypothesis,
                                   const std::vector<int>& fitted, const Eigen::VectorXd& searched);

// A material's numbers at natural values of the job's parameters.
struct MaterialAt {
  double density = 0;      // kg/m3
  double mu_as_given = 0;  // Pa
  double mu_true = 0;      // Pa
  double alpha = 0;
  double erosion_strain = 0;                  // engineering: the critical stretch less 1
  std::optional<double> erosion_length = {};  // m
};
MaterialAt material_at(const CalibrationJob& job, const Hypothesis& hypothesis, int material,
                       const std::vector<double>& natural);

// Elements per radius of a mesh with so many elements in the material's erosion length, or per radius where it has none.
double mesh_of(const MeasuredShot& shot, const MaterialAt& material, double elements);

// The run that answers for a shot, in SI and without dimensions. A sphere is rigid, as in every published run; K/mu keeps the
// Mach number below 0.3.
Scene shot_scene(const CalibrationJob& job, const MeasuredShot& shot, const MaterialAt& material,
                 double elements_per_radius);
Problem shot_problem(const CalibrationJob& job, const MeasuredShot& shot, const MaterialAt& material,
                     double elements_per_radius);

// The emulator's inputs for a shot: those of its problem (inputs_of), but for the problem's rounding, over which nothing could be
// differentiated. With their derivatives.
struct ShotInputs {
  SphereInputs at;
  Eigen::Matrix<double, sphere_inputs, 4> by_material;  // ln mu_true, alpha, erosion strain, ln erosion length
  Eigen::Vector<double, sphere_inputs> by_log_speed;
};
ShotInputs shot_inputs(const MeasuredShot& shot, const MaterialAt& material);

}  // namespace percal
