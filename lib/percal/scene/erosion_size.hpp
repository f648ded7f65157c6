// The limit of strain that holds for a particle of its size.     docs/theory/target.md (13a)
#pragma once
#include "percal/scene/scene.hpp"

namespace percal {

// `strain`, or the one of particles smaller than a cell where this is one: by its diameter, a profile's width as it stands.
double strain_limit(double strain, const ErosionBySize& by_size, const ParticleScene& particle);

// The first layer's criterion with the limit that holds for this scene's particle.
Erosion erosion_in_force(const Scene& scene);

}  // namespace percal
