// What a curve shows that is no single loading of one elastic solid: several materials, cycles, holds, failure, slack.  docs/formats/csv.md
#pragma once
#include <string>
#include <vector>

#include "percal/fit/read/curve_columns.hpp"

namespace percal {

// A sentence for each column of text, or of specimens' numbers, that has several values within one deformation: all of them would be
// fitted as one solid.
std::vector<std::string> several_materials(const CsvTable& table, const FoundColumns& found,
                                           const std::vector<Deformation>& modes);

// Sentences on a stretch that runs back or starts anew, a stress that relaxes at a held stretch, a peak with a falling branch behind it,
// an offset, a toe; not on what the choice of rows settles. Each deformation by itself, tension and compression apart, its points in the order of the rows: one for each row.
std::vector<std::string> shapes(const CsvTable& table, const FoundColumns& found,
                                const std::vector<StressPoint>& points, const RowChoice& choice);

}  // namespace percal
