#include "percal/invert/depth_features.hpp"

#include <cmath>

namespace percal {
namespace {

enum Input { log_pi4 = 0, alpha_input = 2, strain_input = 3 };

constexpr double vanishing_alpha = 1e-4;  // below it rounding would spoil the general formula

}  // namespace

LogErosionEnergy log_erosion_energy(double alpha, double strain) {
  const double stretch = 1 + strain, log_stretch = std::log1p(strain);
  if (std::abs(alpha) < vanishing_alpha)  // W/mu = (3/2) ln^2 l + alpha (1/4) ln^3 l
    return {std::log(1.5) + 2 * std::log(log_stretch) + alpha * log_stretch / 6, log_stretch / 6,
            2 / (stretch * log_stretch)};
  const double up = std::exp(alpha * log_stretch), across = std::exp(-0.5 * alpha * log_stretch);
  const double sum = std::expm1(alpha * log_stretch) + 2 * std::expm1(-0.5 * alpha * log_stretch);
  return {std::log(2 / (alpha * alpha) * sum), (up - across) * log_stretch / sum - 2 / alpha,
          alpha * (up - across) / (stretch * sum)};
}

Eigen::VectorXd depth_features(const SphereInputs& at) {
  Eigen::VectorXd features = Eigen::Map<const Eigen::VectorXd>(at.data(), sphere_inputs);
  features[log_pi4] -= log_erosion_energy(at[alpha_input], at[strain_input]).value;
  return features;
}

Eigen::VectorXd by_inputs(const SphereInputs& at, const Eigen::VectorXd& by_features) {
  const LogErosionEnergy energy = log_erosion_energy(at[alpha_input], at[strain_input]);
  Eigen::VectorXd gradient = by_features;
  gradient[alpha_input] -= by_features[log_pi4] * energy.by_alpha;
  gradient[strain_input] -= by_features[log_pi4] * energy.by_strain;
  return gradient;
}

}  // namespace percal
