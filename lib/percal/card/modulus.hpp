// What a program calls the modulus of an Ogden term, and back. The one place of this conversion.   docs/formats/cards.md
#pragma once
#include <string>

#include "percal/material/ogden.hpp"

namespace percal {

// The number in a program's field for a term of W = (2 mu/alpha^2) (sum lambda^alpha - 3).
//   mu                 W = (2 field/alpha^2) (...)     Abaqus, CalculiX, OpenRadioss LAW82
//   two_mu_over_alpha  W = (field/alpha) (...)         LS-DYNA, OpenRadioss LAW42, Ansys
//   two_mu             W = (field/alpha^2) (...)       FEBio
enum class CardModulus { mu, two_mu_over_alpha, two_mu };

double modulus_field(const Ogden& term, CardModulus meaning);
Ogden term_of_field(double field, double alpha, CardModulus meaning);  // alpha not 0 with two_mu_over_alpha

std::string formula(CardModulus meaning);  // "mu", "2 mu/alpha", "2 mu"

}  // namespace percal
