// Abaqus and CalculiX: *MATERIAL with *DENSITY and *HYPERELASTIC, OGDEN, N=1 to 3. docs/formats/cards.md
#pragma once
#include "percal/card/solver.hpp"

namespace percal {

// CalculiX takes a smaller D1 for 0, whatever the units.
inline constexpr double calculix_least_d1 = 1e-10;

// mu and alpha of every term, D1 = 2/K (and zeros for D2, D3), fields of at most 20 characters. It has no erosion: a comment
// says so and gives the stretch at which elements should go.
std::string abaqus_card(const CardMaterial& material, const UnitSystem& units);

// The same, with 1e20 for D2 and D3, since CalculiX replaces zeros. Throws BadInput besides where D1 is below 1e-10 in these
// units (key "units"): CalculiX would take it for 0.
std::string calculix_card(const CardMaterial& material, const UnitSystem& units);

// Of both, without erosion and comments; one material for each temperature. Where D1 is 0 (or below 1e-10) Abaqus takes the solid as
// incompressible, CalculiX puts 0.1/mu in its place.
FoundMaterials read_abaqus_cards(const std::string& text, const std::string& file, const UnitSystem& units);
FoundMaterials read_calculix_cards(const std::string& text, const std::string& file, const UnitSystem& units);

// The same model, each with its own element, step and output.
std::vector<DeckFile> abaqus_deck(const DeckOrder& order);
std::vector<DeckFile> calculix_deck(const DeckOrder& order);

}  // namespace percal
