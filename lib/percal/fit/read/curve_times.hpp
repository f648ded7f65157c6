// When the rows of a table were measured.                                                      docs/formats/csv.md
#pragma once
#include "percal/fit/read/read_curves.hpp"

namespace percal {

// Gives every point its time. `data` has one point for each row of the table, the last source is the table's; `taken` of it gets a
// sentence. Throws BadInput: no column of time and no rate, both of them, a stretch that is held where only a rate is known.
struct CurveAxes {
  int x, y;  // columns that are no times
};
void read_times(CurveData& data, const CsvTable& table, const TimesWanted& wanted, const CurveAxes& axes);

}  // namespace percal
