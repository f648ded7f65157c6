#include <cmath>
#include <map>
#include <sstream>

#include "percal/card/ansys.hpp"
#include "percal/card/deck.hpp"
#include "percal/card/modulus.hpp"

namespace percal {
namespace {

constexpr const char* name_comment = "! name: ";

struct Number {
  std::string text;
  int line;
};

// One TB,HYPER table with the constants that TBDATA gave it.
struct Table {
  std::string material;
  int line;
  int terms;
  std::map<int, Number> constants;
};

struct Commands {
  std::map<std::string, std::string> names;  // of the materials
  std::map<std::string, Number> densities;
  std::vector<Table> tables;
  std::vector<std::string> others;  // commands that were passed over
};

std::string argument(const std::vector<std::string>& arguments, std::size_t i) {
  return i < arguments.size() ? trimmed(arguments[i]) : "";
}

int whole(const std::string& text, int missing, const Place& place) {
  if (text.empty()) return missing;
  const double number = deck_number(text, place);
  if (number != std::floor(number) || std::abs(number) > 1e6) throw BadInput(place, "'" + text + "'", "a whole number");
  return static_cast<int>(number);
}

Table table_of(const std::vector<std::string>& arguments, const std::string& file, int line) {
  const std::string option = upper_without_blanks(argument(arguments, 5));
  if (option != "OGDEN")
    throw BadInput(Place{file, line, "TB,HYPER"}, option.empty() ? "no option" : option, "TB,HYPER,...,OGDEN");
  const int terms = whole(argument(arguments, 4), 1, Place{file, line, "NPTS"});
  if (terms < 1 || terms > static_cast<int>(most_card_terms))
    throw BadInput(Place{file, line, "NPTS"}, std::to_string(terms), "1 to 3 terms");
  return {argument(arguments, 2), line, terms, {}};
}

Commands parse(const std::string& text, const std::string& file) {
  Commands commands;
  std::istringstream stream(text);
  std::string line, name;
  bool in_table = false;
  for (int number = 1; std::getline(stream, line); ++number) {
    if (line.starts_with(name_comment)) name = trimmed(line.substr(std::string(name_comment).size()));
    const auto arguments = split_at_commas(line.substr(0, line.find('!')));
    const std::string command = upper_without_blanks(arguments.front());
    const std::string label = upper_without_blanks(argument(arguments, 1));
    if (command.empty()) continue;
    if (command == "MP" && label == "DENS") {
      commands.densities[argument(arguments, 2)] = {argument(arguments, 3), number};
      if (!name.empty()) commands.names[argument(arguments, 2)] = name;
    } else if (command == "TB") {
      in_table = label.starts_with("HYPE");
      if (in_table) commands.tables.push_back(table_of(arguments, file, number));
      if (!in_table) commands.others.push_back(trimmed(line));
    } else if (command == "TBDATA" && in_table) {
      const int start = whole(label, 1, Place{file, number, "TBDATA"});
      for (std::size_t i = 2; i < arguments.size(); ++i)
        if (!is_blank(arguments[i]))
          commands.tables.back().constants[start + static_cast<int>(i) - 2] = {argument(arguments, i), number};
    } else if (command == "MP") {
      commands.others.push_back(trimmed(line));
    }
  }
  return commands;
}

double constant(const Table& table, int index, const std::string& file, const std::string& name) {
  const auto found = table.constants.find(index);
  if (found == table.constants.end()) return 0;
  return deck_number(found->second.text, Place{file, found->second.line, name});
}

}  // namespace

std::vector<FoundCard> read_ansys_cards(const std::string& text, const std::string& file, const UnitSystem& units) {
  const Commands commands = parse(text, file);
  std::vector<FoundCard> cards;
  for (const Table& table : commands.tables) {
    const auto name = commands.names.find(table.material);
    FoundCard card{.material = {.name = name == commands.names.end() ? "material " + table.material : name->second,
                                .density = 0,
                                .terms = {},
                                .bulk_modulus = 0},
                   .line = table.line,
                   .ignored = commands.others};
    const auto density = commands.densities.find(table.material);
    if (density == commands.densities.end())
      throw BadInput(Place{file, table.line, "MP,DENS"}, "no density of material " + table.material,
                     "MP,DENS,MAT,value");
    card.material.density =
        deck_number(density->second.text, Place{file, density->second.line, "MP,DENS"}) * units.density();
    for (int k = 0; k < table.terms; ++k) {
      const std::string index = std::to_string(k + 1);
      const double modulus = constant(table, 2 * k + 1, file, "mu_" + index) * units.stress;
      const double alpha = constant(table, 2 * k + 2, file, "alpha_" + index);
      const Place place{file, table.line, "alpha_" + index};
      if (modulus != 0 && alpha == 0) throw BadInput(place, "0", "a number other than 0");
      if (modulus != 0) add_term(card.material, term_of_field(modulus, alpha, CardModulus::two_mu_over_alpha), place);
    }
    const double d1 = constant(table, 2 * table.terms + 1, file, "d_1");
    if (!(d1 > 0)) throw BadInput(Place{file, table.line, "d_1"}, std::to_string(d1), "a positive number");
    card.material.bulk_modulus = 2 / d1 * units.stress;
    for (int k = 2; k <= table.terms; ++k)
      if (constant(table, 2 * table.terms + k, file, "d_" + std::to_string(k)) != 0)
        card.ignored.push_back("d_" + std::to_string(k) + " (a higher term of the volumetric law)");
    check(card.material, Place{.file = file, .line = table.line, .key = ""});
    cards.push_back(card);
  }
  return cards;
}

}  // namespace percal
