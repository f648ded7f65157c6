// One cube of one element, stretched along x with free sides, ready to run: what a card means in its own program.
// docs/formats/decks.md
#pragma once
#include <string>
#include <vector>

#include "percal/card/solver.hpp"

namespace percal {

// From stretch 1 to `stretch` in equal steps of displacement (OpenRadioss: of time).
struct UniaxialTest {
  double stretch = 2;   // > 0, not 1
  int increments = 20;  // 1 to 10000
};

struct DeckFile {
  std::string name;  // "skin.inp", "skin_0000.rad": the job and what the program wants after it
  std::string text;
};

// The name of a run from the name of a file, "cards/skin test.k" -> "skin_test": without folder, extension and
// "_0000", at most 40 characters, letters, digits, '_' and single '-' only, at least four long ('_' is added).
std::string deck_job(const std::string& file);

// The deck, one file for every program but OpenRadioss, which takes a starter and an engine file. `job` names the run
// and the program's output files; it is made fit by deck_job(). The deck asks for reaction force and displacement at
// every step, contains the card of write_card() as it stands, and opens with comments that say what to read off and
// which nominal stress to expect, in the deck's units. The cube's edge is one length unit; for CalculiX it may be ten
// or more (docs/formats/decks.md).
// Throws BadInput as write_card() does, for a test out of range (keys "--stretch", "--increments"), and for CalculiX
// where D1 = 2/K is below 1e-10 in these units (key "units"): CalculiX would take another number.
std::vector<DeckFile> uniaxial_deck_files(Solver solver, const CardMaterial& material, const UnitSystem& units,
                                          const UniaxialTest& test, const std::string& job);

// The first of these files, of a job called "uniaxial": the whole deck, for OpenRadioss the starter file.
std::string uniaxial_deck(Solver solver, const CardMaterial& material, const UnitSystem& units, double stretch,
                          int increments);

}  // namespace percal
