#pragma once
#include <string>

#include "percal/card/card_material.hpp"
#include "percal/card/unit_system.hpp"

namespace percal {

// What the card calls its modulus field, for the comments: "MU1 = 2 mu/alpha" and its value.
struct ModulusField {
  std::string meaning;
  double in_pascals;
};

// The comment lines that open every card: version, name, unit system, convention of the modulus with both numbers, bulk
// modulus, density, the stretches at which the solid is stable. `prefix` starts each line ("$", "**").
std::string card_header(const std::string& prefix, const CardMaterial& material, const UnitSystem& units,
                        const ModulusField& modulus);

// "0.7 engineering = 0.530628 true = 0.945 Green-Lagrange (stretch 1.7)"
std::string in_all_measures(const CardErosion& erosion);

// The comments of the material, one or more lines each.
std::string card_sources(const std::string& prefix, const CardMaterial& material);

}  // namespace percal
