// Ansys Mechanical APDL: TB,HYPER with the Ogden option and MP,DENS. docs/formats/cards.md
#pragma once
#include "percal/card/solver.hpp"

namespace percal {

// TBDATA holds mu_1 = 2 mu/alpha, alpha_1, ..., d_1 = 2/K (and zeros for d_2, d_3), six constants a command. No erosion: a
// comment says so.
std::string ansys_card(const CardMaterial& material, const UnitSystem& units);

// The materials of such commands, of which four letters tell the name, and of CDB files; one for each temperature. Names are in
// comments "! name: ..." or "material N".
FoundMaterials read_ansys_cards(const std::string& text, const std::string& file, const UnitSystem& units);

// One SOLID185, a static analysis, and a table of stretch and nominal stress.
std::vector<DeckFile> ansys_deck(const DeckOrder& order);

}  // namespace percal
