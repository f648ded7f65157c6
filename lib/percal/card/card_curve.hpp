// The stress-stretch curve that a card means, and the same as a table for programs that read tables.
#pragma once
#include <string>
#include <vector>

#include "percal/card/card_material.hpp"
#include "percal/card/unit_system.hpp"
#include "percal/material/homogeneous.hpp"

namespace percal {

// `points` amounts from low to high at equal steps: stretches, in simple shear gamma.
struct CurveRange {
  Deformation deformation = Deformation::uniaxial;
  double low = 0.5, high = 2;
  int points = 31;
};

struct CurvePoint {
  double amount;
  double stress;  // nominal, Pa; in simple shear the shear stress
};

// Of the incompressible solid (K without limit). Throws BadInput for a range that is none, stretches that are not positive,
// fewer than 2 or more than 100000 points, and planar_held and biaxial deformation.
std::vector<CurvePoint> card_curve(const CardMaterial& material, const CurveRange& range);

// The curve as CSV, which percal fit reads: comment lines "# ...", columns mode, stretch (or gamma) and nominal stress with its
// unit in the header. 15 digits.
std::string csv_card(const CardMaterial& material, const UnitSystem& units, const CurveRange& range);

}  // namespace percal
