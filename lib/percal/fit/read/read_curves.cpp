#include "percal/fit/read/read_curves.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <stdexcept>

#include "percal/fit/points/thin_curves.hpp"
#include "percal/fit/read/curve_columns.hpp"
#include "percal/fit/read/curve_shapes.hpp"
#include "percal/fit/read/curve_times.hpp"
#include "percal/fit/read/curve_warnings.hpp"
#include "percal/page/numbers.hpp"
#include "percal/text/csv_cells.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

constexpr double largest_stress = 1e30;  // Pa; beyond any solid's, and its square is finite

Deformation mode_given(const std::string& mode) {
  if (const auto deformation = deformation_of(mode)) return *deformation;
  throw BadInput({"", 0, "--mode"}, in_quotes(mode), deformation_words());
}

// The word for the deformation of every row: the mode column's, or one for all.
struct ModeWords {
  std::string of_all;
  std::vector<std::string> of_row = {};
  const std::string& operator[](std::size_t i) const { return of_row.empty() ? of_all : of_row[i]; }
};

// The mode given stands where the file has no mode column, and where none of the column's words is known.
ModeWords mode_words(const CsvTable& table, FoundColumns& found, const std::string& mode,
                     std::vector<std::string>& warnings) {
  if (!found.mode) return {mode};
  std::vector<std::string> words;
  for (const auto& row : table.rows) words.push_back(table.cell(row, *found.mode));
  const std::set<std::string> different(words.begin(), words.end());
  if (mode.empty() ||
      std::any_of(different.begin(), different.end(), [](const auto& word) { return deformation_of(word); }))
    return {mode, words};
  std::vector<std::string> quoted;
  for (const auto& word : different) quoted.push_back(in_quotes(word));
  warnings.push_back(fmt::format("{}: {} of column {} {} none of percal's: {} is taken as --mode says{}.", table.file,
                                 listed(quoted), in_quotes(table.columns[static_cast<std::size_t>(*found.mode)].header),
                                 different.size() == 1 ? "is a word that is" : "are words that are", mode,
                                 different.size() == 1 ? "" : ", all of them as one test (--where keeps one)"));
  found.mode.reset();
  return {mode};
}

// The deformation of every row.
std::vector<Deformation> deformations(const CsvTable& table, const FoundColumns& found, const ModeWords& words) {
  if (!found.mode) {
    if (words.of_all.empty())
      throw BadInput({table.file, table.header_line, ""}, "no column 'mode'",
                     "--mode with one of " + deformation_words());
    return std::vector<Deformation>(table.rows.size(), mode_given(words.of_all));
  }
  LineFaults faults(table.file);
  std::vector<Deformation> all;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const auto deformation = deformation_of(words[i]);
    if (!deformation)
      faults.add(
          table.rows[i].line,
          fmt::format("{}: found {}; accepted: {}; or --mode, which stands where none of the column's words is known",
                      table.columns[*found.mode].header, in_quotes(words[i]), deformation_words()));
    all.push_back(deformation.value_or(Deformation::uniaxial));
  }
  faults.throw_if_any();
  return all;
}

// Which rows a word calls compression: the mode's, or that of a header.
std::vector<bool> compressed_rows(const CsvTable& table, const FoundColumns& found, const ModeWords& words,
                                  const std::vector<Deformation>& modes) {
  const bool by_x = found.x_words.compressive, by_y = found.y_words.compressive;
  std::vector<bool> compressed;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    if ((by_x || by_y) && says_tension(words[i]))
      throw BadInput(
          {table.file, table.rows[i].line, table.columns[static_cast<std::size_t>(by_x ? found.x : found.y)].header},
          "the word of compression in the header, but the mode " + in_quotes(words[i]),
          "the mode compression, or another name of the column");
    compressed.push_back(modes[i] != Deformation::simple_shear && (by_x || by_y || says_compression(words[i])));
  }
  return compressed;
}

