// Ansys Mechanical APDL: TB,HYPER with the Ogden option and MP,DENS. docs/formats/cards.md
#pragma once
#include <string>
#include <vector>

#include "percal/card/card_material.hpp"
#include "percal/card/found_card.hpp"
#include "percal/card/unit_system.hpp"

namespace percal {

// TBDATA holds mu_1 = 2 mu/alpha, alpha_1, ..., d_1 = 2/K (and zeros for d_2, d_3), six constants a command. No erosion: a
// comment says so. Throws BadInput as check() does.
std::string ansys_card(const CardMaterial& material, const UnitSystem& units);

// The materials of such commands. Names are in comments "! name: ..." or "material N". Throws BadInput with `file` and line.
std::vector<FoundCard> read_ansys_cards(const std::string& text, const std::string& file, const UnitSystem& units);

}  // namespace percal
