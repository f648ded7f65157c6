#include "percal/card/unit_system.hpp"

#include <fmt/core.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "percal/base/error.hpp"
#include "percal/units/quantity.hpp"

namespace percal {
namespace {

constexpr const char* accepted_systems =
    "si, mm-t-s-MPa, mm-ms-kg-GPa, um-us-ng-MPa, or one unit each of length, mass, time and stress joined by '-'";

std::vector<std::string> split(const std::string& name) {
  std::vector<std::string> parts(1);
  for (char letter : name) {
    if (letter == '-') {
      parts.emplace_back();
    } else {
      parts.back() += letter;
    }
  }
  return parts;
}

[[noreturn]] void refuse(const std::string& found, const std::string& accepted) {
  throw BadInput(Place{.file = "", .line = 0, .key = "units"}, found, accepted);
}

struct Unit {
  std::string text;
  double value = 0;  // SI
};

void set(Unit& unit, const std::string& text, double value, const std::string& name) {
  if (!unit.text.empty()) refuse(fmt::format("'{}' with both {} and {}", name, unit.text, text), accepted_systems);
  unit = {text, value};
}

}  // namespace

UnitSystem unit_system(const std::string& name) {
  Unit length, mass, time, stress;
  for (const std::string& part : split(name == "si" ? "m-kg-s-Pa" : name)) {
    Quantity unit{};
    try {
      unit = parse_unit(part);
    } catch (const std::invalid_argument& error) {
      refuse(fmt::format("'{}' ({})", name, error.what()), accepted_systems);
    }
    if (unit.dimension == dimension::length) {
      set(length, part, unit.value, name);
    } else if (unit.dimension == dimension::mass) {
      set(mass, part, unit.value, name);
    } else if (unit.dimension == dimension::time) {
      set(time, part, unit.value, name);
    } else if (unit.dimension == dimension::pressure) {
      set(stress, part, unit.value, name);
    } else {
      refuse(fmt::format("'{}'", name), accepted_systems);
    }
  }
  if (length.text.empty() || mass.text.empty() || time.text.empty() || stress.text.empty()) {
    refuse(fmt::format("'{}'", name), accepted_systems);
  }
  const double consistent_stress = mass.value / (length.value * time.value * time.value);
  if (std::abs(stress.value / consistent_stress - 1) > 1e-9) {
    refuse(fmt::format("'{}', where {} is {:.6g} Pa", name, stress.text, stress.value),
           fmt::format("a stress unit of {0}/({1} {2}^2) = {3:.6g} Pa with {1}, {0} and {2}", mass.text, length.text,
                       time.text, consistent_stress));
  }
  return {name, length.text, mass.text, time.text, stress.text, length.value, mass.value, time.value, stress.value};
}

}  // namespace percal
