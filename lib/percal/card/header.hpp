// The comments of a card, the same for all programs: what was written, in which units and convention, and how well it is
// known.
#pragma once
#include <string>

#include "percal/card/card_material.hpp"
#include "percal/card/modulus.hpp"
#include "percal/card/unit_system.hpp"

namespace percal {

// What differs between the programs. `prefix` starts each comment line ("$", "**").
struct CardDialect {
  std::string prefix;
  std::string modulus_name;  // "MU", followed by the number of the term: MU1
  CardModulus modulus;
  std::string volumetric;  // a sentence: the field of the bulk modulus and the law
};

// Version, name, unit system, convention of the moduli with both numbers, bulk modulus, volumetric law, density, the
// stretches at which the solid is stable, intervals, error of the fit, data files with their SHA-256, and the material's own
// comments.
std::string card_comments(const CardDialect& dialect, const CardMaterial& material, const UnitSystem& units);

// The intervals of the parameters, the error of the fit and the data files, one text each.
std::vector<std::string> provenance(const CardMaterial& material);

// "0.7 engineering = 0.530628 true = 0.945 Green-Lagrange (stretch 1.7)"
std::string in_all_measures(const CardErosion& erosion);

// A name for programs that take ASCII letters, digits and `others` only: everything else is '_', blanks at the ends go, and
// an empty name is "Ogden".
std::string ascii_name(const std::string& name, const std::string& others, std::size_t most_characters);

}  // namespace percal
