#include "percal/sweep/plan_points.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <stdexcept>

#include "percal/text/csv_cells.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

// A number as it stands, and its unit: "83 m/s" is 83 and "m/s".
struct Measure {
  double number = NAN;
  std::string unit = "";
  double size = 1;  // of the unit, in SI
  Dimension dimension = {};
};

bool is_angle(const std::string& unit) { return unit == "deg" || unit == "rad" || unit == "\u00b0"; }

// Nothing of what is no quantity: a word.
std::optional<Measure> measure_of(const std::string& text) {
  const std::string bare = trimmed(text);
  Measure measure;
  const auto [end, error] = std::from_chars(bare.data(), bare.data() + bare.size(), measure.number);
  if (error != std::errc() || !std::isfinite(measure.number)) return std::nullopt;
  measure.unit = trimmed(std::string(end, bare.data() + bare.size()));
  if (measure.unit.empty() || is_angle(measure.unit)) return measure;
  try {
    const Quantity one = parse_unit(measure.unit);
    measure.size = one.value;
    measure.dimension = one.dimension;
    return measure;
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

std::optional<Measure> measure_of(const TomlScalar& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return measure_of(*text);
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return Measure{.number = static_cast<double>(*whole)};
  if (const auto* number = std::get_if<double>(&value)) return Measure{.number = *number};
  return std::nullopt;
}

bool of_one_kind(const Measure& a, const Measure& b) {
  return a.dimension == b.dimension && a.unit.empty() == b.unit.empty() && is_angle(a.unit) == is_angle(b.unit) &&
         (!is_angle(a.unit) || a.unit == b.unit);
}

double in_unit_of(const Measure& measure, const Measure& first) {
  return measure.unit == first.unit ? measure.number : measure.number * measure.size / first.size;
}

// Rounded to 12 digits, so that a tenth of something reads as one.
TomlScalar scalar_of(double number, const std::string& unit, bool is_whole) {
  if (is_whole && number == std::round(number)) return static_cast<std::int64_t>(number);
  const std::string text = fmt::format("{:.12g}", number);
  if (!unit.empty()) return text + " " + unit;
  return std::stod(text);
}

double between(const SweptRange& range, double share) {
  if (share <= 0) return range.low;
  if (share >= 1) return range.high;
  if (range.is_logarithmic) return range.low * std::pow(range.high / range.low, share);
  return range.low + share * (range.high - range.low);
}

void need_numbers_of_group(const SweepAxis& axis, const Place& place) {
  if (!axis.group || (axis.is_number && axis.unit.empty())) return;
  throw BadInput(place, axis.is_number ? "numbers with a unit" : "words",
                 "numbers, since " + axis.key + " has no dimension");
}

// Numbers of one kind make an axis of numbers; anything else are words.
void take_unit(const std::vector<TomlScalar>& values, SweepAxis& axis, std::vector<SweptValue>& taken) {
  std::vector<Measure> measures;
  for (const TomlScalar& value : values) {
    const auto measure = measure_of(value);
    axis.is_number = axis.is_number && measure && (measures.empty() || of_one_kind(*measure, measures.front()));
    if (!axis.is_number) break;
    measures.push_back(*measure);
  }
  if (axis.is_number) axis.unit = measures.front().unit;
  for (std::size_t k = 0; k < values.size(); ++k)
    taken.push_back({values[k], axis.is_number ? in_unit_of(measures[k], measures.front()) : NAN});
}

// A cell as a scene would say it.
TomlScalar scalar_of_cell(const std::string& cell, const CsvColumn& column, bool decimal_comma, const Place& place) {
  const ParsedNumber number = parse_number(cell, decimal_comma);
  if (!column.unit.empty()) {
    if (!number.value) throw BadInput(place, in_quotes(cell), "a number in " + column.unit);
    return fmt::format("{} {}", *number.value, column.unit);
  }
  if (cell == "true" || cell == "false") return cell == "true";
  if (!number.value) return cell;
  const bool is_whole = cell.find_first_not_of("+-0123456789") == std::string::npos && std::abs(*number.value) < 1e15;
  return is_whole ? TomlScalar(static_cast<std::int64_t>(*number.value)) : TomlScalar(*number.value);
}

}  // namespace

void check_range(SweptRange& range, const SweepAxis& axis, const TomlTable& block) {
  const auto from = measure_of(range.from), to = measure_of(range.to);
  const char* const accepted = "a number, with its unit in quotes where it has one";
  if (!from) block.refuse("from", written(range.from), accepted);
  if (!to || !of_one_kind(*from, *to)) block.refuse("to", written(range.to), "a number of the kind of from");
  if (axis.group && !from->unit.empty())
    block.refuse("from", written(range.from), "a number, since a group has no dimension");
  range.unit = from->unit;
  range.low = from->number;
  range.high = in_unit_of(*to, *from);
  range.is_whole = std::holds_alternative<std::int64_t>(range.from) && std::holds_alternative<std::int64_t>(range.to);
  if (range.low == range.high) block.refuse("to", written(range.to), "another number than from");
  if (range.is_logarithmic && !(range.low * range.high > 0))
    block.refuse("spacing", "\"log\" from " + written(range.from) + " to " + written(range.to),
                 "two numbers of one sign, none of them 0");
}

std::vector<TomlScalar> spaced_values(const SweptRange& range, int count) {
  std::vector<TomlScalar> values;
  for (int k = 0; k < count; ++k)
    values.push_back(scalar_of(between(range, static_cast<double>(k) / (count - 1)), range.unit, range.is_whole));
  return values;
}

PointBlock block_of(const std::vector<TomlScalar>& values, SweepAxis& axis, std::size_t index, const Place& place) {
  std::vector<SweptValue> taken;
  take_unit(values, axis, taken);
  need_numbers_of_group(axis, place);
  PointBlock block{.axes = {index}};
  for (const SweptValue& value : taken) block.rows.push_back({value});
  return block;
}

PointBlock sobol_block(const std::vector<SweptRange>& ranges, int count) {
  const Eigen::MatrixXd shares = sobol_points(count, static_cast<int>(ranges.size()), 0);
  PointBlock block;
  for (const SweptRange& range : ranges) block.axes.push_back(range.axis);
  for (int row = 0; row < count; ++row) {
    std::vector<SweptValue>& values = block.rows.emplace_back();
    for (std::size_t k = 0; k < ranges.size(); ++k) {
      const TomlScalar given = scalar_of(between(ranges[k], shares(row, static_cast<int>(k))), ranges[k].unit, false);
      values.push_back({given, measure_of(given)->number});
    }
  }
  return block;
}

PointBlock rows_of(const CsvTable& table) {
  PointBlock block;
  block.rows.resize(table.rows.size());
  for (const CsvRow& row : table.rows) block.places.push_back({table.file, row.line, ""});
  return block;
}

void read_column(const CsvTable& table, int column, SweepAxis& axis, PointBlock& block) {
  const CsvColumn& header = table.columns[static_cast<std::size_t>(column)];
  if (!header.unit.empty() && !is_angle(header.unit) && !is_unit_word(header.unit))
    throw BadInput(axis.place, in_quotes(header.unit), "a unit that percal knows");
  std::vector<TomlScalar> given;
  for (const CsvRow& row : table.rows)
    given.push_back(scalar_of_cell(table.cell(row, column), header, table.dialect.decimal_comma,
                                   {table.file, row.line, header.header}));
  std::vector<SweptValue> taken;
  take_unit(given, axis, taken);
  need_numbers_of_group(axis, axis.place);
  for (std::size_t k = 0; k < taken.size(); ++k) block.rows[k].push_back(taken[k]);
}

std::vector<PlanPoint> all_points(const std::vector<PointBlock>& blocks, std::size_t axes, const Place& place) {
  double count = 1;
  for (const PointBlock& block : blocks) count *= static_cast<double>(block.rows.size());
  if (count > most_plan_points)
    throw BadInput(place, fmt::format("{:.6g} points", count), fmt::format("up to {} points", most_plan_points));
  std::vector<PlanPoint> points{{.values = std::vector<SweptValue>(axes)}};
  for (const PointBlock& block : blocks) {
    std::vector<PlanPoint> longer;
    for (const PlanPoint& before : points)
      for (std::size_t row = 0; row < block.rows.size(); ++row) {
        PlanPoint& point = longer.emplace_back(before);
        for (std::size_t k = 0; k < block.axes.size(); ++k) point.values[block.axes[k]] = block.rows[row][k];
        if (!block.places.empty()) point.place = block.places[row];
      }
    points = std::move(longer);
  }
  return points;
}

}  // namespace percal
