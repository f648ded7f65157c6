// What the march and its kernel take from a problem before the first step.
#pragma once
#include <vector>

#include "percal/impact/kernel.hpp"
#include "percal/mesh/graded.hpp"
#include "percal/problem/problem.hpp"

namespace percal {

GradedMesh mesh_of(const Problem& problem);
MaterialConstants constants(const Problem& problem);  // of the first layer
std::vector<MaterialConstants> constants_of_layers(const Problem& problem);

// Contact stiffness per mass of each layer over the first one's: kappa/dt_ref^2 with its own mu and density.
std::vector<double> contact_stiffness_ratios(const Problem& problem);

struct StepLimits {
  // Stable step of the undeformed square element, the least of all layers, without the time-step factor.
  double first_step;
  double time_step_factor;  // the problem's, or less where the impact is supersonic
  // kappa/dt_ref^2, dt_ref the first step at K = 50 mu: neither K nor the factor enters. Of the first layer.
  double contact_stiffness_per_mass;
  double largest_contact_stiffness_per_mass;  // of all layers
};
StepLimits step_limits(const Problem& problem);

}  // namespace percal
