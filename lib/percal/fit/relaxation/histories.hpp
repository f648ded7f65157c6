// Tests as they went in time: which rows belong together, and when each of them left rest.        docs/theory/relaxation.md
#pragma once
#include <string>
#include <vector>

#include "percal/fit/points/curve_data.hpp"

namespace percal {

// How a test came from rest to its first row.
enum class FromRest {
  at_rest,  // the first row is at rest
  at_rate,  // as fast as from the first row to the second
  at_once   // in no time: the first two rows are at one stretch, or come back
};

// Rows of one source and one deformation whose times do not run back.
struct History {
  int source = 0;
  Deformation deformation = Deformation::uniaxial;
  std::size_t begin = 0, end = 0;  // of CurveData::points, the last excluded
  double start = 0;                // s on the clock of the rows, when it left rest
  FromRest from_rest = FromRest::at_rest;

  std::size_t rows() const { return end - begin; }
};

// In the order of the points, each of which must have a time. Throws BadInput for a history of fewer than two rows.
std::vector<History> histories_of(const CurveData& data);

// The shortest time between two rows that are not at the same time, and the longest history, s.
struct TimeScales {
  double shortest_interval = 0, longest_record = 0;
};
// Throws BadInput where no time passes at all.
TimeScales time_scales(const CurveData& data, const std::vector<History>& histories);

// A sentence for each history that did not begin at rest.
std::vector<std::string> starts_in_words(const CurveData& data, const std::vector<History>& histories);

}  // namespace percal
