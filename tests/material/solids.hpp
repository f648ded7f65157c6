// What the tests of material share.
#pragma once
#include "percal/material/homogeneous.hpp"
#include "percal/material/hyperelastic.hpp"

namespace percal::test {

inline constexpr Deformation all_deformations[] = {Deformation::uniaxial,     Deformation::equibiaxial,
                                                   Deformation::planar,       Deformation::planar_held,
                                                   Deformation::simple_shear, Deformation::biaxial};

// W = c10 (I1 - 3) + c01 (I2 - 3).
inline Hyperelastic mooney_rivlin(double c10, double c01) { return {{{2 * c10, 2}, {2 * c01, -2}}}; }

}  // namespace percal::test
