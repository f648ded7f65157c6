// What a material card says, in SI and in percal's own convention. The writers convert at the edge.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "percal/base/error.hpp"
#include "percal/material/conventions.hpp"

namespace percal {

// Largest principal strain at which an element is removed.
struct CardErosion {
  double limit;  // > 0
  StrainMeasure measure;
};

// W = (2 mu/alpha^2) (sum lambda_bar_i^alpha - 3) + U(J), U ~ K (J - 1)^2 / 2 near J = 1.
struct CardMaterial {
  std::string name;     // any text; each writer makes it fit its format
  double density;       // kg/m3
  double mu_true;       // small-strain shear modulus, Pa
  double alpha;         // not 0
  double bulk_modulus;  // Pa
  std::optional<CardErosion> erosion;
  std::vector<std::string> comments;  // sources of the data, one text each; written as comment lines
};

// Throws BadInput for a number that no card can carry: not finite, not positive, alpha = 0. The message names
// place.file and the key of the result file ("card.mu_true_Pa" where place.key is "card").
void check(const CardMaterial& material, const Place& place);

}  // namespace percal
