#include "percal/powder/powder.hpp"

#include <algorithm>
#include <cmath>

namespace percal {
namespace {

enum class Leading { radius, density, speed };

// The widest, speed before radius before density where they are as wide.
Leading leading_of(const Powder& powder) {
  const double radius = log_deviation_of(powder.radius), density = log_deviation_of(powder.density),
               speed = log_deviation_of(powder.speed);
  if (speed >= radius && speed >= density) return Leading::speed;
  return radius >= density ? Leading::radius : Leading::density;
}

}  // namespace

double SpeedBySize::at(double size) const {
  const auto after = std::ranges::upper_bound(radius, size) - radius.begin();
  if (after == 0) return speed.front();
  if (after == static_cast<std::ptrdiff_t>(radius.size())) return speed.back();
  const double along = std::log(size / radius[after - 1]) / std::log(radius[after] / radius[after - 1]);
  return speed[after - 1] * std::pow(speed[after] / speed[after - 1], along);
}

PowderParticle middle_particle(const Powder& powder) {
  const double radius = median_of(powder.radius), factor = powder.by_size ? powder.by_size->at(radius) : 1;
  return {radius, median_of(powder.density), factor * median_of(powder.speed)};
}

PowderParticle middle_of(const ParticleClass& one) {
  return {std::sqrt(one.low.radius * one.high.radius), std::sqrt(one.low.density * one.high.density),
          std::sqrt(one.low.speed * one.high.speed)};
}

std::vector<ParticleClass> classes_of(const Powder& powder, const Fineness& fineness) {
  const Leading leading = leading_of(powder);
  const Distribution* all[] = {&powder.radius, &powder.density, &powder.speed};
  const auto spread = std::ranges::count_if(all, [](const Distribution* one) { return !is_one_value(*one); });
  const int cells = fineness.cells / std::max(1, static_cast<int>(spread));
  const auto cut = [&](const Distribution& distribution, Leading which, double power) {
    return which == leading ? cells_of(distribution, cells, power) : nodes_of(distribution, fineness.values, power);
  };
  const auto particle = [&](double radius, double density, double speed) {
    return PowderParticle{radius, density, powder.by_size ? speed * powder.by_size->at(radius) : speed};
  };
  const auto sizes = cut(powder.radius, Leading::radius, 3), densities = cut(powder.density, Leading::density, 1),
             speeds = cut(powder.speed, Leading::speed, 0);
  std::vector<ParticleClass> classes;
  double mass = 0;
  for (const DistributionCell& density : densities)
    for (const DistributionCell& speed : speeds)
      for (const DistributionCell& size : sizes) {
        classes.push_back({particle(size.low, density.low, speed.low), particle(size.high, density.high, speed.high),
                           size.share * density.share * speed.share, size.moment * density.moment * speed.share});
        mass += classes.back().mass;
      }
  for (ParticleClass& one : classes) one.mass /= mass;
  return classes;
}

std::vector<ParticleClass> scaled(std::vector<ParticleClass> classes, const PowderParticle& factors) {
  for (ParticleClass& one : classes)
    for (PowderParticle* end : {&one.low, &one.high}) {
      end->radius *= factors.radius;
      end->density *= factors.density;
      end->speed *= factors.speed;
    }
  return classes;
}

}  // namespace percal
