// Abaqus and CalculiX: *MATERIAL with *DENSITY and *HYPERELASTIC, OGDEN, N=1. docs/formats/cards.md
#pragma once
#include <string>

#include "percal/card/card_material.hpp"
#include "percal/card/unit_system.hpp"

namespace percal {

// The card, which Abaqus and CalculiX read alike: mu as it is, alpha, D1 = 2/K, fields of at most 20 characters. It has
// no erosion: a comment says so and gives the stretch at which elements should go. Throws BadInput as check() does.
std::string abaqus_card(const CardMaterial& material, const UnitSystem& units);

// The material of such a card, whose numbers are in `units`; without erosion and comments. Throws BadInput with `file`
// and line.
CardMaterial read_abaqus_card(const std::string& text, const std::string& file, const UnitSystem& units);

}  // namespace percal
