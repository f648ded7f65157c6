// One cube of one element, stretched along x with free sides, ready to run: what a card means in its own program.
// docs/formats/decks.md
#pragma once
#include <array>
#include <string>
#include <vector>

#include "percal/card/card_material.hpp"
#include "percal/card/uniaxial_stress.hpp"
#include "percal/card/unit_system.hpp"

namespace percal {

struct Solver;

// From stretch 1 to `stretch` in equal steps of displacement (OpenRadioss: of time).
struct UniaxialTest {
  double stretch = 2;   // > 0, not 1
  int increments = 20;  // 1 to 10000
};

struct DeckFile {
  std::string name;  // "skin.inp", "skin_0000.rad": as the user says, or the job and what the program wants after it
  std::string text;
};

// The deck, one file for every program but OpenRadioss, which takes a starter and an engine file. `file` is its name, with or without
// folder and ending, and names the run and the program's output files (deck_job()); empty: "uniaxial". The deck asks for reaction force and displacement at
// every step, contains the solver's card as it stands, and opens with comments that say what to read off and which
// nominal stress to expect, in the deck's units. The cube's edge is one length unit; for CalculiX it may be ten or more
// (docs/formats/decks.md).
// Throws BadInput as the solver's card does, and for a test out of range (keys "--stretch", "--increments").
std::vector<DeckFile> uniaxial_deck(const Solver& solver, const CardMaterial& material, const UnitSystem& units,
                                    const UniaxialTest& test, const std::string& file);

// The name of a run from the name of a file, "cards/skin test.k" -> "skin_test": without folder, extension and
// "_0000", at most 40 characters, letters, digits, '_' and single '-' only.
std::string deck_job(const std::string& file);

// For the solvers that write it.

// One deck to write. `card` is the text of the solver's card.
struct DeckOrder {
  const CardMaterial& material;
  const UnitSystem& units;
  UniaxialTest test;
  std::string job;
  std::string file;  // of the deck, without its folder; empty: the job and the program's own ending
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
std::vector<std::string> fields_of(const Face& face);

// The name of the deck's file, and a name as an argument of a shell.
std::string deck_name(const DeckOrder& order, const std::string& ending);
std::string as_argument(const std::string& file);

// Displacement of the face x1 at the end, in length units of the deck.
double final_displacement(const DeckOrder& order, double edge);

// The comments that a deck opens with, a paragraph each: the cube, what to read off, the nominal stress to expect at
// the end and halfway (at the card's bulk modulus with `law`, and incompressible), where the card's erosion takes
// the element away before the end, and what the solver says of itself.
std::string deck_comments(const DeckOrder& order, double edge, SolverLaw law, const std::string& prefix,
                          const std::vector<std::string>& of_solver);

// What stands in `card` after `start` up to one of `ends` or the end of the line: the name or number by which a deck
// refers to the material. Empty where there is no `start`.
std::string text_after(const std::string& card, const std::string& start, const std::string& ends);

}  // namespace percal
