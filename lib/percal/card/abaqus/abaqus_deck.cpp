#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "percal/card/abaqus/abaqus.hpp"
#include "percal/card/card_text.hpp"

namespace percal {
namespace {

constexpr const char* ending = ".inp";

// CalculiX takes residual forces below 1e-6 for 0, in any units. With forces of 1e3 and more that is no limit.
constexpr double calculix_least_force = 1e3;

// Nodes, element, sets, the card, planes of symmetry.
std::string model(const DeckOrder& order, const std::string& element, double edge) {
  std::string text = "*NODE, NSET=CUBE_NODES\n";
  for (const auto& [number, x, y, z] : cube_nodes(edge)) {
    text += fmt::format("{}, {}, {}, {}\n", number, number_field(x), number_field(y), number_field(z));
  }
  text += "*ELEMENT, TYPE=" + element + ", ELSET=CUBE\n1, 1, 2, 3, 4, 5, 6, 7, 8\n";
  text += "*NSET, NSET=X0\n" + listed(face_x0, ", ") + "\n";
  text += "*NSET, NSET=Y0\n" + listed(face_y0, ", ") + "\n";
  text += "*NSET, NSET=Z0\n" + listed(face_z0, ", ") + "\n";
  text += "*NSET, NSET=X1\n" + listed(face_x1, ", ") + "\n";
  text += order.card;
  text += "*SOLID SECTION, ELSET=CUBE, MATERIAL=" + text_after(order.card, "*MATERIAL, NAME=", ", ") + "\n";
  return text + "*BOUNDARY\nX0, 1, 1\nY0, 2, 2\nZ0, 3, 3\n";
}

std::string moved_face(const DeckOrder& order, double edge) {
  return "*BOUNDARY\nX1, 1, 1, " + number_field(final_displacement(order, edge)) + "\n";
}

// ccx reads NAME.inp only, and names its own files NAME.
std::string calculix_run(const DeckOrder& order) {
  const std::string own = order.job + ending, file = deck_name(order, ending);
  return (file == own ? "" : "cp " + as_argument(file) + " " + own + "; ") + "ccx " + order.job;
}

// A power of ten, at least 1, with mu edge^2 >= calculix_least_force.
double calculix_edge(const DeckOrder& order) {
  const double mu = shear_modulus(order.material) / order.units.stress;
  return std::pow(10.0, std::max(0.0, std::ceil(std::log10(calculix_least_force / mu) / 2 - 1e-9)));
}

}  // namespace

std::vector<DeckFile> abaqus_deck(const DeckOrder& order) {
  const double edge = 1;
  const int steps = order.test.increments;
  std::string text = "*HEADING\nuniaxial test of one element\n";
  text += deck_comments(
      order, edge, SolverLaw::quadratic, "**",
      {"run: abaqus job=" + order.job +
           (deck_name(order, ending) == order.job + ending ? "" : " input=" + as_argument(deck_name(order, ending))) +
           " interactive; " + order.job + ".dat then has the sum of RF1 over X1 and U1 at every increment",
       "C3D8H: displacement and pressure are interpolated apart, so that a large K/mu neither locks the "
       "element nor spoils the pressure",
       "time runs from 0 to the number of increments; *CONTROLS: residual and correction to 1e-6"});
  text += model(order, "C3D8H", edge);
  text += fmt::format("*STEP, NLGEOM=YES, INC={}\n*STATIC\n1., {}., 1e-3, 1.\n", 100 * steps, steps);
  text += "*CONTROLS, PARAMETERS=FIELD, FIELD=DISPLACEMENT\n1e-6, 1e-6\n";
  text += moved_face(order, edge);
  text += "*NODE PRINT, NSET=X1, TOTALS=YES, FREQUENCY=1\nRF1\n*NODE PRINT, NSET=X1, FREQUENCY=1\nU1\n";
  text += "*OUTPUT, FIELD, VARIABLE=PRESELECT\n*OUTPUT, HISTORY, FREQUENCY=1\n*NODE OUTPUT, NSET=X1\nRF1, U1\n";
  return {{deck_name(order, ending), text + "*END STEP\n"}};
}

std::vector<DeckFile> calculix_deck(const DeckOrder& order) {
  const double edge = calculix_edge(order);
  const int steps = order.test.increments;
  std::string text = "*HEADING\nuniaxial test of one element\n";
  text += deck_comments(
      order, edge, SolverLaw::quadratic, "**",
      {"run: " + calculix_run(order) + "; " + order.job +
           ".dat then has, at every increment, the total force on X1 and the displacements of its nodes",
       "*STATIC, DIRECT: increments of fixed size, time runs from 0 to their number; *CONTROLS: residual and "
       "correction to 1e-7 of the mean force and of the increment (CalculiX's own 0.5 % and 1 % left errors of up to "
       "0.5 % at K/mu = 1e6)",
       "the edge is such that mu edge^2 is 1e3 or more: CalculiX takes residual forces below 1e-6 for 0",
       "C3D8: every deformation of this test is homogeneous, so that it does not lock"});
  text += model(order, "C3D8", edge);
  text += fmt::format("*STEP, NLGEOM, INC={}\n*STATIC, DIRECT\n1., {}.\n", 2 * steps, steps);
  text += "*CONTROLS, PARAMETERS=FIELD\n1.e-7, 1.e-7\n";
  text += moved_face(order, edge);
  text += "*NODE PRINT, NSET=X1, TOTALS=ONLY\nRF\n*NODE PRINT, NSET=X1\nU\n";
  return {{deck_name(order, ending), text + "*END STEP\n"}};
}

}  // namespace percal
