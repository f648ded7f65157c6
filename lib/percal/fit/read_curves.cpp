#include "percal/fit/read_curves.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "percal/fit/curve_columns.hpp"
#include "percal/fit/curve_warnings.hpp"
#include "percal/text/csv_cells.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

constexpr double largest_stress = 1e30;  // Pa; beyond any solid's, and its square is finite

Deformation mode_given(const std::string& mode) {
  if (const auto deformation = deformation_of(mode)) return *deformation;
  throw BadInput({"", 0, "--mode"}, in_quotes(mode), deformation_words());
}

// The deformation of every row.
std::vector<Deformation> deformations(const CsvTable& table, const FoundColumns& found, const std::string& mode) {
  if (!found.mode) {
    if (mode.empty())
      throw BadInput({table.file, table.header_line, ""}, "no column 'mode'",
                     "--mode with one of " + deformation_words());
    return std::vector<Deformation>(table.rows.size(), mode_given(mode));
  }
  LineFaults faults(table.file);
  std::vector<Deformation> all;
  for (const auto& row : table.rows) {
    const auto deformation = deformation_of(row.cells[*found.mode]);
    if (!deformation)
      faults.add(row.line, fmt::format("{}: found {}; accepted: {}", table.columns[*found.mode].header,
                                       in_quotes(row.cells[*found.mode]), deformation_words()));
    all.push_back(deformation.value_or(Deformation::uniaxial));
  }
  faults.throw_if_any();
  return all;
}

// Which rows a word calls compression: the mode's, or that of a header.
std::vector<bool> compressed_rows(const CsvTable& table, const FoundColumns& found, const std::string& mode,
                                  const std::vector<Deformation>& modes) {
  std::vector<bool> compressed;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const std::string& word = found.mode ? table.rows[i].cells[static_cast<std::size_t>(*found.mode)] : mode;
    const bool by_header = found.x_words.compressive || found.y_words.compressive;
    compressed.push_back(modes[i] != Deformation::simple_shear && (by_header || says_compression(word)));
  }
  return compressed;
}

// Empty cells are no error known; a negative one is refused.
std::vector<std::optional<double>> standard_errors(const CsvTable& table, std::optional<int> column) {
  if (!column) return std::vector<std::optional<double>>(table.rows.size());
  const std::string& header = table.columns[*column].header;
  const auto errors = table.optional_numbers(header, dimension::pressure);
  LineFaults faults(table.file);
  for (std::size_t i = 0; i < errors.size(); ++i)
    if (errors[i] && *errors[i] < 0)
      faults.add(table.rows[i].line, fmt::format("{}: found {:.4g} Pa; accepted: a standard error not below zero, or "
                                                 "an empty cell",
                                                 header, *errors[i]));
  faults.throw_if_any();
  return errors;
}

// A dimensionless column; percent becomes a share here, where it means a strain.
std::vector<double> abscissae(const CsvTable& table, int column, double size) {
  auto values = table.numbers(column, dimension::none);
  const double parts = 1 / size;  // a division by 100 rounds better than a product with 0.01
  for (double& value : values) value /= parts;
  return values;
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
  const FoundColumns found = find_columns(table, wanted);
  const CsvColumn &x_column = table.columns[found.x], &y_column = table.columns[found.y];
  std::vector<Deformation> modes;
  CurveNumbers numbers;
  auto& [x, y] = numbers;
  std::vector<double> across;
  std::vector<std::optional<double>> errors;
  together({[&] { modes = deformations(table, found, wanted.mode); },
            [&] { numbers.x = abscissae(table, found.x, found.x_words.size); },
            [&] { numbers.y = table.numbers(found.y, dimension::pressure); },
            [&] { errors = standard_errors(table, found.error); },
            [&] {
              if (found.mode || !general_biaxial(wanted.mode)) return;
              const int partner = partner_column(table, found.x);
              across = abscissae(table, partner, abscissa_words(table, partner).size);
            }});

  CurveData data;
  std::vector<std::string> warnings;
  if (!table.passed_over.empty())
    warnings.push_back(
        fmt::format("{}: the table starts at line {}; {} before it {} passed over.", table.file, table.header_line,
                    table.passed_over.size() == 1 ? "1 line" : fmt::format("{} lines", table.passed_over.size()),
                    table.passed_over.size() == 1 ? "is" : "are"));
  turn_compression(numbers, table, found, compressed_rows(table, found, wanted.mode, modes), warnings);
  LineFaults faults(table.file);
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
      if (errors[i]) point.standard_error = nominal_of(*errors[i], measure, point.strained);
    } catch (const std::invalid_argument& error) {
      faults.add(table.rows[i].line, fmt::format("{}: found {}", y_column.header, error.what()));
    }
    data.points.push_back(point);
  }
  faults.throw_if_any();
  const auto doubts = implausible(table, found, x, data.points);
  warnings.insert(warnings.end(), doubts.begin(), doubts.end());
  data.sources.push_back({.file = table.file,
                          .x = x_column.header,
                          .y = y_column.header,
                          .error = found.error ? table.columns[*found.error].header : "",
                          .stress = found.y_words.measure,
                          .mode_column = found.mode.has_value(),
                          .points = static_cast<int>(data.points.size()),
                          .warnings = warnings});
  return data;
}

CurveData read_curves(const std::vector<std::string>& files, const CurveColumns& wanted) {
  if (!wanted.mode.empty()) mode_given(wanted.mode);
  CurveData all;
  std::string faults;
  for (const auto& file : files) {
    try {
      CurveData one = curves_of(read_csv(file), wanted);
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
