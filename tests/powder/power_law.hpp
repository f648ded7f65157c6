// Depths that go as a power of each of a particle's numbers: lognormal powders then have lognormal depths, in closed form.
#pragma once
#include <cmath>
#include <vector>

#include "percal/powder/dose.hpp"

namespace percal::test {

inline double normal_cdf(double z) { return 0.5 * std::erfc(-z / std::sqrt(2.0)); }

// ln depth = ln(20 um) + by_radius ln(r/1 um) + by_density ln(rho/10000 kg/m3) + by_speed ln(v/600 m/s) + the point's offset
struct PowerLaw {
  double by_radius = 1, by_density = 0.7, by_speed = 1.3;
  std::vector<double> offsets{0};

  double log_depth(const PowderParticle& particle) const {
    return std::log(20e-6) + by_radius * std::log(particle.radius / 1e-6) +
           by_density * std::log(particle.density / 1e4) + by_speed * std::log(particle.speed / 600);
  }
  ForwardModel model(double scatter = 0, double error = 0) const {
    const auto depths = [law = *this](std::span<const PowderParticle> particles) {
      Eigen::MatrixXd found(law.offsets.size(), particles.size());
      for (std::size_t k = 0; k < law.offsets.size(); ++k)
        for (std::size_t i = 0; i < particles.size(); ++i)
          found(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(i)) =
              law.log_depth(particles[i]) + law.offsets[k];
      return found;
    };
    const auto errors = [error](std::span<const PowderParticle> particles) {
      return Eigen::VectorXd(Eigen::VectorXd::Constant(static_cast<Eigen::Index>(particles.size()), error));
    };
    return {.log_depths = depths, .errors = errors, .scatter = scatter};
  }
};

// Sizes alone would do for the sum; all three differ.
inline Powder lognormal_powder(double radius = 0.5, double density = 0.1, double speed = 0.2) {
  return {.radius = Lognormal{1e-6, radius}, .density = Lognormal{1e4, density}, .speed = Lognormal{600, speed}};
}

// ln depth of such a powder: normal, with these.
struct NormalDepth {
  double mean, deviation;
  double share_above(double depth) const { return normal_cdf((std::log(depth) - mean) / deviation); }
  double mean_depth() const { return std::exp(mean + deviation * deviation / 2); }
  double deviation_of_depth() const { return mean_depth() * std::sqrt(std::expm1(deviation * deviation)); }
};
inline NormalDepth closed_form(const PowerLaw& law, const Powder& powder, By by, double scatter = 0) {
  const double r = log_deviation_of(powder.radius), d = log_deviation_of(powder.density),
               v = log_deviation_of(powder.speed);
  const double weighted = by == By::mass ? 3 * law.by_radius * r * r + law.by_density * d * d : 0;
  return {law.log_depth(middle_particle(powder)) + weighted,
          std::hypot(law.by_radius * r, law.by_density * d, std::hypot(law.by_speed * v, scatter))};
}

}  // namespace percal::test
