#include <fmt/core.h>

#include <array>
#include <cmath>
#include <map>
#include <sstream>

#include "percal/card/ansys/ansys.hpp"
#include "percal/card/card_text.hpp"
#include "percal/card/read_deck.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

constexpr const char* name_comment = "! name: ";
constexpr std::size_t letters_compared = 4;  // of commands and labels

constexpr std::array other_options{
    LawSign{"MOON", as_mooney_rivlin},  LawSign{"NEO", "neo-Hooke: the Ogden term alpha = 2"},
    LawSign{"YEOH", "Yeoh rubber"},     LawSign{"BOYC", "Arruda-Boyce rubber"},
    LawSign{"GENT", "Gent rubber"},     LawSign{"POLY", "a polynomial of the invariants"},
    LawSign{"BLAT", "Blatz-Ko rubber"}, LawSign{"FOAM", "Ogden's foam, whose terms are in full stretches"},
    LawSign{"RESP", rubber_from_curve}};

struct Number {
  std::string text;
  int line;
};

// The constants of a TB,HYPER table at one temperature; `at` names it where there are several.
struct Constants {
  int line;
  std::string at;
  std::map<int, Number> of = {};
};

struct Table {
  std::string material;
  int line;
  int terms;
  std::vector<Constants> sets;
  int next = 1;  // where TBDATA goes on
};

// Another command with a material's number.
struct Addition {
  std::string material, label, written;
  int line;
};

struct Commands {
  std::map<std::string, std::string> names;  // of the materials
  std::map<std::string, Number> densities;
  std::vector<Table> tables;
  std::vector<OtherMaterial> other_laws;
  std::vector<Addition> additions;
};

std::string argument(const std::vector<std::string>& arguments, std::size_t i) {
  return i < arguments.size() ? trimmed(arguments[i]) : "";
}

// As APDL compares it: "HYPER" and "hype" are HYPE.
std::string compared(const std::string& word) { return upper_without_blanks(word).substr(0, letters_compared); }

int whole(const std::string& text, int missing, const Place& place) {
  if (text.empty()) return missing;
  const double number = deck_number(text, place);
  if (number != std::floor(number) || std::abs(number) > 1e6) throw BadInput(place, "'" + text + "'", "a whole number");
  return static_cast<int>(number);
}

Table table_of(const std::vector<std::string>& arguments, const std::string& file, int line) {
  const int terms = whole(argument(arguments, 4), 1, Place{file, line, "NPTS"});
  if (terms < 1 || terms > static_cast<int>(most_card_terms))
    throw BadInput(Place{file, line, "NPTS"}, std::to_string(terms), "1 to 3 terms");
  return {argument(arguments, 2), line, terms, {{line, ""}}};
}

// Reads a file's commands one by one.
struct Reader {
  const std::string& file;
  Commands found = {};
  std::string name = {};  // of the comment above
  bool in_table = false;

  void tb(const std::vector<std::string>& arguments, const std::string& written, int line) {
    const std::string label = compared(argument(arguments, 1)), option = compared(argument(arguments, 5));
    in_table = label == "HYPE" && option == "OGDE";
    if (in_table) {
      found.tables.push_back(table_of(arguments, file, line));
    } else if (label == "HYPE") {
      found.other_laws.push_back({line, written, law_of(other_options, option)});
    } else {
      found.additions.push_back({argument(arguments, 2), label, written, line});
    }
  }

  // A new temperature; the first one names the constants that begin there.
  void tbtemp(const std::vector<std::string>& arguments, int line) {
    Table& table = found.tables.back();
    table.next = 1;
    if (table.sets.size() == 1 && table.sets[0].of.empty()) table.sets.clear();
    table.sets.push_back({line, argument(arguments, 1)});
  }

  void tbdata(const std::vector<std::string>& arguments, int line) {
    Table& table = found.tables.back();
    table.next = whole(argument(arguments, 1), table.next, Place{file, line, "TBDATA"});
    for (std::size_t i = 2; i < arguments.size(); ++i, ++table.next)
      if (!is_blank(arguments[i])) table.sets.back().of[table.next] = {argument(arguments, i), line};
  }

