#include "percal/card/solver.hpp"

#include <fmt/core.h>

#include <sstream>

#include "percal/card/abaqus/abaqus.hpp"
#include "percal/card/ansys/ansys.hpp"
#include "percal/card/febio/febio.hpp"
#include "percal/card/lsdyna/lsdyna.hpp"
#include "percal/card/openradioss/openradioss.hpp"
#include "percal/card/read_deck.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

std::string names_of(const std::vector<FoundCard>& cards) {
  std::string names;
  for (const FoundCard& card : cards)
    names += fmt::format("{}'{}' (line {})", names.empty() ? "" : ", ", card.material.name, card.line);
  return names;
}

// "no Ogden material, but /MAT/LAW69 (line 1): Ogden from a curve: fit the curve with percal fit"
std::string none_but(const std::vector<OtherMaterial>& others) {
  std::string text = "no Ogden material";
  for (const OtherMaterial& one : others)
    text += fmt::format("{}{} (line {}){}", &one == &others.front() ? ", but " : "; ", one.keyword, one.line,
                        one.law.empty() ? "" : ": " + one.law);
  return text;
}

}  // namespace

const std::vector<Solver>& solvers() {
  static const std::vector<Solver> all = {
      {"lsdyna", {"*MAT_", "*KEYWORD"}, lsdyna_card, read_lsdyna_cards, lsdyna_deck},
      {"abaqus", {"*MATERIAL", "*HYPERELASTIC"}, abaqus_card, read_abaqus_cards, abaqus_deck},
      {"calculix", {}, calculix_card, read_calculix_cards, calculix_deck},
      {"openradioss", {"/MAT/", "#RADIOSS"}, openradioss_card, read_openradioss_cards, openradioss_deck},
      {"febio", {"<MATERIAL", "<FEBIO_SPEC"}, febio_card, read_febio_cards, febio_deck},
      {"ansys", {"TB,HYPE", "MPDATA,", "MP,"}, ansys_card, read_ansys_cards, ansys_deck}};
  return all;
}

std::vector<std::string> solver_words() {
  std::vector<std::string> words;
  for (const Solver& solver : solvers()) words.push_back(solver.word);
  return words;
}

const Solver& solver_named(const std::string& word) {
  for (const Solver& solver : solvers())
    if (solver.word == word) return solver;
  throw BadInput(Place{.file = "", .line = 0, .key = "solver"}, in_quotes(word), listed(solver_words()));
}

const Solver* solver_of(const std::string& text) {
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    const std::string start = upper_without_blanks(line);
    for (const Solver& solver : solvers())
      for (const std::string& sign : solver.signs)
        if (start.starts_with(sign)) return &solver;
  }
  return nullptr;
}

std::optional<UnitSystem> unit_system_of(const std::string& text) {
  const std::string name = text_after(text, "unit system: ", " \r");
  if (name.empty()) return std::nullopt;
  try {
    return unit_system(name);
  } catch (const BadInput&) {
    return std::nullopt;
  }
}

FoundCard chosen_card(const FoundMaterials& found, const std::string& name, const std::string& file) {
  const auto& [cards, others] = found;
  if (cards.empty())
    throw BadInput(Place{file, others.empty() ? 0 : others.front().line, ""}, none_but(others), "a card with one");
  std::vector<FoundCard> chosen;
  for (const FoundCard& card : cards)
    if (name.empty() || card.material.name == name) chosen.push_back(card);
  if (chosen.size() == 1) return chosen.front();
  if (name.empty())
    throw BadInput(Place{file, 0, ""}, fmt::format("{} materials: {}", cards.size(), names_of(cards)),
                   "one of them by its name (--name)");
  throw BadInput(Place{file, 0, "--name"}, fmt::format("{} materials '{}'", chosen.size(), name), names_of(cards));
}

ReadCard read_card(const CardFile& card) {
  const Solver* solver = card.solver.empty() ? solver_of(card.text) : &solver_named(card.solver);
  if (!solver)
    throw BadInput({card.file, 0, ""}, "no keyword of a solver that percal knows",
                   "a card for " + listed(solver_words()) + ", or its solver by name (--solver)");
  const auto units = card.units.empty() ? unit_system_of(card.text) : unit_system(card.units);
  if (!units)
    throw BadInput({card.file, 0, "units"}, "no comment that names the unit system",
                   "the units of its numbers by name (--units), such as mm-t-s-MPa");
  FoundCard found = chosen_card(solver->read(card.text, card.file, *units), card.name, card.file);
  std::vector<std::string> warnings;
  for (const std::string& one : implausible(found.material))
    warnings.push_back(one + " They were read in " + units->name + ".");
  return {std::move(found), solver->word, units->name, warnings};
}

}  // namespace percal
