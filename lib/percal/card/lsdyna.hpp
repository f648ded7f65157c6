// LS-DYNA: *MAT_OGDEN_RUBBER (077_O), with *MAT_ADD_EROSION where the material erodes. docs/formats/cards.md
#pragma once
#include <string>

#include "percal/card/card_material.hpp"
#include "percal/card/unit_system.hpp"

namespace percal {

// The card in fields of ten columns. MU1 = 2 mu/alpha (negative for a negative alpha, and right), PR = nu of K/mu,
// MXEPS = the erosion strain in the measure it was given in. Throws BadInput as check() does, and where ten columns of
// PR no longer tell the bulk modulus to 1 % (K outside of some 1e-6 to 1e7 mu).
std::string lsdyna_card(const CardMaterial& material, const UnitSystem& units);

// The material of such a card, whose numbers are in `units`: name and comments are left empty. Reads what lsdyna_card()
// writes and one-term cards like it (N = 0, fields of ten columns); the strain measure comes from the comment
// "strain measure of MXEPS: ...". Throws BadInput with `file` and line.
CardMaterial read_lsdyna_card(const std::string& text, const std::string& file, const UnitSystem& units);

}  // namespace percal
