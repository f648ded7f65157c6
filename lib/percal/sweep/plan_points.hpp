// The points of a plan: blocks of rows, each over some of the axes, and all their combinations.
#pragma once
#include <string>
#include <vector>

#include "percal/math/draws.hpp"
#include "percal/sweep/plan.hpp"
#include "percal/text/csv.hpp"

namespace percal {

inline constexpr std::size_t most_sobol_ranges = most_sobol_dimensions;

// Rows of values over some axes. A sweep is one with a single axis.
struct PointBlock {
  std::vector<std::size_t> axes = {};
  std::vector<std::vector<SweptValue>> rows = {};  // a value for each of `axes`
  std::vector<Place> places = {};                  // of the rows of a list
};

// From one value to another, both in the unit of the first.
struct SweptRange {
  TomlScalar from, to;
  bool is_logarithmic = false;
  std::size_t axis = 0;
  double low = 0, high = 0;
  std::string unit = "";
  bool is_whole = false;  // both ends are whole numbers: so is what lies between them, where it can be
};

// Fills in the numbers. Throws BadInput for ends that are no two different numbers of one dimension, and for a logarithm of what has none.
void check_range(SweptRange& range, const SweepAxis& axis, const TomlTable& block);

// `count` values, both ends among them.
std::vector<TomlScalar> spaced_values(const SweptRange& range, int count);

// Of values as they stand; the axis gets their unit, that of the first. Throws BadInput for values of a group that are no numbers.
PointBlock block_of(const std::vector<TomlScalar>& values, SweepAxis& axis, std::size_t index, const Place& place);

// Points of Sobol's sequence in the box of the ranges.
PointBlock sobol_block(const std::vector<SweptRange>& ranges, int count);

// As many empty rows as a table has, then a column of it as another value of each. The axis gets the header's unit. Throws BadInput for
// cells that have no value of the kind.
PointBlock rows_of(const CsvTable& table);
void read_column(const CsvTable& table, int column, SweepAxis& axis, PointBlock& block);

// All combinations, the last block's rows fastest. Throws BadInput at `place` for more than most_plan_points.
std::vector<PlanPoint> all_points(const std::vector<PointBlock>& blocks, std::size_t axes, const Place& place);

}  // namespace percal
