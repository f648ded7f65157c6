// Abaqus and CalculiX: *MATERIAL with *DENSITY and *HYPERELASTIC, OGDEN, N=1 to 3. docs/formats/cards.md
#pragma once
#include <string>
#include <vector>

#include "percal/card/card_material.hpp"
#include "percal/card/found_card.hpp"
#include "percal/card/unit_system.hpp"

namespace percal {

// The card: mu and alpha of every term, D1 = 2/K (and zeros for D2, D3), fields of at most 20 characters. It has no erosion: a
// comment says so and gives the stretch at which elements should go. Throws BadInput as check() does.
std::string abaqus_card(const CardMaterial& material, const UnitSystem& units);

// The same, with 1e20 for D2 and D3, since CalculiX replaces zeros. Throws BadInput besides where D1 is below 1e-10 in these
// units (key "units"): CalculiX would take it for 0.
std::string calculix_card(const CardMaterial& material, const UnitSystem& units);

// The materials of such a file, whose numbers are in `units`, without erosion and comments. Keywords that belong to no
// hyperelastic material are passed over. Throws BadInput with `file` and line.
std::vector<FoundCard> read_abaqus_cards(const std::string& text, const std::string& file, const UnitSystem& units);

}  // namespace percal
