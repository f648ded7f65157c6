// The programs that cards are written for, and one entry to their writers and readers.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "percal/card/card_material.hpp"
#include "percal/card/found_card.hpp"
#include "percal/card/unit_system.hpp"

namespace percal {

enum class Solver { lsdyna, abaqus, calculix, openradioss, febio, ansys };

const std::vector<std::string>& solver_words();  // "lsdyna", ... in the order of Solver
std::optional<Solver> solver_of_word(const std::string& word);

std::string write_card(Solver solver, const CardMaterial& material, const UnitSystem& units);

// Which program a card's text is for, by its keywords. Abaqus and CalculiX cards are the same text: abaqus.
std::optional<Solver> solver_of(const std::string& text);

// The unit system that a comment of a percal card names; nothing where there is none.
std::optional<UnitSystem> unit_system_of(const std::string& text);

// All Ogden materials of a file. Throws BadInput with file and line for what cannot be read.
std::vector<FoundCard> read_cards(Solver solver, const std::string& text, const std::string& file,
                                  const UnitSystem& units);

// The only one. Throws BadInput where there are several.
CardMaterial read_card(Solver solver, const std::string& text, const std::string& file, const UnitSystem& units);

}  // namespace percal
