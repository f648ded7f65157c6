// What a one-point quad needs to know of its undeformed shape. docs/verification/closed_forms.md describes the element.
#pragma once
#include <array>

#include "percal/mesh/quads.hpp"
#include "percal/problem/choices.hpp"

namespace percal {

// In an axisymmetric Geometry x = r, y = z, and volumes, masses and forces are those of one radian; in plane strain those of a unit
// thickness. The displacement gradient of an element is its mean over the element's volume V = int w dA, with w = r or 1:
//   F = 1 + sum_a u_a (dx_a, dy_a),   dx_a = (1/V) int dN_a/dx w dA,   hoop stretch = 1 + sum_a hoop_a u_r,a,
//   hoop_a = (1/V) int N_a dA  (0 in plane strain).
// The mean of what is constant is exact: rigid motions and linear fields make the F that they have, on any quad, and forces
// V P grad balance at every inner node of a homogeneous state (Flanagan and Belytschko, Int. J. Numer. Methods Eng. 17, 1981).
struct QuadForm {
  std::array<double, 4> dx, dy, hoop;
  std::array<double, 4> mode;  // the hourglass pattern: 0 against every linear field; +1 -1 +1 -1 on a parallelogram
  std::array<double, 4> mass_share;  // int N_a w dA: lumped mass at density 1
  double volume;                     // V
  double area;                       // int dA
};

// Needs a convex quad with corners counter-clockwise, and in axisymmetry none left of the axis.
QuadForm quad_form(const std::array<Point, 4>& corners, Geometry geometry);

}  // namespace percal
