// Ansys Mechanical APDL: one SOLID185, a static analysis, and a table of stretch and nominal stress.
#include <fmt/core.h>

#include "percal/card/deck_parts.hpp"
#include "percal/card/field.hpp"

namespace percal {
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
  std::vector<std::string> paragraphs = deck_comments(order, 1, VolumetricLaw::quadratic);
  paragraphs.push_back("run: ansys -b -i " + order.job + ".inp -o " + order.job + ".out; " + order.job +
                       ".csv then has stretch and nominal stress of every substep");
  paragraphs.push_back(
      "SOLID185 with KEYOPT(2) = 0 (B-bar) and KEYOPT(6) = 1 (pressure as an unknown of its own): does not lock at any "
      "K/mu");
  paragraphs.push_back(
      "CNVTOL: residual to 1e-6, with a least reference of 1e-6 mu edge^2, as forces may be small numbers in "
      "these units");
  std::string text;
  for (const std::string& paragraph : paragraphs) text += comment_lines("!", paragraph);
  text += "/TITLE,uniaxial test of one element\n/PREP7\nEDGE=1.\n";
  text += "ET,1,SOLID185\nKEYOPT,1,2,0\nKEYOPT,1,6,1\n";
  text += order.card;
  for (const auto& [number, x, y, z] : cube_nodes(1)) {
    text += fmt::format("N,{},{},{},{}\n", number, deck_text(x), deck_text(y), deck_text(z));
  }
  text += "TYPE,1\nMAT," + text_after(order.card, "TB,HYPER,", ", ") + "\nE,1,2,3,4,5,6,7,8\nFINISH\n";
  text += "/SOLU\nANTYPE,STATIC\nNLGEOM,ON\nNROPT,FULL\nOUTRES,ALL,ALL\n";
  text += held("X", "0.", "0.") + held("Y", "0.", "0.") + held("Z", "0.", "0.");
  text += held("X", "EDGE", deck_text(final_displacement(order, 1))) + "NSEL,ALL\n";
  text += fmt::format("TIME,{0}\nKBC,0\nAUTOTS,OFF\nNSUBST,{0},{0},{0}\nNEQIT,50\n", steps);
  text += "CNVTOL,F,,1.e-6,2," + deck_text(1e-6 * mu) + "\nSOLVE\nFINISH\n";
  return {{order.job + ".inp", text + read_off(order)}};
}

}  // namespace percal
