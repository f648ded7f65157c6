// What the emulator's covariance sees of the inputs: the first, ln pi4, becomes the logarithm of the impact's energy density over
// that which a tension test puts into the material until it erodes. Depths depend on that number most.   docs/theory/emulator.md (2)
#pragma once
#include <Eigen/Core>

#include "percal/invert/emulator.hpp"

namespace percal {

// W/mu of a uniaxial tension test at an engineering strain > 0, (2/alpha^2) (l^alpha + 2 l^(-alpha/2) - 3) with l = 1 + strain:
// its logarithm, and that one's derivatives.
struct LogErosionEnergy {
  double value, by_alpha, by_strain;
};
LogErosionEnergy log_erosion_energy(double alpha, double strain);

// ln pi4 - ln(W/mu), and the other inputs as they are.
Eigen::VectorXd depth_features(const SphereInputs& at);

// Of a function with this gradient with respect to the features.
Eigen::VectorXd by_inputs(const SphereInputs& at, const Eigen::VectorXd& by_features);

}  // namespace percal
