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

// Where the largest principal stretch of the test passes the card's limit, or that it does not although it would without a change of
// volume; empty where neither does.
std::string erosion_comment(const DeckOrder& order, SolverLaw law) {
  if (!order.material.erosion) return "";
  const double limit = stretch_at(order.material.erosion->limit, order.material.erosion->measure);
  const double end = order.test.stretch;
  const std::string start = fmt::format("the material erodes at a largest principal stretch of {:.6g}", limit);
  if (const auto gone = stretch_where_largest_is(limit, order.material, end, law))
    return fmt::format(
        "{}: where the card below says so to the program, the element goes at stretch {:.6g}, and the force is 0 after "
        "that",
        start, *gone);
  const double incompressible = 1 / (limit * limit);
  if (end > incompressible) return "";
  return fmt::format(
      "{}, which is not reached: with this K the sides come to {:.6g}, so that the element stays (without a change of "
      "volume it would go at stretch {:.6g})",
      start, side_stretch(order.material, end, law), incompressible);
}

constexpr std::size_t job_characters = 40;
constexpr const char* usual_job = "uniaxial";
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
  const std::string erosion = erosion_comment(order, law);
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
  return name;
}

std::string deck_name(const DeckOrder& order, const std::string& ending) {
  return order.file.empty() ? order.job + ending : order.file;
}

std::string as_argument(const std::string& file) {
  const bool plain = std::ranges::all_of(file, [](unsigned char letter) {
    return std::isalnum(letter) || letter == '.' || letter == '_' || letter == '-' || letter >= 128;
  });
  return plain && !file.starts_with('-') ? file : "\"" + file + "\"";
}

std::vector<DeckFile> uniaxial_deck(const Solver& solver, const CardMaterial& material, const UnitSystem& units,
                                    const UniaxialTest& test, const std::string& file) {
  check_test(test);
  const std::filesystem::path path(file.empty() ? usual_job : file);
  return solver.deck({.material = material,
                      .units = units,
                      .test = test,
                      .job = deck_job(path.string()),
                      .file = path.has_extension() ? path.filename().string() : "",
                      .card = solver.card(material, units)});
}

}  // namespace percal