// Empty cells are no error known, no column none at all; a negative one is refused.
std::vector<std::optional<double>> standard_errors(const CsvTable& table, const FoundColumns& found) {
  if (!found.error) return {};
  const std::string& header = table.columns[*found.error].header;
  auto errors = table.optional_numbers(header, found.y_dimension);
  for (auto& error : errors)
    if (error) *error /= found.y_over;
  LineFaults faults(table.file);
  for (std::size_t i = 0; i < errors.size(); ++i)
    if (errors[i] && *errors[i] < 0)
      faults.add(table.rows[i].line, fmt::format("{}: found {:.4g} Pa; accepted: a standard error not below zero, or "
                                                 "an empty cell",
                                                 header, *errors[i]));
  faults.throw_if_any();
  return errors;
}

// A column's numbers, each divided: percent becomes a share, a displacement a strain, a force a stress.
std::vector<double> divided(const CsvTable& table, int column, const Dimension& dimension, double over) {
  auto values = table.numbers(column, dimension);
  for (double& value : values) value /= over;
  return values;
}

// Force and displacement are stress and strain where both act along one edge of a block.
void refuse_geometry(const CsvTable& table, const std::vector<Deformation>& modes, const Specimen& specimen) {
  if (!specimen.gauge_length && !specimen.area) return;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    if (modes[i] == Deformation::uniaxial || modes[i] == Deformation::planar || modes[i] == Deformation::simple_shear)
      continue;
    throw BadInput({table.file, table.rows[i].line, specimen.gauge_length ? "gauge length" : "cross-section"},
                   word(modes[i]) + ", of which force and displacement alone do not tell stress and stretch",
                   "uniaxial, planar or simple_shear; for others columns of stress and stretch");
  }
}

// "machine.csv: stretch = 1 + Extension/10 mm, nominal stress = Load/78.54 mm2."
std::vector<std::string> geometry_words(const CsvTable& table, const FoundColumns& found, const Specimen& specimen,
                                        const std::vector<Deformation>& modes) {
  const auto name = [&](int column) { return table.columns[static_cast<std::size_t>(column)].name; };
  std::vector<std::string> words;
  if (specimen.gauge_length)
    words.push_back(fmt::format("{}{}/{}", modes[0] == Deformation::simple_shear ? "gamma = " : "stretch = 1 + ",
                                name(found.x), page::length(*specimen.gauge_length)));
  if (specimen.area)
    words.push_back(
        fmt::format("nominal stress = {}/{}", name(found.y), page::quantity(*specimen.area, dimension::area)));
  if (words.empty()) return {};
  return {table.file + ": " + listed(words) + "."};
}

// Runs the readings and joins the messages of those that fail, so that one message names every bad line of every
// column.
void together(const std::vector<std::function<void()>>& readings) {
  std::string faults;
  for (const auto& read : readings) {
    try {
      read();
    } catch (const BadInput& error) {
      faults += (faults.empty() ? "" : "\n") + std::string(error.what());
    }
  }
  if (!faults.empty()) throw BadInput(faults);
}

// A --mode that no file needs and that the mode columns contradict would be ignored in silence.
void refuse_idle_mode(const CurveData& data, const std::string& mode) {
  const bool needed =
      std::any_of(data.sources.begin(), data.sources.end(), [](const auto& source) { return !source.mode_column; });
  if (mode.empty() || needed) return;
  const Deformation given = mode_given(mode);
  for (const auto& point : data.points)
    if (point.strained.deformation != given)
      throw BadInput({data.sources[0].file, 0, "--mode"},
                     mode + ", but the file's mode column says " + word(point.strained.deformation),
                     "--where mode=... to choose rows, or no --mode");
}

bool general_biaxial(const std::string& mode) { return deformation_of(mode) == Deformation::biaxial; }

}  // namespace

