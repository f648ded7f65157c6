#include "percal/card/ansys/ansys.hpp"

#include <fmt/core.h>

#include "percal/card/card_comments.hpp"
#include "percal/card/card_text.hpp"

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
  std::string text =
      deck_comments(order, 1, SolverLaw::quadratic, "!",
                    {"run: ansys -b -i " + as_argument(deck_name(order, ".inp")) + " -o " + order.job + ".out; " +
                         order.job + ".csv then has stretch and nominal stress of every substep",
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
  return {{deck_name(order, ".inp"), text + read_off(order)}};
}

}  // namespace percal
