// Materials that the card tests share, and small tools to look at a card with.
#pragma once
#include <sstream>
#include <string>
#include <vector>

#include "percal/card/solver.hpp"

namespace percal::card_test {

// Skin: mu = 63.75 MPa and alpha = 8.5 make MU1 = 2 * 63.75 / 8.5 = 15 MPa.
inline CardMaterial skin() {
  return {.name = "skin",
          .density = 1000,
          .terms = {{63.75e6, 8.5}},
          .bulk_modulus = 50 * 63.75e6,
          .erosion = CardErosion{0.7, StrainMeasure::engineering},
          .comments = {"Guha 2009, Table 4-1"}};
}

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

// The line that stands `below` lines under the one starting with `start`; empty where there is none.
inline std::string line_under(const std::string& text, const std::string& start, std::size_t below) {
  const auto lines = lines_of(text);
  for (std::size_t i = 0; i + below < lines.size(); ++i) {
    if (lines[i].starts_with(start)) return lines[i + below];
  }
  return "";
}

inline std::string write_card(const std::string& solver, const CardMaterial& material, const UnitSystem& units) {
  return solver_named(solver).card(material, units);
}

inline FoundCard found_card(const std::string& solver, const std::string& text, const UnitSystem& units,
                            const std::string& file = "card") {
  return chosen_card(solver_named(solver).read(text, file, units), "", file);
}

// What the reader says; empty where it reads.
inline std::string reader_refusal(const std::string& solver, const std::string& text, const UnitSystem& units,
                                  const std::string& file = "card") {
  try {
    found_card(solver, text, units, file);
  } catch (const BadInput& error) {
    return error.what();
  }
  return "";
}

// The only material of a file.
inline CardMaterial read_card(const std::string& solver, const std::string& text, const UnitSystem& units,
                              const std::string& file = "card") {
  return found_card(solver, text, units, file).material;
}

inline std::string columns(const std::string& line, std::size_t field) {
  const std::string text = line.substr(10 * field, 10);
  const auto start = text.find_first_not_of(' ');
  return start == std::string::npos ? "" : text.substr(start);
}

}  // namespace percal::card_test
