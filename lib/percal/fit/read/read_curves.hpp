// Stress-stretch curves out of CSV files.                                                      docs/formats/csv.md
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "percal/fit/points/curve_data.hpp"
#include "percal/fit/shape/row_choice.hpp"
#include "percal/text/csv.hpp"

namespace percal {

// Where the time of every row comes from: a column (empty: found by its name), or the rates at which the stretch moves, for tables
// without such a column.
struct TimesWanted {
  std::string column = {};
  std::optional<double> rate = {};             // 1/s, of stretch or gamma; for all files
  std::map<std::string, double> rate_of = {};  // of single files, by their names as given
};

// What the user says about the columns; empty: found by their names.
struct CurveColumns {
  std::string mode = {};  // deformation of the files without a mode column, or with one of words that nobody knows
  std::map<std::string, std::string> mode_of = {};  // of single files, by their names as given
  std::string x = {}, y = {};                       // stretch, strain or shear; stress
  std::string error = {};                           // standard error of the stress
  std::vector<std::string> where = {};              // conditions of CsvTable::where: the rows to keep
  Specimen specimen = {};                           // where x is a displacement, y a force
  RowChoice rows = {};                              // branches, peaks and holds
  std::optional<TimesWanted> times = {};            // none: no row has a time
};

// The points of all files together. Throws BadInput: no such column, several that could be meant, no row left, a
// stretch that is not positive, a word that is no deformation, a file without curves (depths of shots); each bad line
// is named.
CurveData read_curves(const std::vector<std::string>& files, const CurveColumns& columns);

// As read_curves for one table, for tests and jobs.
CurveData curves_of(const CsvTable& table, const CurveColumns& columns);

}  // namespace percal
