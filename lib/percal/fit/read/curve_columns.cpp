#include "percal/fit/read/curve_columns.hpp"

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

// As testing machines name them.
bool may_be_force(const std::string& name) {
  return (name == "f" || contains_any(name, {"force", "load"})) && !is_scatter(name) &&
         !contains_any(name, {"rate", "speed", "loading", "time"});
}

bool may_be_displacement(const std::string& name) {
  return (name == "disp" || name == "stroke" ||
          contains_any(name, {"displacement", "extension", "elongation", "deflection", "travel", "crosshead"})) &&
         !is_scatter(name) && !contains_any(name, {"rate", "speed", "velocity", "strain", "time"});
}

bool has_dimension(const CsvColumn& column, const Dimension& dimension) {
  try {
    return column_unit(column.unit).dimension == dimension;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

std::string headers(const CsvTable& table, bool (*wanted)(const std::string&) = nullptr) {
  std::string text;
  for (const auto& column : table.columns)
    if (!column.header.empty() && (!wanted || wanted(lower_case(column.name))))
      text += (text.empty() ? "" : ", ") + column.header;
  return text;
}

// The one column that `wanted` holds for; of several the one with a unit of this dimension.
int single(const CsvTable& table, bool (*wanted)(const std::string&), const char* option, const char* meaning,
           const std::optional<Dimension>& dimension = {}) {
  std::vector<int> found;
  for (int i = 0; i < static_cast<int>(table.columns.size()); ++i)
    if (wanted(lower_case(table.columns[i].name))) found.push_back(i);
  const Place place{table.file, table.header_line, ""};
  if (found.size() > 1 && dimension) {
    std::vector<int> of_dimension;
    for (const int i : found)
      if (has_dimension(table.columns[i], *dimension)) of_dimension.push_back(i);
    if (of_dimension.size() == 1) return of_dimension[0];
  }
  if (found.size() > 1)
    throw BadInput(place, fmt::format("several columns of {}: {}", meaning, headers(table, wanted)),
                   fmt::format("one of them, chosen with {}", option));
  if (!found.empty()) return found[0];
  const std::string names = lower_case(headers(table));
  const bool depths = contains_any(names, {"depth", "penetration"});
  const bool machine = !dimension && contains_any(names, {"force", "load", "displacement", "extension", "elongation",
                                                          "deflection", "travel"});
  throw BadInput(
      place,
      fmt::format("no stress-stretch curve{}: no column of {} among {}",
                  depths ? " but depths of shots, which are no input of a curve fit" : "", meaning, headers(table)),
      fmt::format("a column of {}, or the column's name with {}{}", meaning, option,
                  machine
                      ? "; of force and displacement make stretch = 1 + displacement/(length between the grips) and "
                        "nominal stress = force/(cross-section before the test), or say these (--gauge-length, --area)"
                      : ""));
}

std::optional<int> error_column(const CsvTable& table, int y, const Dimension& dimension) {
  std::vector<int> all, of_y;
  for (int i = 0; i < static_cast<int>(table.columns.size()); ++i) {
    const CsvColumn& column = table.columns[i];
    if (i == y || !is_scatter(lower_case(column.name)) || !has_dimension(column, dimension)) continue;
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
  constexpr const char* force_meaning = "force (a name with force or load)";
  constexpr const char* displacement_meaning =
      "displacement (a name with displacement, extension, crosshead or travel)";
  const auto& [gauge_length, area] = wanted.specimen;
  if (!wanted.y.empty())
    found.y = table.column(wanted.y);
  else
    found.y = area ? single(table, may_be_force, "--y", force_meaning, dimension::force)
                   : single(table, may_be_y, "--y", y_meaning);
  if (!wanted.x.empty())
    found.x = table.column(wanted.x);
  else
    found.x = gauge_length ? single(table, may_be_displacement, "--x", displacement_meaning, dimension::length)
                           : single(table, may_be_x, "--x", x_meaning);
  if (area) {
    found.y_words = {StressMeasure::nominal, says_compressive(table.columns[found.y])};
    found.y_dimension = dimension::force;
    found.y_over = *area;
  } else {
    found.y_words = stress_words(table, found.y);
  }
  if (gauge_length) {
    found.x_words = {Abscissa::engineering_strain, 1, says_compressive(table.columns[found.x])};
    found.x_dimension = dimension::length;
    found.x_over = *gauge_length;
  } else {
    found.x_words = abscissa_words(table, found.x);
    found.x_over = 1 / found.x_words.size;  // a division by 100 rounds better than a product with 0.01
  }
  for (const char* name : {"mode", "deformation"})
    if (!found.mode) found.mode = table.find(name);
  found.error = wanted.error.empty() ? error_column(table, found.y, found.y_dimension) : table.column(wanted.error);
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
