#include "percal/invert/dehn.hpp"

#include <cmath>

namespace percal {

// With q = c rho_t v^2/s and m/A = (4/3) a rho_p:
//   P = (2/3) a (rho_p/rho_t) ln(1 + q)/c,   d ln P/d ln s = -q/((1 + q) ln(1 + q)),   d ln P/d ln c = -1 - d ln P/d ln s
DehnDepth dehn_depth(const DehnShot& shot, double c, double s) {
  const double q = c * shot.target_density * shot.speed * shot.speed / s;
  const double logarithm = std::log1p(q);
  const double strength = -q / ((1 + q) * logarithm);
  return {.log_depth = std::log(2.0 / 3 * shot.radius * shot.density / shot.target_density * logarithm / c),
          .gradient = {-1 - strength, strength}};
}

}  // namespace percal
