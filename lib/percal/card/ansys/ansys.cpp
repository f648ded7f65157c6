
#include "percal/card/ansys/ansys.hpp"

#include <fmt/core.h>

#include <cmath>
#include <map>
#include <sstream>

#include "percal/card/card_comments.hpp"
#include "percal/card/card_text.hpp"
#include "percal/card/read_deck.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

constexpr std::size_t numbers_of_command = 6;
constexpr std::size_t name_characters = 60;

}  // namespace

std::string ansys_card(const CardMaterial& material, const UnitSystem& units) {
  check(material, Place{});
  std::string text = card_comments(
      {"!", "mu_", CardModulus::two_mu_over_alpha, "volumetric law: d_1 = 2/K; U = (J - 1)^2 / d_1"}, material, units);
  text += comment_lines("!", no_erosion_comment(material));
  text += "! name: " + ascii_name(material.name, "-_. ", name_characters) + "\n";
  text += "MP,DENS,1," + number_field(material.density / units.density()) + "\n";
  text += fmt::format("TB,HYPER,1,1,{},OGDEN\n", material.terms.size());
  std::vector<double> numbers;
  for (const Ogden& term : material.terms) {
    numbers.push_back(modulus_field(term, CardModulus::two_mu_over_alpha) / units.stress);
    numbers.push_back(term.alpha);
  }
  numbers.push_back(2 / (material.bulk_modulus / units.stress));
  numbers.resize(3 * material.terms.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i % numbers_of_command == 0) text += fmt::format("{}TBDATA,{}", i == 0 ? "" : "\n", i + 1);
    text += "," + number_field(numbers[i]);
  }
  return text + "\n";
}

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
    const auto arguments = split_at(',', line.substr(0, line.find('!')));
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
    FoundCard card{.material = {.name = name == commands.names.end() ? "material " + table.material : name->second},
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
      add_term(card.material, modulus, alpha, CardModulus::two_mu_over_alpha, {file, table.line, "alpha_" + index});
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

namespace {

std::string held(const std::string& axis, const std::string& at, const std::string& value) {
  return fmt::format("NSEL,S,LOC,{0},{1}\nD,ALL,U{0},{2}\n", axis, at, value);
}

// The sum of the four reactions over the area, read off in /POST1 step by step.
std::string read_off(const DeckOrder& order) {
  std::string text =
      fmt::format("/POST1\nSTEPS={}\n*DIM,STRETCH,ARRAY,STEPS\n*DIM,NOMINAL,ARRAY,STEPS\n", order.test.increments);
  text += "*DO,I,1,STEPS\nSET,1,I\n*GET,DISPLACED,NODE,2,U,X\nFORCE=0\n";
  for (const int node : face_x1) text += fmt::format("*GET,REACTION,NODE,{},RF,FX\nFORCE=FORCE+REACTION\n", node);
  text += "STRETCH(I)=1+DISPLACED/EDGE\nNOMINAL(I)=FORCE/EDGE**2\n*ENDDO\n";
  text +=
      "*CFOPEN," + order.job + ",csv\n*VWRITE,STRETCH(1),NOMINAL(1)\n(F12.8,',',E16.8)\n*CFCLOS\nPRRSOL,FX\nFINISH\n";
  return text;
}

}  // namespace

std::vector<DeckFile> ansys_deck(const DeckOrder& order) {
  const int steps = order.test.increments;
  const double mu = shear_modulus(order.material) / order.units.stress;
  std::string text = deck_comments(order, 1, SolverLaw::quadratic, "!",
                                   {"run: ansys -b -i " + order.job + ".inp -o " + order.job + ".out; " + order.job +
                                        ".csv then has stretch and nominal stress of every substep",
                                    "SOLID185 with KEYOPT(2) = 0 (B-bar) and KEYOPT(6) = 1 (pressure as an unknown of "
                                    "its own): does not lock at any K/mu",
                                    "CNVTOL: residual to 1e-6, with a least reference of 1e-6 mu edge^2, as forces may "
                                    "be small numbers in these units"});
  text += "/TITLE,uniaxial test of one element\n/PREP7\nEDGE=1.\n";
  text += "ET,1,SOLID185\nKEYOPT,1,2,0\nKEYOPT,1,6,1\n";
  text += order.card;
  for (const auto& [number, x, y, z] : cube_nodes(1)) {
    text += fmt::format("N,{},{},{},{}\n", number, number_field(x), number_field(y), number_field(z));
  }
  text += "TYPE,1\nMAT," + text_after(order.card, "TB,HYPER,", ", ") + "\nE,1,2,3,4,5,6,7,8\nFINISH\n";
  text += "/SOLU\nANTYPE,STATIC\nNLGEOM,ON\nNROPT,FULL\nOUTRES,ALL,ALL\n";
  text += held("X", "0.", "0.") + held("Y", "0.", "0.") + held("Z", "0.", "0.");
  text += held("X", "EDGE", number_field(final_displacement(order, 1))) + "NSEL,ALL\n";
  text += fmt::format("TIME,{0}\nKBC,0\nAUTOTS,OFF\nNSUBST,{0},{0},{0}\nNEQIT,50\n", steps);
  text += "CNVTOL,F,,1.e-6,2," + number_field(1e-6 * mu) + "\nSOLVE\nFINISH\n";
  return {{order.job + ".inp", text + read_off(order)}};
}

}  // namespace percal
