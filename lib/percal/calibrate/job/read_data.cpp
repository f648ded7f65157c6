// Data: [[curves]], and the groups that data scatter in, [scatter.NAME].
#include <fmt/format.h>

#include <algorithm>

#include "percal/calibrate/job/read_job.hpp"
#include "percal/fit/read/read_curves.hpp"
#include "percal/text/job_table.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

Specimen specimen_from(const TomlTable& block) {
  const auto size = [&](const char* key, const Dimension& dimension) {
    return block.optional_quantity(key, dimension, positive(name_of(dimension)));
  };
  return specimen_of({.gauge_length = size("gauge_length", dimension::length),
                      .area = size("area", dimension::area),
                      .width = size("width", dimension::length),
                      .thickness = size("thickness", dimension::length),
                      .specimen_diameter = size("specimen_diameter", dimension::length)},
                     [&](const std::string& key, const std::string& found, const std::string& accepted) {
                       block.refuse(key, found, accepted);
                     });
}

RowChoice rows_from(const TomlTable& block) {
  RowChoice rows;
  if (const auto text = block.optional_text("branch")) {
    const auto branch = branch_choice_of(*text);
    if (!branch) block.refuse("branch", in_quotes(*text), branch_words);
    rows.branch = *branch;
  }
  for (const auto& [key, only] : {std::pair{"until", "peak"}, {"without", "holds"}}) {
    const auto text = block.optional_text(key);
    block.describe(key, {.kind = "word", .accepted = accepted_words({only}), .fallback = ""});
    if (!text) continue;
    if (*text != only) block.refuse(key, in_quotes(*text), in_quotes(only));
    if (*text == "peak") rows.until = CurveEnd::peak;
    if (*text == "holds") rows.holds = Holds::left_out;
  }
  return rows;
}

// When the rows of a curve of a material that relaxes were measured: a column, or ramps at the curve's rate.
TimesWanted times_from(const TomlTable& block, RowChoice& rows) {
  for (const char* key : {"branch", "until", "without"})
    if (block.has(key)) block.refuse(key, "this of a curve whose material relaxes", "whole histories of stress");
  rows.holds = Holds::timed;
  return {.column = block.text("time", ""), .rate = block.optional_quantity("rate", dimension::rate, positive("rate"))};
}

// The command's own messages speak of its options; here the keys are checked first.
CurveColumns columns_from(const TomlTable& block, const CsvTable& table, const CalibrationMaterial& material) {
  CurveColumns columns;
  for (const auto& [key, column] : {std::pair{"x", &columns.x}, std::pair{"y", &columns.y}})
    if (block.has(key)) *column = table.columns[column_index(block, key, table)].header;
  columns.specimen = specimen_from(block);
  columns.rows = rows_from(block);
  block.describe("time", {.kind = "text", .accepted = "a column", .fallback = ""});
  if (material.relaxation.empty() && block.has("time"))
    block.refuse("time", "this of a material that does not relax", "[[materials.NAME.relaxation]], or no time");
  block.knows("time");
  if (!material.relaxation.empty()) columns.times = times_from(block, columns.rows);
  columns.mode = block.text("mode", "");
  const bool mode_column = table.find("mode").has_value();
  if (block.has("mode") && mode_column)
    block.refuse("mode", "mode beside a column \"mode\" of " + table.file,
                 "one of them; where = [\"mode=...\"] to choose rows");
  if (!mode_column && !deformation_of(columns.mode))
    block.refuse("mode",
                 block.has("mode") ? in_quotes(columns.mode) : "no such key, and no column \"mode\" in " + table.file,
                 deformation_words());
  return columns;
}

MeasuredCurve curve_from(const TomlTable& block, CalibrationJob& job) {
  const CsvTable table = table_of(block);
  const int material = material_index(block, job);
  MeasuredCurve curve{.name = block.text("name"),
                      .material = material,
                      .data = curves_of(table, columns_from(block, table, job.materials[material])),
                      .relative_error = share_from(block, "error", not_negative("share"), 0),
                      .rate_factor = block.number("rate_factor", positive("factor"), 1),
                      .rate_factor_error = share_from(block, "rate_factor_error", not_negative("share"), 0),
                      .rate = block.optional_quantity("rate", dimension::rate, positive("rate")),
                      .group = group_index(block, "curves", job),
                      .synthetic = block.flag("synthetic", false)};
  const MaterialNumber& law = job.materials[curve.material].rate_exponent;
  if (!curve.rate && (std::holds_alternative<SharedParameter>(law) || std::get<double>(law) != 0))
    block.refuse("rate", "no such key", "the curve's strain rate, for its material has a rate_exponent");
  if (std::all_of(curve.data.points.begin(), curve.data.points.end(),
                  [](const StressPoint& point) { return point.nominal_stress == 0; }))
    block.refuse("file", "no stress other than 0 in " + table.file, "a curve with stresses");
  return curve;
}

}  // namespace

int material_index(const TomlTable& block, const CalibrationJob& job) {
  const std::string name = block.text("material");
  for (std::size_t m = 0; m < job.materials.size(); ++m)
    if (job.materials[m].name == name) return static_cast<int>(m);
  block.refuse("material", in_quotes(name), "a material of the job: " + names_of(job.materials));
}

int group_index(const TomlTable& block, const std::string& fallback, CalibrationJob& job) {
  const std::string name = block.text("scatter", fallback);
  for (std::size_t g = 0; g < job.groups.size(); ++g)
    if (job.groups[g].name == name) return static_cast<int>(g);
  if (block.has("scatter") && name != fallback)
    block.refuse("scatter", in_quotes(name), "a group of [scatter.NAME]: " + names_of(job.groups));
  job.groups.push_back({.name = fallback, .estimated = true, .fixed = 0});
  return static_cast<int>(job.groups.size()) - 1;
}

void read_scatter_groups(const TomlTable& root, CalibrationJob& job) {
  const auto blocks = root.optional_table("scatter");
  if (!blocks) return;
  for (const std::string& name : blocks->keys()) {
    const TomlTable block = blocks->table(name);
    ScatterGroup group{.name = name, .estimated = block.flag("estimated", !block.has("fixed")), .fixed = 0};
    const auto fixed = optional_share_from(block, "fixed", not_negative("share"));
    if (group.estimated == fixed.has_value())
      block.refuse("fixed", fixed ? "fixed beside estimated = true" : "no such key beside estimated = false",
                   "estimated = true, or fixed = SHARE");
    group.fixed = fixed.value_or(0);
    job.groups.push_back(group);
  }
}

void read_job_curves(const TomlTable& root, CalibrationJob& job) {
  for (const TomlTable& block : root.tables("curves")) {
    MeasuredCurve curve = curve_from(block, job);
    for (const MeasuredCurve& other : job.curves)
      if (other.name == curve.name) block.refuse("name", in_quotes(curve.name) + " again", "a name of its own");
    job.curves.push_back(std::move(curve));
  }
}

}  // namespace percal
