// A solid of finite bulk modulus stretched along one axis with free sides, in the volumetric laws of the programs. docs/formats/decks.md
#pragma once
#include <optional>

#include "percal/card/card_material.hpp"

namespace percal {

// U(J), each K (J - 1)^2 / 2 near J = 1:
//   quadratic    K (J - 1)^2 / 2     Abaqus, CalculiX, Ansys (D1 = 2/K), OpenRadioss LAW42
//   logarithmic  K (ln J)^2 / 2      FEBio
//   difference   K (J - 1 - ln J)    LS-DYNA
enum class SolverLaw { quadratic, logarithmic, difference };

// All need a stretch > 0 and a material that check() takes.

// Nominal stress at the material's own bulk modulus, Pa. J solves sigma_2(J) = 0 by bisection in ln J.
double uniaxial_stress(const CardMaterial& material, double stretch, SolverLaw law);

// K without end. Pa.
double incompressible_uniaxial_stress(const CardMaterial& material, double stretch);

// Stretch of the sides, (J/stretch)^(1/2).
double side_stretch(const CardMaterial& material, double stretch, SolverLaw law);

// The first stretch on the way from 1 to `end` at which the largest principal stretch, that of the sides in compression, is `limit` > 1;
// nothing where it stays below.
std::optional<double> stretch_where_largest_is(double limit, const CardMaterial& material, double end, SolverLaw law);

}  // namespace percal
