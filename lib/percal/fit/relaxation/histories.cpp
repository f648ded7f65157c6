#include "percal/fit/relaxation/histories.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "percal/base/error.hpp"
#include "percal/page/numbers.hpp"

namespace percal {
namespace {

constexpr double rest = 1e-12;  // strain that is none

double strain_of(const StressPoint& point) {
  return point.strained.amount - (point.strained.deformation == Deformation::simple_shear ? 0 : 1);
}

bool goes_on(const StressPoint& before, const StressPoint& point) {
  return before.source == point.source && before.strained.deformation == point.strained.deformation &&
         *point.time >= *before.time;
}

void find_start(History& history, const CurveData& data) {
  const StressPoint &first = data.points[history.begin], &second = data.points[history.begin + 1];
  const double strain = strain_of(first), step = strain_of(second) - strain, elapsed = *second.time - *first.time;
  history.start = *first.time;
  if (std::abs(strain) <= rest) return;
  history.from_rest = step * strain > 0 && elapsed > 0 ? FromRest::at_rate : FromRest::at_once;
  if (history.from_rest == FromRest::at_rate) history.start -= strain / step * elapsed;
}

std::string file_of(const CurveData& data, const History& history) {
  return data.sources.empty() ? "" : data.sources[static_cast<std::size_t>(history.source)].file;
}

}  // namespace

std::vector<History> histories_of(const CurveData& data) {
  std::vector<History> all;
  for (std::size_t i = 0; i < data.points.size(); ++i) {
    const StressPoint& point = data.points[i];
    if (i == 0 || !goes_on(data.points[i - 1], point))
      all.push_back({.source = point.source, .deformation = point.strained.deformation, .begin = i, .end = i});
    all.back().end = i + 1;
  }
  for (History& history : all) {
    if (history.rows() < 2)
      throw BadInput({file_of(data, history), 0, "time"},
                     fmt::format("a test of one row, at {:g} s", *data.points[history.begin].time),
                     "tests of two rows or more, in the order of time");
    find_start(history, data);
  }
  return all;
}

TimeScales time_scales(const CurveData& data, const std::vector<History>& histories) {
  TimeScales scales{.shortest_interval = std::numeric_limits<double>::infinity()};
  for (const History& history : histories) {
    for (std::size_t i = history.begin + 1; i < history.end; ++i)
      if (const double elapsed = *data.points[i].time - *data.points[i - 1].time; elapsed > 0)
        scales.shortest_interval = std::min(scales.shortest_interval, elapsed);
    scales.longest_record = std::max(scales.longest_record, *data.points[history.end - 1].time - history.start);
  }
  if (!(scales.longest_record > 0) || !std::isfinite(scales.shortest_interval))
    throw BadInput({histories.empty() ? "" : file_of(data, histories[0]), 0, "time"}, "rows all at one time",
                   "rows between which time passes");
  return scales;
}

std::vector<std::string> starts_in_words(const CurveData& data, const std::vector<History>& histories) {
  std::vector<std::string> words;
  int number = 0;
  for (const History& history : histories) {
    ++number;
    const StressPoint& first = data.points[history.begin];
    if (history.from_rest == FromRest::at_rest) continue;
    const std::string where = fmt::format(
        "{}: test {} begins at {} {:.5g}: taken as reached from rest ", file_of(data, history), number,
        first.strained.deformation == Deformation::simple_shear ? "gamma" : "stretch", first.strained.amount);
    words.push_back(history.from_rest == FromRest::at_once
                        ? where + "at once."
                        : where + "in " + page::quantity(*first.time - history.start, dimension::time, 3) +
                              ", as fast as from its first row to its second.");
  }
  return words;
}

}  // namespace percal
