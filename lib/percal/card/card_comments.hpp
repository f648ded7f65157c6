// The comments of a card, the same for all programs: what was written, in which units and convention, and how well it is
// known.
#pragma once
#include <string>

#include "percal/card/card_material.hpp"
#include "percal/card/unit_system.hpp"

namespace percal {

// What differs between the programs. `prefix` starts each comment line ("$", "**").
struct CardDialect {
  std::string prefix;
  std::string modulus_name;  // "MU", followed by the number of the term: MU1
  CardModulus modulus;
  std::string volumetric;  // a sentence: the field of the bulk modulus and the law
};

// Version, name, unit system, convention of the moduli with both numbers, bulk modulus, volumetric law, density, the element
// size of the erosion strain, the stretches at which the solid is stable, intervals, error of the fit, data files with their SHA-256, and the material's own
// comments.
std::string card_comments(const CardDialect& dialect, const CardMaterial& material, const UnitSystem& units);

// "no erosion in this card", and where elements should go if the material has a limit.
std::string no_erosion_comment(const CardMaterial& material);

// "0.7 engineering = 0.530628 true = 0.945 Green-Lagrange (stretch 1.7)"
std::string in_all_measures(const CardErosion& erosion);

// "erosion strain 0.58 for elements of 0.1 radii (0.1 um)"; without a size that none is known.
std::string element_size_of(const CardErosion& erosion);

// The stretches at which the solid is stable, a sentence.
std::string stability_of(const CardMaterial& material);

}  // namespace percal
