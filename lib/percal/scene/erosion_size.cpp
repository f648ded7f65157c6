#include "percal/scene/erosion_size.hpp"

namespace percal {

double strain_limit(double strain, const ErosionBySize& by_size, const ParticleScene& particle) {
  const auto* small = std::get_if<SmallerThanCell>(&by_size);
  return small && 2 * particle.radius < small->cell ? small->strain : strain;
}

Erosion erosion_in_force(const Scene& scene) {
  Erosion erosion = scene.target.erosion;
  if (auto* strain = std::get_if<StrainErosion>(&erosion))
    strain->limit = strain_limit(strain->limit, scene.target.erosion_by_size, scene.particle);
  return erosion;
}

}  // namespace percal
