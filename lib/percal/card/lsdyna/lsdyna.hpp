// LS-DYNA: *MAT_OGDEN_RUBBER (077_O), with *MAT_ADD_EROSION where the material erodes. docs/formats/cards.md
#pragma once
#include "percal/card/solver.hpp"

namespace percal {

inline constexpr int lsdyna_short = 10, lsdyna_long = 20;  // columns of a field

// MU_i = 2 mu/alpha (negative for a negative alpha, and right), PR = nu of K/mu, MXEPS = the erosion strain in the measure it was
// given in. Fields of ten columns where they hold every number, and K, to 1e-5; else the long format, fields of twenty columns,
// which a '+' behind the keyword says. Throws BadInput besides where twenty columns of PR do not tell the bulk modulus to 1 %
// (K above some 1e13 mu).
std::string lsdyna_card(const CardMaterial& material, const UnitSystem& units);

// The materials *MAT_OGDEN_RUBBER or *MAT_077_O, in fixed fields of ten or twenty columns or separated by commas; N = 0 only.
// The strain measure of MXEPS comes from the comment "strain measure of MXEPS: ..."; without it MXEPS is passed over.
FoundMaterials read_lsdyna_cards(const std::string& text, const std::string& file, const UnitSystem& units);

// Implicit statics, fields of ten columns.
std::vector<DeckFile> lsdyna_deck(const DeckOrder& order);

}  // namespace percal
