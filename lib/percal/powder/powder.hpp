// A powder: what its particles are and how fast they arrive, as distributions, and as classes of particles.  docs/theory/powder.md
#pragma once
#include <optional>
#include <vector>

#include "percal/powder/distribution.hpp"

namespace percal {

struct PowderParticle {
  double radius = 0, density = 0, speed = 0;  // m, kg/m3, m/s
};

// The mass per area that decides whether skin is breached: density times speed times radius, kg/(m s).
inline double impact_parameter(const PowderParticle& particle) {
  return particle.density * particle.speed * particle.radius;
}

// Speeds that a device gives to particles of these radii; a power law from one to the next, the outermost beyond them.
struct SpeedBySize {
  std::vector<double> radius, speed;  // m, rising; m/s
  double at(double radius) const;
};

// Radii, densities and speeds that know nothing of each other, but for speeds by size. All by number.
struct Powder {
  Distribution radius = Lognormal{};
  Distribution density = Lognormal{};
  Distribution speed = Lognormal{};  // beside by_size: what the speed of that size is multiplied with
  std::optional<SpeedBySize> by_size = {};
};

// The particle of all medians.
PowderParticle middle_particle(const Powder& powder);

// Particles between two: shares of the number and of the mass spread evenly over the logarithms on the straight line from one to the other.
struct ParticleClass {
  PowderParticle low, high;
  double number = 0, mass = 0;
};

PowderParticle middle_of(const ParticleClass& one);

// Into how many cells the widest of the distributions is cut, by how many others have a spread, too; and how many values these have.
struct Fineness {
  int cells = 480, values = 12;
};

// Shares of number and of mass add up to 1 each.                                                                     (4)
std::vector<ParticleClass> classes_of(const Powder& powder, const Fineness& fineness);

// The particles with every number multiplied by that of `factors`. A speed by size goes with the size over the middle one.
std::vector<ParticleClass> scaled(std::vector<ParticleClass> classes, const PowderParticle& factors);

}  // namespace percal
