#include "percal/fit/curve_columns.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <stdexcept>
#include <utility>

#include "percal/material/conventions.hpp"
#include "percal/text/csv_cells.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

bool contains_any(const std::string& text, std::initializer_list<const char*> parts) {
  return std::any_of(parts.begin(), parts.end(),
                     [&](const char* part) { return text.find(part) != std::string::npos; });
}

// Scatter of a quantity, not the quantity: "sem_kPa", "stress_sd_kPa".
bool is_scatter(const std::string& name) {
  const std::string framed = "_" + name + "_";
  return contains_any(framed, {"_sem_", "_sd_", "_std_", "_se_", "_err_", "_error_", "_tol_", "_uncertainty_"});
}

bool may_be_y(const std::string& name) {
  return contains_any(name, {"stress", "sigma", "cauchy", "piola", "kirchhoff", "pk1", "pk2"}) && !is_scatter(name);
}

bool may_be_x(const std::string& name) {
  return contains_any(name, {"stretch", "strain", "gamma", "lambda", "shear"}) && !contains_any(name, {"rate"}) &&
         !may_be_y(name) && !is_scatter(name);
}

std::string headers(const CsvTable& table, bool (*wanted)(const std::string&) = nullptr) {
  std::string text;
  for (const auto& column : table.columns)
    if (!column.header.empty() && (!wanted || wanted(lower_case(column.name))))
      text += (text.empty() ? "" : ", ") + column.header;
  return text;
}

// The one column that `wanted` holds for.
int single(const CsvTable& table, bool (*wanted)(const std::string&), const char* option, const char* meaning) {
  std::vector<int> found;
  for (int i = 0; i < static_cast<int>(table.columns.size()); ++i)
    if (wanted(lower_case(table.columns[i].name))) found.push_back(i);
  const Place place{table.file, table.header_line, ""};
  if (found.size() > 1)
    throw BadInput(place, fmt::format("several columns of {}: {}", meaning, headers(table, wanted)),
                   fmt::format("one of them, chosen with {}", option));
  if (!found.empty()) return found[0];
  const std::string names = lower_case(headers(table));
  const bool depths = contains_any(names, {"depth", "penetration"});
  const bool machine =
      contains_any(names, {"force", "load", "displacement", "extension", "elongation", "deflection", "travel"});
  throw BadInput(
      place,
      fmt::format("no stress-stretch curve{}: no column of {} among {}",
                  depths ? " but depths of shots, which are no input of a curve fit" : "", meaning, headers(table)),
      fmt::format("a column of {}, or the column's name with {}{}", meaning, option,
                  machine
                      ? "; of force and displacement make stretch = 1 + displacement/(length between the grips) and "
                        "nominal stress = force/(cross-section before the test)"
                      : ""));
}

bool is_pressure(const CsvColumn& column) {
  try {
    return column_unit(column.unit).dimension == dimension::pressure;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

std::optional<int> error_column(const CsvTable& table, int y) {
  std::vector<int> all, of_y;
  for (int i = 0; i < static_cast<int>(table.columns.size()); ++i) {
    const CsvColumn& column = table.columns[i];
    if (i == y || !is_scatter(lower_case(column.name)) || !is_pressure(column)) continue;
    all.push_back(i);
    if (lower_case(column.name).starts_with(lower_case(table.columns[y].name) + "_")) of_y.push_back(i);
  }
  if (of_y.size() == 1) return of_y[0];
  return all.size() == 1 ? std::optional(all[0]) : std::nullopt;
}

}  // namespace

FoundColumns find_columns(const CsvTable& table, const CurveColumns& wanted) {
  FoundColumns found{};
  constexpr const char* x_meaning = "stretch, strain or shear";
  constexpr const char* y_meaning = "stress (a name with stress, sigma or cauchy)";
  found.y = wanted.y.empty() ? single(table, may_be_y, "--y", y_meaning) : table.column(wanted.y);
  found.x = wanted.x.empty() ? single(table, may_be_x, "--x", x_meaning) : table.column(wanted.x);
  found.y_words = stress_words(table, found.y);
  found.x_words = abscissa_words(table, found.x);
  for (const char* name : {"mode", "deformation"})
    if (!found.mode) found.mode = table.find(name);
  found.error = wanted.error.empty() ? error_column(table, found.y) : table.column(wanted.error);
  return found;
}

int partner_column(const CsvTable& table, int x) {
  const std::string& name = table.columns[x].name;
  if (!name.empty())
    for (const auto& [from, to] : {std::pair{'x', 'y'}, {'y', 'x'}, {'1', '2'}, {'2', '1'}}) {
      if (name.back() != from) continue;
      if (const auto partner = table.find(name.substr(0, name.size() - 1) + to)) return *partner;
    }
  throw BadInput({table.file, table.header_line, table.columns[x].header}, "no second stretch for general_biaxial",
                 "two columns such as stretch_x and stretch_y");
}

double amount_of(double value, Abscissa abscissa, Deformation deformation) {
  if (deformation == Deformation::simple_shear) {
    if (abscissa == Abscissa::gamma || abscissa == Abscissa::stretch_or_gamma ||
        abscissa == Abscissa::engineering_strain)
      return value;
    throw std::invalid_argument("no shear gamma for simple shear; accepted: a column named gamma, shear or strain");
  }
  if (abscissa == Abscissa::gamma)
    throw std::invalid_argument(
        fmt::format("gamma for {}; accepted: a column of stretch or strain", word(deformation)));
  double stretch = value;
  if (abscissa == Abscissa::engineering_strain) stretch = stretch_at(value, StrainMeasure::engineering);
  if (abscissa == Abscissa::true_strain) stretch = stretch_at(value, StrainMeasure::true_strain);
  if (abscissa == Abscissa::green_lagrange_strain) {
    if (value <= -0.5)
      throw std::invalid_argument(fmt::format("Green-Lagrange strain {}; accepted: above -0.5", value));
    stretch = stretch_at(value, StrainMeasure::green_lagrange);
  }
  if (abscissa == Abscissa::almansi_strain) {
    if (value >= 0.5) throw std::invalid_argument(fmt::format("Almansi strain {}; accepted: below 0.5", value));
    stretch = 1 / std::sqrt(1 - 2 * value);
  }
  if (!(stretch > 0 && stretch < 1e6))
    throw std::invalid_argument(
        abscissa == Abscissa::stretch || abscissa == Abscissa::stretch_or_gamma
            ? fmt::format(
                  "stretch {}; accepted: a stretch above 0 (1 = undeformed; strains belong in a column named strain)",
                  value)
            : fmt::format("strain {}; accepted: an engineering strain above -1", value));
  return stretch;
}

}  // namespace percal
