// The isochoric second Piola stress of the incompressible solids in the homogeneous tests: what relaxes in the solver's target, and
// how a nominal stress is made of it where a face is free.                                       docs/theory/relaxation.md
#pragma once
#include <array>

#include "percal/material/homogeneous.hpp"
#include "percal/material/hyperelastic.hpp"

namespace percal {

// Two components: along the measured stress and along the free face's normal; in simple shear S_12 and S_22.
using IsochoricStress = std::array<double, 2>;

// A state of a test. Of an elastic solid the components are sums of two differences of principal Cauchy stresses; the nominal stress
// is a sum of the two components, whether or not they have relaxed.
struct IsochoricState {
  std::array<PrincipalPair, 2> differences;            // sigma_1 - sigma_2 and sigma_1 - sigma_3
  std::array<std::array<double, 2>, 2> of_difference;  // [component][difference]
  IsochoricStress to_nominal;
};

// Needs stretches > 0.
IsochoricState isochoric_state(const Strained& strained);

// Of a term with mu = 1, and its derivative with respect to alpha.
struct UnitIsochoric {
  IsochoricStress stress, by_alpha;
};
UnitIsochoric unit_isochoric(double alpha, const IsochoricState& state);

// Pa where the components are in Pa; the shear stress in simple shear.                                       (2), (3)
inline double nominal_of(const IsochoricStress& stress, const IsochoricState& state) {
  return state.to_nominal[0] * stress[0] + state.to_nominal[1] * stress[1];
}

}  // namespace percal
