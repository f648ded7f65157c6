// Drucker's stability of an incompressible solid: no small increment of the true stresses does negative work on the
// increment of the logarithmic strains it makes. docs/theory/curves.md
#pragma once
#include <string>
#include <vector>

#include "percal/material/hyperelastic.hpp"

namespace percal {

// The stretches over which stability is looked at.
struct StretchRange {
  double low = 0.1, high = 10;  // 0 < low <= 1 <= high
};

// Whether the tangent of the two in-plane true stresses, the third being zero, is positive definite at the principal
// stretches lambda_1, lambda_2, 1/(lambda_1 lambda_2), given by their logarithms.                       (18)
bool is_stable(const Hyperelastic& solid, double log_1, double log_2);

// The stretches around 1 that are stable without a gap. An end that is the end of the range searched is `open`.
struct StableRange {
  Deformation deformation;
  double low = 1, high = 1;  // both 1 where the undeformed solid is unstable itself
  bool low_open = false, high_open = false;
};

// Uniaxial, equibiaxial and planar, in this order. Ends are found to 1e-10.
std::vector<StableRange> stable_ranges(const Hyperelastic& solid, const StretchRange& searched);

bool stable_throughout(const std::vector<StableRange>& ranges);

// For people and for a card's comment: "Drucker-stable in uniaxial, equibiaxial and planar deformation at stretches
// from 0.1 to 10; in a change of volume with U = K (J - 1)^2/2 and any K > 0". Where a range ends inside, each
// deformation is named.
std::string stability_sentence(const std::vector<StableRange>& ranges, const StretchRange& searched);

}  // namespace percal
