// Which run each choice of a particle gets.
#pragma once
#include "percal/impact/elastic_sphere.hpp"
#include "percal/impact/particle.hpp"

namespace percal {

template <class Particle>
struct RunOf;
template <>
struct RunOf<RigidSphere> {
  using type = SphereRun;
};
template <>
struct RunOf<RigidProfile> {
  using type = ProfileRun;
};
template <>
struct RunOf<ElasticSphere> {
  using type = ElasticSphereRun;
};

}  // namespace percal
