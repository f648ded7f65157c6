// FEBio 4: the Material section, and MeshAdaptor where the material erodes. docs/formats/cards.md
#pragma once
#include "percal/card/solver.hpp"

namespace percal {

// The sections, to stand inside <febio_spec version="4.0">, MeshAdaptor after Mesh: c1 = 2 mu, m1 = alpha, k = K. Erosion by a mesh
// adaptor on the first principal Green-Lagrange strain, of the <Elements> block with the material's name.
std::string febio_card(const CardMaterial& material, const UnitSystem& units);

// The materials "Ogden" and "Ogden unconstrained" of such sections or of a whole FEBio file.
FoundMaterials read_febio_cards(const std::string& text, const std::string& file, const UnitSystem& units);

// An XML file of format 4.0.
std::vector<DeckFile> febio_deck(const DeckOrder& order);

}  // namespace percal
