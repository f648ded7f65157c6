// The distributions of a powder's job.                                                             docs/formats/dose.md
#pragma once
#include <string>

#include "percal/powder/powder.hpp"
#include "percal/text/toml.hpp"

namespace percal {

// How a number of [powder] is called and what it is.
struct PowderNumber {
  std::string name;  // "radius"
  Dimension dimension;
  bool is_size = false;  // a distribution of sizes says whether it counts particles or weighs them
};

struct ReadDistribution {
  Distribution by_number;
  bool was_by_mass = false;
};

// Of the table [powder.NAME], or the one value NAME of [powder].
ReadDistribution read_distribution(const TomlTable& powder, const PowderNumber& number);

// [powder.speed] with by_size: the table, and the factor's distribution.
void read_speed(const TomlTable& powder, Powder& into);

}  // namespace percal
