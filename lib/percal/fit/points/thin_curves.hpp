// Raw logs have more rows than a fit can tell apart.                                           docs/formats/csv.md
#pragma once
#include "percal/fit/points/curve_data.hpp"

namespace percal {

inline constexpr std::size_t most_points = 2000;  // of one deformation; with more they are averaged

// Points of one source: where a deformation has more than most_points, those within a thousandth of its range of stretch (two stretches:
// a sixtieth of each) become one, their mean, which counts as many rows as it stands for. A warning of the source says so.
// Points with times are not sorted by their stretch: of each deformation's runs of neighbours in time become one, so that most_points
// of them are left or few more; the first of a history stays as it is.
void thin(CurveData& data);

}  // namespace percal
