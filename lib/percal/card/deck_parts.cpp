#include "percal/card/deck_parts.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "percal/card/field.hpp"

namespace percal {
namespace {

std::string word(VolumetricLaw law) {
  if (law == VolumetricLaw::quadratic) return "U = K (J - 1)^2 / 2";
  return law == VolumetricLaw::logarithmic ? "U = K (ln J)^2 / 2" : "U = K (J - 1 - ln J)";
}

// "expected nominal stress at stretch 2: 1.75 MPa (U = ...; incompressible: 1.76 MPa)"
std::string expectation(const DeckOrder& order, double stretch, VolumetricLaw law) {
  const UnitSystem& units = order.units;
  return fmt::format("expected nominal stress at stretch {:.9g}: {:.6g} {} ({}; incompressible: {:.6g} {})", stretch,
                     uniaxial_stress(order.material, stretch, law) / units.stress, units.stress_unit, word(law),
                     incompressible_uniaxial_stress(order.material, stretch) / units.stress, units.stress_unit);
}

// Where the largest principal stretch of the test, that of the sides in compression, passes the card's limit; empty
// where it does not.
std::string erosion_comment(const DeckOrder& order) {
  if (!order.material.erosion) return "";
  const double limit = stretch_at(order.material.erosion->limit, order.material.erosion->measure);
  const double end = order.test.stretch;
  if (std::max(end, 1 / std::sqrt(end)) < limit) return "";
  return fmt::format(
      "the material erodes at a largest principal stretch of {:.6g}: where the card below says so to the program, the "
      "element goes at stretch {:.6g}, and the force is 0 after that",
      limit, end > 1 ? limit : 1 / (limit * limit));
}

}  // namespace

std::array<CubeNode, 8> cube_nodes(double edge) {
  return {{{1, 0, 0, 0},
           {2, edge, 0, 0},
           {3, edge, edge, 0},
           {4, 0, edge, 0},
           {5, 0, 0, edge},
           {6, edge, 0, edge},
           {7, edge, edge, edge},
           {8, 0, edge, edge}}};
}

std::string listed(const Face& face, const std::string& separator) {
  std::string text;
  for (const int node : face) text += (text.empty() ? "" : separator) + std::to_string(node);
  return text;
}

std::string deck_text(double value) { return number_field(value, 20); }

double final_displacement(const DeckOrder& order, double edge) { return (order.test.stretch - 1) * edge; }

std::vector<std::string> deck_comments(const DeckOrder& order, double edge, VolumetricLaw law) {
  const double end = order.test.stretch;
  std::vector<std::string> comments{
      fmt::format("uniaxial test of one element: a cube with an edge of {:g} {}, stretched along x from 1 to {:.9g}, "
                  "sides free",
                  edge, order.units.length_unit, end),
      fmt::format("nominal stress = sum of the forces along x on nodes {}, over {:g} {}^2; stretch = 1 + their "
                  "displacement over {:g} {}",
                  listed(face_x1, ", "), edge * edge, order.units.length_unit, edge, order.units.length_unit),
      expectation(order, end, law), expectation(order, (1 + end) / 2, law)};
  const std::string erosion = erosion_comment(order);
  if (!erosion.empty()) comments.push_back(erosion);
  return comments;
}

std::string text_after(const std::string& card, const std::string& start, const std::string& ends) {
  const std::size_t found = card.find(start);
  if (found == std::string::npos) return "";
  const std::size_t from = found + start.size();
  return card.substr(from, card.find_first_of(ends + "\n", from) - from);
}

}  // namespace percal
