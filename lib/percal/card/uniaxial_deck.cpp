#include "percal/card/uniaxial_deck.hpp"

#include <fmt/core.h>

#include <cctype>
#include <cmath>
#include <filesystem>

#include "percal/card/deck_parts.hpp"

namespace percal {
namespace {

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

std::vector<DeckFile> uniaxial_deck_files(Solver solver, const CardMaterial& material, const UnitSystem& units,
                                          const UniaxialTest& test, const std::string& job) {
  check_test(test);
  const DeckOrder order{material, units, test, deck_job(job), write_card(solver, material, units)};
  switch (solver) {
    case Solver::lsdyna: return lsdyna_deck(order);
    case Solver::abaqus: return abaqus_deck(order);
    case Solver::calculix: return calculix_deck(order);
    case Solver::openradioss: return openradioss_deck(order);
    case Solver::febio: return febio_deck(order);
    case Solver::ansys: return ansys_deck(order);
  }
  return {};
}

std::string uniaxial_deck(Solver solver, const CardMaterial& material, const UnitSystem& units, double stretch,
                          int increments) {
  const UniaxialTest test{.stretch = stretch, .increments = increments};
  return uniaxial_deck_files(solver, material, units, test, "uniaxial").front().text;
}

}  // namespace percal
