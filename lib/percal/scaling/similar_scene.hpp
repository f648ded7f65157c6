// Scenes as systems of the pi groups, and the scene that is similar to another one.            docs/theory/scaling.md
#pragma once
#include "percal/scaling/system_toml.hpp"
#include "percal/scene/scene.hpp"

namespace percal {

// Particle and first layer of a scene, with the conventions that it speaks in. Response (penetration, rate, time) is not in it.
SystemInput system_of(const Scene& scene);

// The prototype's scene with the model's numbers: geometry by Eq. 3-1, time by pi10; what has no dimension - erosion,
// volumetric ratio, mesh, solver settings, replicates - is the prototype's. Throws BadInput where a system lacks a number.
Scene similar_scene(const Scene& prototype_scene, const System& prototype, const System& model);

}  // namespace percal
