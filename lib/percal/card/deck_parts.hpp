// What the six uniaxial decks share: the cube, its faces, and the comments that a deck opens with.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "percal/card/card_material.hpp"
#include "percal/card/uniaxial_deck.hpp"
#include "percal/card/uniaxial_stress.hpp"
#include "percal/card/unit_system.hpp"

namespace percal {

// One deck to write. `card` is the text of write_card().
struct DeckOrder {
  const CardMaterial& material;
  const UnitSystem& units;
  UniaxialTest test;
  std::string job;
  std::string card;
};

// A corner of the cube; 1-based number as the decks have it.
struct CubeNode {
  int number;
  double x, y, z;
};

// In the order that all six programs want for a brick: round the face z = 0, then round the face z = edge.
std::array<CubeNode, 8> cube_nodes(double edge);

// Nodes of the faces. The first three are planes of symmetry, x1 is moved along x.
using Face = std::array<int, 4>;
inline constexpr Face face_x0{1, 4, 5, 8}, face_y0{1, 2, 5, 6}, face_z0{1, 2, 3, 4}, face_x1{2, 3, 6, 7};

// "1, 4, 5, 8" with separator ", ".
std::string listed(const Face& face, const std::string& separator);

// A number without columns: at most 20 characters, with a point.
std::string deck_text(double value);

// Displacement of the face x1 at the end, in length units of the deck.
double final_displacement(const DeckOrder& order, double edge);

// The comments that a deck opens with, a paragraph each: the cube, what to read off, the nominal stress to expect at
// the end and halfway (at the card's bulk modulus with `law`, and incompressible), and where the card's erosion takes
// the element away before the end.
std::vector<std::string> deck_comments(const DeckOrder& order, double edge, VolumetricLaw law);

// What stands in `card` after `start` up to one of `ends` or the end of the line: the name or number by which a deck
// refers to the material. Empty where there is no `start`.
std::string text_after(const std::string& card, const std::string& start, const std::string& ends);

// The writers, one for each program.
std::vector<DeckFile> abaqus_deck(const DeckOrder& order);
std::vector<DeckFile> calculix_deck(const DeckOrder& order);
std::vector<DeckFile> lsdyna_deck(const DeckOrder& order);
std::vector<DeckFile> openradioss_deck(const DeckOrder& order);
std::vector<DeckFile> febio_deck(const DeckOrder& order);
std::vector<DeckFile> ansys_deck(const DeckOrder& order);

}  // namespace percal
