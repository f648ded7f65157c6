// What in a curve contradicts what its file says of it: signs of compression, sizes that no solid has.    docs/formats/csv.md
#pragma once
#include <string>
#include <vector>

#include "percal/fit/read/curve_columns.hpp"

namespace percal {

// Numbers of a file's x and y columns, as they stand but for percent.
struct CurveNumbers {
  std::vector<double> x, y;
};

// Compression is often written with positive numbers. Where the rows that a word calls compression have a strain whose value largest in
// size is positive, the signs of all their strains are turned, and those of the stresses likewise; `warnings` gets a sentence.
// Throws BadInput for stretches above 1, which no turned sign makes right.
void turn_compression(CurveNumbers& numbers, const CsvTable& table, const FoundColumns& found,
                      const std::vector<bool>& compressed, std::vector<std::string>& warnings);

// Sentences, empty for a plausible curve: strains that look like percent, stresses against the stretch. `given` are the numbers of the
// table's x column, `points` what became of them.
std::vector<std::string> implausible(const CsvTable& table, const FoundColumns& found, const std::vector<double>& given,
                                     const std::vector<StressPoint>& points);

}  // namespace percal
