#include "percal/card/uniaxial_deck.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

#include "percal/card/card_text.hpp"
#include "percal/card/solver.hpp"

namespace percal {
namespace {

// J U'(J)
double volumetric_kirchhoff(double bulk_modulus, double J, SolverLaw law) {
  switch (law) {
    case SolverLaw::quadratic: return bulk_modulus * J * (J - 1);
    case SolverLaw::logarithmic: return bulk_modulus * std::log(J);
    case SolverLaw::difference: return bulk_modulus * (J - 1);
  }
  return 0;
}

// tau_1 - tau_2 of isochoric stretches s and s^(-1/2): sum (2 mu/alpha) (s^alpha - s^(-alpha/2)), s = lambda J^(-1/3).
double kirchhoff_difference(const CardMaterial& material, double stretch, double log_J) {
  const double log_s = std::log(stretch) - log_J / 3;
  double sum = 0;
  for (const Ogden& term : material.terms) sum += cauchy_difference(term, log_s, -log_s / 2);
  return sum;
}

// tau_2 = J U' - (tau_1 - tau_2)/3: grows with J, from below 0 to above.
double side_stress(const CardMaterial& material, double stretch, double log_J, SolverLaw law) {
  return volumetric_kirchhoff(material.bulk_modulus, std::exp(log_J), law) -
         kirchhoff_difference(material, stretch, log_J) / 3;
}

std::string word(SolverLaw law) {
  if (law == SolverLaw::quadratic) return "U = K (J - 1)^2 / 2";
  return law == SolverLaw::logarithmic ? "U = K (ln J)^2 / 2" : "U = K (J - 1 - ln J)";
}

// "expected nominal stress at stretch 2: 1.75 MPa (U = ...; incompressible: 1.76 MPa)"
std::string expectation(const DeckOrder& order, double stretch, SolverLaw law) {
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

constexpr std::size_t job_characters = 40, least_job_characters = 4;  // OpenRadioss wants four
constexpr int most_increments = 10000;

void check_test(const UniaxialTest& test) {
  if (!(test.stretch > 0) || test.stretch == 1 || !std::isfinite(test.stretch)) {
    throw BadInput(Place{.file = "", .line = 0, .key = "--stretch"}, fmt::format("{}", test.stretch),
                   "a positive stretch other than 1");
  }
  if (test.increments < 1 || test.increments > most_increments) {
    throw BadInput(Place{.file = "", .line = 0, .key = "--increments"}, fmt::format("{}", test.increments),
                   fmt::format("1 to {}", most_increments));
  }
}

}  // namespace

double uniaxial_stress(const CardMaterial& material, double stretch, SolverLaw law) {
  double low = 0, high = 0;  // ln J
  for (double step = 1e-3; side_stress(material, stretch, low, law) > 0 && step < 10; step *= 2) low -= step;
  for (double step = 1e-3; side_stress(material, stretch, high, law) < 0 && step < 10; step *= 2) high += step;
  for (int halving = 0; halving < 100; ++halving) {
    const double middle = (low + high) / 2;
    (side_stress(material, stretch, middle, law) < 0 ? low : high) = middle;
  }
  return kirchhoff_difference(material, stretch, (low + high) / 2) / stretch;
}

double incompressible_uniaxial_stress(const CardMaterial& material, double stretch) {
  return kirchhoff_difference(material, stretch, 0) / stretch;
}

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

std::vector<std::string> fields_of(const Face& face) {
  std::vector<std::string> fields;
  for (const int node : face) fields.push_back(std::to_string(node));
  return fields;
}

double final_displacement(const DeckOrder& order, double edge) { return (order.test.stretch - 1) * edge; }

std::string deck_comments(const DeckOrder& order, double edge, SolverLaw law, const std::string& prefix,
                          const std::vector<std::string>& of_solver) {
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
  return comment_lines(prefix, comments) + comment_lines(prefix, of_solver);
}

std::string text_after(const std::string& card, const std::string& start, const std::string& ends) {
  const std::size_t found = card.find(start);
  if (found == std::string::npos) return "";
  const std::size_t from = found + start.size();
  return card.substr(from, card.find_first_of(ends + "\n", from) - from);
}

std::string deck_job(const std::string& file) {
  std::string stem = std::filesystem::path(file).stem().string();
  if (stem.ends_with("_0000") || stem.ends_with("_0001")) stem.erase(stem.size() - 5);
  std::string name;
  for (const char letter : stem.substr(0, job_characters)) {
    const auto byte = static_cast<unsigned char>(letter);
    const bool kept = byte < 128 && (std::isalnum(byte) || (letter == '-' && !name.ends_with('-')));
    name += kept ? letter : '_';
  }
  while (name.size() < least_job_characters) name += '_';
  return name;
}

std::vector<DeckFile> uniaxial_deck(const Solver& solver, const CardMaterial& material, const UnitSystem& units,
                                    const UniaxialTest& test, const std::string& job) {
  check_test(test);
  return solver.deck({material, units, test, deck_job(job), solver.card(material, units)});
}

}  // namespace percal
