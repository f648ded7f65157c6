// Nominal stress of a card's material in the uniaxial test, at its own bulk modulus.
#pragma once
#include "percal/card/card_material.hpp"

namespace percal {

// U(J), each K (J - 1)^2 / 2 near J = 1:
//   quadratic    K (J - 1)^2 / 2     Abaqus, CalculiX, Ansys (D1 = 2/K), OpenRadioss LAW42
//   logarithmic  K (ln J)^2 / 2      FEBio
//   difference   K (J - 1 - ln J)    LS-DYNA
enum class VolumetricLaw { quadratic, logarithmic, difference };

// Pa. The sides are free: J solves sigma_2(J) = 0 by bisection in ln J.        docs/formats/decks.md
// Needs a stretch > 0 and a material that check() takes.
double uniaxial_stress(const CardMaterial& material, double stretch, VolumetricLaw law);

// K without end. Pa.
double incompressible_uniaxial_stress(const CardMaterial& material, double stretch);

}  // namespace percal
