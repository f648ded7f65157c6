// How sure the number is that a search found, by source.                        docs/theory/prediction.md (3) to (6)
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "percal/invert/modulus.hpp"
#include "percal/observe/depth_error.hpp"

namespace percal {

// Standard deviations of ln depth, and of the ln of the number; nothing where they are not known.
struct ValueErrorPart {
  std::string source;
  std::optional<double> of_depth, of_value;
  std::string how;
};

// Of a search that found something. By the scatter of its answers about their line, which points_in_line - 2 degrees of freedom tell.
ValueErrorPart solver_share(const Inversion& found);

// By an error of the depth.
ValueErrorPart depth_share(const std::string& source, double of_depth, const std::string& how, const Inversion& found);

// By an error of the number itself.
ValueErrorPart value_share(const std::string& source, double of_value, const std::string& how, const Inversion& found);

// By what wall, time step and K may do to a depth.
std::vector<ValueErrorPart> rule_shares(const DepthError& error, double depth, const Inversion& found);

// Half width of the interval of the ln of the number: Student's t for the solver's share, the others as known.
double half_width(const Inversion& found, const std::vector<ValueErrorPart>& others, double level);

// The root of the sum of their squares, of ln depth.
double of_depth(const std::vector<ValueErrorPart>& shares);

}  // namespace percal
