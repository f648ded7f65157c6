// OpenRadioss: /MAT/LAW42 (OGDEN), with /FAIL/TENSSTRAIN where the material erodes. docs/formats/cards.md
#pragma once
#include <string>
#include <vector>

#include "percal/card/card_material.hpp"
#include "percal/card/found_card.hpp"
#include "percal/card/unit_system.hpp"

namespace percal {

// Mu_i = 2 mu/alpha and Nu of K/mu in fields of 20 columns; erosion at the first principal strain, engineering (S_Flag 13) or
// true (23), into which Green-Lagrange is converted. Throws BadInput as check() does.
std::string openradioss_card(const CardMaterial& material, const UnitSystem& units);

// The materials /MAT/LAW42 (or /MAT/OGDEN) and /MAT/LAW82 of a starter file; /FAIL/TENSSTRAIN with S_Flag 13 or 23 belongs to the
// material of its number. Throws BadInput with `file` and line.
std::vector<FoundCard> read_openradioss_cards(const std::string& text, const std::string& file,
                                              const UnitSystem& units);

}  // namespace percal
