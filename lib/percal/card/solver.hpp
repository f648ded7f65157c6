// The programs that cards are written for: one table, one room of this folder for each.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "percal/card/card_material.hpp"
#include "percal/card/uniaxial_deck.hpp"
#include "percal/card/unit_system.hpp"

namespace percal {

// A material that a reader found in a file. Density and bulk modulus may be missing (card_material.hpp).
struct FoundCard {
  CardMaterial material;
  int line;                               // of its keyword
  std::vector<std::string> ignored = {};  // what of it was passed over, one text each
  bool erodes_otherwise = false;          // by limits that are among `ignored`
};

// A material that has no Ogden constants.
struct OtherMaterial {
  int line;
  std::string keyword;  // "/MAT/LAW69"
  std::string law;      // what it is, and what can be done with it; empty where percal does not know
};

struct FoundMaterials {
  std::vector<FoundCard> cards;
  std::vector<OtherMaterial> others = {};
};

// What a room offers. Every function converts between SI and the program's convention in the given units.
struct Solver {
  std::string word;                // "lsdyna"
  std::vector<std::string> signs;  // starts of lines that no other has, in upper case without blanks
  // The card. Throws BadInput as check() does, and for what the program's fields cannot carry.
  std::string (*card)(const CardMaterial& material, const UnitSystem& units);
  // All materials of a file whose numbers are in `units`. Throws BadInput with file and line for what cannot be read.
  FoundMaterials (*read)(const std::string& text, const std::string& file, const UnitSystem& units);
  std::vector<DeckFile> (*deck)(const DeckOrder& order);
};

const std::vector<Solver>& solvers();

std::vector<std::string> solver_words();

// Throws BadInput (key "solver") with the words there are.
const Solver& solver_named(const std::string& word);

// Which program a card's text is for, by its keywords; null where it has none. Abaqus and CalculiX cards have the same ones:
// abaqus.
const Solver* solver_of(const std::string& text);

// The unit system that a comment of a percal card names; nothing where there is none.
std::optional<UnitSystem> unit_system_of(const std::string& text);

// The one with this name; with an empty name the only one. Throws BadInput with the names there are, or with what else stands there.
FoundCard chosen_card(const FoundMaterials& found, const std::string& name, const std::string& file);

// A card or deck as a user has it, and what the user says of it. An empty word stands for what the text itself says: the
// solver by its keywords, the units by the comment of a percal card.
struct CardFile {
  std::string text, file;
  std::string solver, units;
  std::string name;  // of one of several materials
};

struct ReadCard {
  FoundCard found;
  std::string solver, units;
  std::vector<std::string> warnings = {};  // of numbers that wrong units make
};

ReadCard read_card(const CardFile& card);

}  // namespace percal
