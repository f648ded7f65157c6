// The two systems of Guha 2009: what is shot where in the tests. mu is true: LS-DYNA's 15 MPa and 113 kPa times
// alpha/2.
#pragma once
#include "percal/scaling/system.hpp"

namespace percal {

inline System gold_in_skin() {
  System gold;
  gold.particle = "gold";
  gold.target = "skin";
  gold.radius = 1e-6;
  gold.particle_density = 16800;
  gold.particle_modulus = 79e9;
  gold.speed = 651;
  gold.target_density = 1000;
  gold.mu = 15e6 * 8.5 / 2;
  gold.alpha = 8.5;
  gold.erosion_strain = 0.7;
  gold.depth = 75e-6;
  gold.width = 5e-6;
  gold.penetration = 26e-6;
  return gold;
}

// What is known of the model before similarity settles the rest.
inline System steel_ball() {
  System steel;
  steel.particle = "steel";
  steel.target = "gelatin";
  steel.radius = 1.59e-3;
  steel.particle_density = 7800;
  steel.particle_modulus = 210e9;
  steel.speed = 83;
  return steel;
}

inline System steel_in_gelatin() {
  auto steel = steel_ball();
  steel.target_density = 464;
  steel.mu = 113e3 * 8.5 / 2;
  steel.alpha = 8.5;
  steel.erosion_strain = 0.7;
  steel.depth = 75 * 1.59e-3;
  steel.width = 5 * 1.59e-3;
  return steel;
}

}  // namespace percal