CurveData curves_of(const CsvTable& whole, const CurveColumns& wanted) {
  const CsvTable table = whole.where(wanted.where);
  FoundColumns found = find_columns(table, wanted);
  std::vector<std::string> warnings;
  const ModeWords words = mode_words(table, found, wanted.mode, warnings);
  const CsvColumn &x_column = table.columns[found.x], &y_column = table.columns[found.y];
  std::vector<Deformation> modes;
  CurveNumbers numbers;
  auto& [x, y] = numbers;
  std::vector<double> across;
  std::vector<std::optional<double>> errors;
  together({[&] { modes = deformations(table, found, words); },
            [&] { numbers.x = divided(table, found.x, found.x_dimension, found.x_over); },
            [&] { numbers.y = divided(table, found.y, found.y_dimension, found.y_over); },
            [&] { errors = standard_errors(table, found); },
            [&] {
              if (found.mode || !general_biaxial(wanted.mode)) return;
              const int partner = partner_column(table, found.x);
              across = divided(table, partner, dimension::none, 1 / abscissa_words(table, partner).size);
            }});
  refuse_geometry(table, modes, wanted.specimen);

  CurveData data;
  if (!table.passed_over.empty())
    warnings.push_back(
        fmt::format("{}: the table starts at line {}; {} before it {} passed over.", table.file, table.header_line,
                    table.passed_over.size() == 1 ? "1 line" : fmt::format("{} lines", table.passed_over.size()),
                    table.passed_over.size() == 1 ? "is" : "are"));
  turn_compression(numbers, table, found, compressed_rows(table, found, words, modes), warnings);
  LineFaults faults(table.file);
  data.points.reserve(table.rows.size());
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    StressPoint point{{modes[i], 1, 1}, 0};
    try {
      point.strained.amount = amount_of(x[i], found.x_words.abscissa, modes[i]);
      if (modes[i] == Deformation::biaxial && across.empty())
        throw std::invalid_argument(
            "general_biaxial in a mode column; accepted: --mode general_biaxial for a whole file");
      if (!across.empty()) point.strained.across = amount_of(across[i], found.x_words.abscissa, modes[i]);
    } catch (const std::invalid_argument& error) {
      faults.add(table.rows[i].line, fmt::format("{}: found {}", x_column.header, error.what()));
      continue;
    }
    if (std::abs(y[i]) > largest_stress) {
      faults.add(table.rows[i].line, fmt::format("{}: found {:.4g} Pa; accepted: at most {:.0e} Pa", y_column.header,
                                                 y[i], largest_stress));
      continue;
    }
    const StressMeasure measure = found.y_words.measure;
    try {
      point.nominal_stress = nominal_of(y[i], measure, point.strained);
      if (!errors.empty() && errors[i]) point.standard_error = nominal_of(*errors[i], measure, point.strained);
    } catch (const std::invalid_argument& error) {
      faults.add(table.rows[i].line, fmt::format("{}: found {}", y_column.header, error.what()));
    }
    data.points.push_back(point);
  }
  faults.throw_if_any();
  const auto materials = several_materials(table, found, modes);
  for (const auto& doubts :
       {implausible(table, found, x, data.points), materials,
        materials.empty() ? shapes(table, found, data.points, wanted.rows) : std::vector<std::string>{}})
    warnings.insert(warnings.end(), doubts.begin(), doubts.end());
  data.sources.push_back({.file = table.file,
                          .x = x_column.header,
                          .y = y_column.header,
                          .error = found.error ? table.columns[*found.error].header : "",
                          .stress = found.y_words.measure,
                          .mode_column = found.mode.has_value(),
                          .points = static_cast<int>(data.points.size()),
                          .specimen = wanted.specimen,
                          .taken = geometry_words(table, found, wanted.specimen, modes),
                          .warnings = warnings});
  if (wanted.times) read_times(data, table, *wanted.times, {found.x, found.y});
  choose_rows(data, table, wanted.rows);
  thin(data);
  return data;
}

CurveData read_curves(const std::vector<std::string>& files, const CurveColumns& wanted) {
  if (!wanted.mode.empty()) mode_given(wanted.mode);
  for (const auto& [file, mode] : wanted.mode_of) mode_given(mode);
  CurveData all;
  std::string faults;
  for (const auto& file : files) {
    try {
      CurveColumns of_file = wanted;
      if (const auto mode = wanted.mode_of.find(file); mode != wanted.mode_of.end()) of_file.mode = mode->second;
      CurveData one = curves_of(read_csv(file), of_file);
      if (of_file.mode != wanted.mode) refuse_idle_mode(one, of_file.mode);
      for (auto& point : one.points) point.source = static_cast<int>(all.sources.size());
      all.points.insert(all.points.end(), one.points.begin(), one.points.end());
      all.sources.insert(all.sources.end(), one.sources.begin(), one.sources.end());
    } catch (const BadInput& error) {
      faults += (faults.empty() ? "" : "\n") + std::string(error.what());
    }
  }
  if (!faults.empty()) throw BadInput(faults);
  refuse_idle_mode(all, wanted.mode);
  return all;
}

}  // namespace percal
