// OpenRadioss: /MAT/LAW42 (OGDEN), with /FAIL/TENSSTRAIN where the material erodes. docs/formats/cards.md
#pragma once
#include "percal/card/solver.hpp"

namespace percal {

// Mu_i = 2 mu/alpha and Nu of K/mu in fields of 20 columns; erosion at the first principal strain, engineering (S_Flag 13) or
// true (23), into which Green-Lagrange is converted.
std::string openradioss_card(const CardMaterial& material, const UnitSystem& units);

// The materials /MAT/LAW42 (or /MAT/OGDEN) and /MAT/LAW82 of a starter file; /FAIL/TENSSTRAIN with S_Flag 13 or 23 belongs to the
// material of its number; before version 2018 (/BEGIN) it compares lambda^2 - 1.
FoundMaterials read_openradioss_cards(const std::string& text, const std::string& file, const UnitSystem& units);

// Explicit, a starter and an engine file, fields of ten and twenty columns.
std::vector<DeckFile> openradioss_deck(const DeckOrder& order);

}  // namespace percal