  // MP,DENS,MAT,C0,C1,...; MPDATA,DENS,MAT,STLOC,C1,...; of CDB files MPDATA,R5.0,NUM,DENS,MAT,STLOC,C1,...
  void mp(std::vector<std::string> arguments, bool table, const std::string& written, int line) {
    if (upper_without_blanks(argument(arguments, 1)).starts_with("R") && arguments.size() > 3)
      arguments.erase(arguments.begin() + 1, arguments.begin() + 3);
    const std::string label = compared(argument(arguments, 1)), material = argument(arguments, 2);
    const std::size_t first = table ? 4 : 3;
    if (label != "DENS") {
      found.additions.push_back({material, label, written, line});
      return;
    }
    found.densities[material] = {argument(arguments, first), line};
    for (std::size_t i = first + 1; i < arguments.size(); ++i)
      if (!is_blank(arguments[i]) && field_number(arguments[i]) != 0.0) {
        found.additions.push_back({material, label, "temperatures of " + written, line});
        break;
      }
    if (!name.empty()) found.names[material] = name;
  }

  void command(const std::string& written, int line) {
    const auto arguments = split_at(',', written);
    const std::string command = compared(arguments.front());
    if (command == "TB") tb(arguments, written, line);
    if (command == "MP" || command == "MPDA") mp(arguments, command == "MPDA", written, line);
    if (!in_table) return;
    if (command == "TBTE" || command == "TBFI") tbtemp(arguments, line);
    if (command == "TBDA") tbdata(arguments, line);
  }
};

Commands parse(const std::string& text, const std::string& file) {
  Reader reader{file};
  std::istringstream stream(text);
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    if (line.starts_with(name_comment)) reader.name = trimmed(line.substr(std::string(name_comment).size()));
    for (const std::string& one : split_at('$', line.substr(0, line.find('!'))))
      if (!is_blank(one)) reader.command(trimmed(one), number);
  }
  return reader.found;
}

double constant(const Constants& constants, int index, const std::string& file, const std::string& name) {
  const auto found = constants.of.find(index);
  if (found == constants.of.end()) return 0;
  return deck_number(found->second.text, Place{file, found->second.line, name});
}

void read_constants(const Table& table, const Constants& constants, const std::string& file, const UnitSystem& units,
                    FoundCard& card) {
  for (int k = 0; k < table.terms; ++k) {
    const std::string index = std::to_string(k + 1);
    const double modulus = constant(constants, 2 * k + 1, file, "mu_" + index) * units.stress;
    const double alpha = constant(constants, 2 * k + 2, file, "alpha_" + index);
    add_term(card.material, modulus, alpha, CardModulus::two_mu_over_alpha, {file, constants.line, "alpha_" + index});
  }
  const int d = 2 * table.terms;
  set_bulk_modulus(card.material, constant(constants, d + 1, file, "d_1"), units.stress,
                   Place{file, constants.line, "d_1"});
  for (int k = 2; k <= table.terms; ++k)
    if (constant(constants, d + k, file, "d_" + std::to_string(k)) != 0)
      card.ignored.push_back("d_" + std::to_string(k) + " (a higher term of the volumetric law)");
}

// The other commands of a material. Throws BadInput for a Prony series.
std::vector<std::string> additions_of(const Commands& commands, const std::string& material, const std::string& file) {
  std::vector<std::string> texts;
  for (const Addition& one : commands.additions) {
    if (one.material != material) continue;
    if (one.label == "PRON")
      throw BadInput(Place{file, one.line, "TB,PRONY"}, "a Prony series", "a material without viscosity");
    texts.push_back(one.written);
  }
  return texts;
}

}  // namespace

FoundMaterials read_ansys_cards(const std::string& text, const std::string& file, const UnitSystem& units) {
  const Commands commands = parse(text, file);
  FoundMaterials found{.cards = {}, .others = commands.other_laws};
  for (const Table& table : commands.tables) {
    const auto named = commands.names.find(table.material);
    const std::string name = named == commands.names.end() ? "material " + table.material : named->second;
    for (const Constants& constants : table.sets) {
      FoundCard card{.material = {.name = table.sets.size() == 1 ? name : name + " at " + constants.at},
                     .line = constants.line,
                     .ignored = additions_of(commands, table.material, file)};
      if (const auto density = commands.densities.find(table.material); density != commands.densities.end())
        card.material.density =
            deck_number(density->second.text, Place{file, density->second.line, "MP,DENS"}) * units.density();
      read_constants(table, constants, file, units, card);
      check_solid(card.material, Place{.file = file, .line = constants.line, .key = ""});
      found.cards.push_back(card);
    }
  }
  return found;
}

}  // namespace percal
