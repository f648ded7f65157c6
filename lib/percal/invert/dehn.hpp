// The closed form to be better than: Dehn's (Poncelet) penetration of a sphere. Resisting force F = A (c rho_t v^2 + s).
// docs/theory/calibration.md
#pragma once
#include <array>

namespace percal {

struct DehnShot {
  double radius = 0;          // m
  double density = 0;         // kg/m3, of the sphere
  double speed = 0;           // m/s
  double target_density = 0;  // kg/m3
};

struct DehnDepth {
  double log_depth = 0;              // ln m
  std::array<double, 2> gradient{};  // with respect to ln c, ln s
};

// P = m/(2 c rho_t A) ln(1 + c rho_t v^2/s), m/A = (4/3) a rho_p. c > 0, s > 0 in Pa.
DehnDepth dehn_depth(const DehnShot& shot, double c, double s);

}  // namespace percal
