#include "percal/fit/read/curve_times.hpp"

#include <fmt/core.h>

#include <cmath>

#include "percal/fit/shape/curve_branches.hpp"
#include "percal/page/numbers.hpp"
#include "percal/text/csv_cells.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

constexpr const char* how_times_are_said =
    "a column of time (time_s, t [ms]), its name as time, or the rate of stretch where nothing is held";

bool names_time(const std::string& name) {
  return name == "t" || name == "time" || name.starts_with("time_") || name.ends_with("_time");
}

std::string headers_of(const CsvTable& table, const std::vector<int>& columns) {
  std::vector<std::string> names;
  for (const int c : columns) names.push_back(table.columns[static_cast<std::size_t>(c)].header);
  return listed(names);
}

std::optional<int> time_column(const CsvTable& table, const TimesWanted& wanted, const CurveAxes& axes) {
  if (!wanted.column.empty()) return table.column(wanted.column);
  std::vector<int> found;
  for (int c = 0; c < static_cast<int>(table.columns.size()); ++c)
    if (c != axes.x && c != axes.y && names_time(lower_case(table.columns[static_cast<std::size_t>(c)].name)))
      found.push_back(c);
  if (found.size() > 1)
    throw BadInput({table.file, table.header_line, ""}, "several columns of time: " + headers_of(table, found),
                   "one of them, named as time");
  return found.empty() ? std::nullopt : std::optional(found[0]);
}

std::optional<double> rate_of(const CsvTable& table, const TimesWanted& wanted) {
  const auto own = wanted.rate_of.find(table.file);
  return own == wanted.rate_of.end() ? wanted.rate : own->second;
}

// A rate tells no time while the stretch stands still, nor between two curves.
void refuse_what_a_rate_cannot_tell(const CurveData& data, const CsvTable& table) {
  for (const Followed& test : followed(data.points)) {
    for (const Branch& branch : branches_of(test))
      if (branch.anew)
        throw BadInput({table.file, table.rows[test.points[branch.begin].row].line, "rate"},
                       "a second curve from here on", "one curve a file, or its rows chosen with where");
    for (const HeldRows& held : holds_of(test))
      throw BadInput({table.file, table.rows[test.points[held.begin].row].line, "rate"},
                     fmt::format("a stretch that is held over {} rows, of whose times a rate says nothing",
                                 held.end - held.begin + 1),
                     "a column of time (time_s), or a choice of rows (where) without the hold");
  }
}

// Each deformation begins at rest, at 0 s.
void pace(CurveData& data, double rate) {
  double time = 0, last = 0;
  const Strained* before = nullptr;
  for (StressPoint& point : data.points) {
    const double rest = point.strained.deformation == Deformation::simple_shear ? 0 : 1;
    const double strain = point.strained.amount - rest;
    if (!before || before->deformation != point.strained.deformation) time = last = 0;
    time += std::abs(strain - last) / rate;
    last = strain;
    point.time = time;
    before = &point.strained;
  }
}

}  // namespace

void read_times(CurveData& data, const CsvTable& table, const TimesWanted& wanted, const CurveAxes& axes) {
  const auto column = time_column(table, wanted, axes);
  const auto rate = rate_of(table, wanted);
  const Place header{table.file, table.header_line, ""};
  if (!column && !rate) throw BadInput(header, "no times: no column of time among its columns", how_times_are_said);
  if (column && rate)
    throw BadInput(
        header,
        "a rate beside the column of time " + in_quotes(table.columns[static_cast<std::size_t>(*column)].header),
        "one of them: the column has the times already");
  if (column) {
    const std::vector<double> times = table.numbers(*column, dimension::time);
    for (std::size_t i = 0; i < times.size(); ++i) data.points[i].time = times[i];
    return;
  }
  refuse_what_a_rate_cannot_tell(data, table);
  pace(data, *rate);
  data.sources.back().taken.push_back(
      fmt::format("{}: times from a rate of {}, from rest on.", table.file, page::quantity(*rate, dimension::rate)));
}

}  // namespace percal
