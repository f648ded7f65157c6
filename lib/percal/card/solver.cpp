#include "percal/card/solver.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>

#include "percal/card/abaqus.hpp"
#include "percal/card/ansys.hpp"
#include "percal/card/febio.hpp"
#include "percal/card/lsdyna.hpp"
#include "percal/card/openradioss.hpp"

namespace percal {

const std::vector<std::string>& solver_words() {
  static const std::vector<std::string> words = {"lsdyna", "abaqus", "calculix", "openradioss", "febio", "ansys"};
  return words;
}

std::optional<Solver> solver_of_word(const std::string& word) {
  const auto& words = solver_words();
  const auto found = std::find(words.begin(), words.end(), word);
  if (found == words.end()) return std::nullopt;
  return static_cast<Solver>(found - words.begin());
}

std::string write_card(Solver solver, const CardMaterial& material, const UnitSystem& units) {
  switch (solver) {
    case Solver::lsdyna: return lsdyna_card(material, units);
    case Solver::openradioss: return openradioss_card(material, units);
    case Solver::febio: return febio_card(material, units);
    case Solver::ansys: return ansys_card(material, units);
    case Solver::calculix: return calculix_card(material, units);
    case Solver::abaqus: break;
  }
  return abaqus_card(material, units);
}

std::optional<Solver> solver_of(const std::string& text) {
  struct Sign {
    const char* start;  // of a line, upper case without blanks
    Solver solver;
  };
  const Sign signs[] = {
      {"*MAT_", Solver::lsdyna},         {"*KEYWORD", Solver::lsdyna},   {"*MATERIAL", Solver::abaqus},
      {"*HYPERELASTIC", Solver::abaqus}, {"/MAT/", Solver::openradioss}, {"#RADIOSS", Solver::openradioss},
      {"<MATERIAL", Solver::febio},      {"<FEBIO_SPEC", Solver::febio}, {"TB,HYPER", Solver::ansys}};
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    std::string start;
    for (const char letter : line) {
      const auto byte = static_cast<unsigned char>(letter);
      if (!std::isspace(byte)) start += static_cast<char>(std::toupper(byte));
      if (start.size() == 16) break;
    }
    for (const Sign& sign : signs)
      if (start.starts_with(sign.start)) return sign.solver;
  }
  return std::nullopt;
}

std::optional<UnitSystem> unit_system_of(const std::string& text) {
  const std::string label = "unit system: ";
  const auto at = text.find(label);
  if (at == std::string::npos) return std::nullopt;
  const auto start = at + label.size();
  const std::string name = text.substr(start, text.find_first_of(" \r\n", start) - start);
  try {
    return unit_system(name);
  } catch (const BadInput&) {
    return std::nullopt;
  }
}

std::vector<FoundCard> read_cards(Solver solver, const std::string& text, const std::string& file,
                                  const UnitSystem& units) {
  switch (solver) {
    case Solver::lsdyna: return read_lsdyna_cards(text, file, units);
    case Solver::openradioss: return read_openradioss_cards(text, file, units);
    case Solver::febio: return read_febio_cards(text, file, units);
    case Solver::ansys: return read_ansys_cards(text, file, units);
    case Solver::abaqus:
    case Solver::calculix: break;
  }
  return read_abaqus_cards(text, file, units);
}

CardMaterial read_card(Solver solver, const std::string& text, const std::string& file, const UnitSystem& units) {
  return only_card(read_cards(solver, text, file, units), file).material;
}

}  // namespace percal
