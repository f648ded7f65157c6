// The units a card is written in. Solvers know no units: what counts is that stress = mass / (length time^2).
#pragma once
#include <string>

namespace percal {

// SI values of one unit each: metres, kilograms, seconds, pascals.
struct UnitSystem {
  std::string name;  // as asked for: "mm-ms-kg-GPa"
  std::string length_unit, mass_unit, time_unit, stress_unit;
  double length, mass, time, stress;

  double density() const { return mass / (length * length * length); }  // kg/m3
};

// "si", or one unit each of length, mass, time and stress, joined by '-' in any order: "mm-t-s-MPa", "mm-ms-kg-GPa",
// "um-us-ng-MPa". Throws BadInput (key "units") for anything else and where the stress unit is not
// mass / (length time^2); the message then says what it would have to be.
UnitSystem unit_system(const std::string& name);

}  // namespace percal
