// Data: [[shots]], rows of a table or points written into the job, [[curves]], and the groups they scatter in, [scatter.NAME].
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "percal/calibrate/job/read_job.hpp"
#include "percal/fit/read_curves.hpp"
#include "percal/scene/sphere_toml.hpp"
#include "percal/text/job_table.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

// Of the block's material.
int material_index(const TomlTable& block, const CalibrationJob& job) {
  const std::string name = block.text("material");
  for (std::size_t m = 0; m < job.materials.size(); ++m)
    if (job.materials[m].name == name) return static_cast<int>(m);
  block.refuse("material", in_quotes(name), "a material of the job: " + names_of(job.materials));
}

// Of the block's scatter group: `fallback` where it names none, made where nobody has declared it.
int group_index(const TomlTable& block, const std::string& fallback, CalibrationJob& job) {
  const std::string name = block.text("scatter", fallback);
  for (std::size_t g = 0; g < job.groups.size(); ++g)
    if (job.groups[g].name == name) return static_cast<int>(g);
  if (block.has("scatter") && name != fallback)
    block.refuse("scatter", in_quotes(name), "a group of [scatter.NAME]: " + names_of(job.groups));
  job.groups.push_back({.name = fallback, .estimated = true, .fixed = 0});
  return static_cast<int>(job.groups.size()) - 1;
}

const Range length = positive("length"), speed = positive("speed");
const std::vector<std::string> use_words{"fit", "predict"};

// The conditions of a key, row by row; all rows where the block has none.
std::vector<bool> rows_meeting(const TomlTable& block, const std::string& key, const CsvTable& table) {
  std::vector<bool> meets(table.rows.size(), true);
  if (!block.has(key)) return meets;
  const CsvTable kept = table.where(block.texts(key));
  for (std::size_t i = 0; i < table.rows.size(); ++i)
    meets[i] = std::any_of(kept.rows.begin(), kept.rows.end(),
                           [&](const CsvRow& row) { return row.line == table.rows[i].line; });
  return meets;
}

// The standard deviation of a depth: a length, or a share of it.
double depth_error_from(const TomlTable& block, double depth) {
  block.describe("depth_error", {"length or share", "a length, or a share of the depth, not below zero", "0"});
  if (!block.has("depth_error")) return 0;
  const bool is_share = !block.is_text("depth_error") || block.text("depth_error").find('%') != std::string::npos;
  if (is_share)
    return depth *
           *optional_share_from(block, "depth_error", not_negative("share of the depth, as \"5 %\", or a length,"));
  return block.quantity("depth_error", dimension::length, not_negative("length"));
}

void read_depth_errors(const TomlTable& block, const CsvTable& table, std::vector<MeasuredShot>& shots) {
  if (block.has("depth_error_column")) {
    for (const char* key : {"depth_error", "depth_error_where"})
      if (block.has(key)) block.refuse(key, "this beside depth_error_column", "one of the two");
    const auto errors = column_of(block, "depth_error_column", table, dimension::length, not_negative("length"));
    for (std::size_t i = 0; i < shots.size(); ++i) shots[i].depth_error = errors[i];
    return;
  }
  if (block.has("depth_error_where") && !block.has("depth_error"))
    block.refuse("depth_error", "no such key beside depth_error_where", "the error of these rows");
  const auto meets = rows_meeting(block, "depth_error_where", table);
  for (std::size_t i = 0; i < shots.size(); ++i)
    if (meets[i]) shots[i].depth_error = depth_error_from(block, shots[i].depth);
}

void read_use(const TomlTable& block, const CsvTable& table, std::vector<MeasuredShot>& shots) {
  const bool fitted = block.word("use", use_words, 0) == 0;
  if (!fitted && block.has("fit_where")) block.refuse("fit_where", "this beside use = \"predict\"", "one of the two");
  const auto chosen = rows_meeting(block, "fit_where", table);
  for (std::size_t i = 0; i < shots.size(); ++i) shots[i].used = fitted && chosen[i];
}

void read_at_least(const TomlTable& block, const CsvTable& table, std::vector<MeasuredShot>& shots) {
  const bool all = block.flag("at_least", false);
  if (all && block.has("at_least_where"))
    block.refuse("at_least_where", "this beside at_least = true", "one of the two");
  const auto meets = rows_meeting(block, "at_least_where", table);
  for (std::size_t i = 0; i < shots.size(); ++i) shots[i].at_least = all || (block.has("at_least_where") && meets[i]);
}

std::vector<MeasuredShot> shots_of_table(const TomlTable& block) {
  const CsvTable table = table_of(block);
  const auto spheres = spheres_of_rows(block, table);
  const auto speeds = values_of_rows(block, "speed", table, dimension::speed, speed);
  const auto depths = column_of(block, "depth_column", table, dimension::length, length);
  if (block.has("particle") && block.has("particle_column"))
    block.refuse("particle_column", "this beside particle", "one of the two");
  std::vector<std::string> particles(table.rows.size(), block.text("particle", "sphere"));
  if (block.has("particle_column"))
    for (std::size_t i = 0; i < particles.size(); ++i)
      particles[i] = table.cell(table.rows[i], column_index(block, "particle_column", table));
  std::vector<MeasuredShot> shots(table.rows.size());
  for (std::size_t i = 0; i < shots.size(); ++i) {
    MeasuredShot& shot = shots[i];
    shot.radius = spheres[i].radius;
    shot.density = spheres[i].density;
    shot.speed = speeds[i];
    shot.depth = depths[i];
    shot.file = table.file;
    shot.label = particles[i] + " " + words_of(shot);
    const auto cells = table.cells(table.rows[i]);
    for (std::size_t c = 0; c < table.columns.size(); ++c) shot.row[table.columns[c].header] = cells[c];
  }
  read_depth_errors(block, table, shots);
  read_use(block, table, shots);
  read_at_least(block, table, shots);
  return shots;
}

MeasuredShot shot_of_point(const TomlTable& point) {
  MeasuredShot shot;
  const Sphere sphere = sphere_from(point, "particle_");
  shot.radius = sphere.radius;
  shot.density = sphere.density;
  shot.speed = point.quantity("speed", dimension::speed, speed);
  shot.depth = point.quantity("depth", dimension::length, length);
  shot.depth_error = depth_error_from(point, shot.depth);
  shot.at_least = point.flag("at_least", false);
  shot.used = point.word("use", use_words, 0) == 0;
  shot.label = point.text("label", "sphere " + words_of(shot));
  shot.row["label"] = shot.label;
  return shot;
}

std::vector<MeasuredShot> shots_of_points(const TomlTable& block) {
  std::vector<MeasuredShot> shots;
  for (const TomlTable& point : block.tables("points")) shots.push_back(shot_of_point(point));
  return shots;
}

// In radii of each sphere, or one length for all.
std::optional<double> layer_size(const TomlTable& block, const std::string& key, double radius) {
  const std::string in_radii = key + "_radii";
  const Range above_one{.low = 1, .high = 1e6, .low_open = true, .words = "more than one radius"};
  if (block.has(key) && block.has(in_radii)) block.refuse(in_radii, "this beside " + key, "one of the two");
  if (block.has(in_radii)) return block.number(in_radii, above_one) * radius;
  const auto size = block.optional_quantity(key, dimension::length, length);
  if (size && *size <= radius)
    block.refuse(key, format_quantity(*size, dimension::length),
                 "more than the sphere's radius, " + format_quantity(radius, dimension::length));
  return size;
}

void read_layer(const TomlTable& block, MeasuredShot& shot) {
  const auto depth = layer_size(block, "layer_depth", shot.radius);
  if (!depth) {
    block.knows("layer_depth_radii");
    block.refuse("layer_depth", "no such key", "the layer's size, or layer_depth_radii in radii of the sphere");
  }
  shot.layer_depth = *depth;
  shot.layer_width = layer_size(block, "layer_width", shot.radius).value_or(0);  // settle_width
  if (shot.depth > shot.layer_depth)
    block.refuse(block.has("layer_depth_radii") ? "layer_depth_radii" : "layer_depth",
                 fmt::format("{}, but the shot {} went {} deep", format_quantity(shot.layer_depth, dimension::length),
                             in_quotes(shot.label), format_quantity(shot.depth, dimension::length)),
                 "a layer as deep as its shots, or deeper");
}

// The emulator has the layer's depth among its inputs, not its width.
void check_width(const TomlTable& block, const CalibrationJob& job, const MeasuredShot& shot) {
  const auto first = std::ranges::find_if(job.shots, [](const MeasuredShot& other) { return other.layer_width > 0; });
  if (shot.layer_width == 0 || first == job.shots.end()) return;
  const double width = shot.layer_width / shot.radius, expected = first->layer_width / first->radius;
  constexpr double rounding = 1e-9;
  if (std::abs(width / expected - 1) > rounding)
    block.refuse(block.has("layer_width") ? "layer_width" : "layer_width_radii", fmt::format("{:.6g} radii", width),
                 fmt::format("one width in radii for all shots of a job, here {:.6g}: layer_width_radii", expected));
}

// Blocks of one name are one set.
int set_index(const TomlTable& block, CalibrationJob& job) {
  const std::string name = block.text("name");
  const bool leave_one_out = block.flag("leave_one_out", false);
  for (std::size_t s = 0; s < job.sets.size(); ++s) {
    if (job.sets[s].name != name) continue;
    if (job.sets[s].leave_one_out != leave_one_out)
      block.refuse("leave_one_out", leave_one_out ? "true" : "false",
                   "what the first block of the set " + in_quotes(name) + " says");
    return static_cast<int>(s);
  }
  job.sets.push_back({name, leave_one_out});
  return static_cast<int>(job.sets.size()) - 1;
}

std::vector<MeasuredShot> shots_from(const TomlTable& block) {
  if (block.has("file") && block.has("points")) block.refuse("points", "this beside file", "one of the two");
  if (!block.has("file") && !block.has("points"))
    block.refuse("file", "neither file nor points", "file = \"TABLE.csv\", or [[shots.points]]");
  return block.has("file") ? shots_of_table(block) : shots_of_points(block);
}

// The command's own messages speak of its options; here the keys are checked first.
CurveColumns columns_from(const TomlTable& block, const CsvTable& table) {
  CurveColumns columns;
  for (const auto& [key, column] : {std::pair{"x", &columns.x}, std::pair{"y", &columns.y}})
    if (block.has(key)) *column = table.columns[column_index(block, key, table)].header;
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
  MeasuredCurve curve{.name = block.text("name"),
                      .material = material_index(block, job),
                      .data = curves_of(table, columns_from(block, table)),
                      .relative_error = share_from(block, "error", not_negative("share"), 0),
                      .rate_factor = block.number("rate_factor", positive("factor"), 1),
                      .rate_factor_error = share_from(block, "rate_factor_error", not_negative("share"), 0),
                      .group = group_index(block, "curves", job),
                      .synthetic = block.flag("synthetic", false)};
  if (std::all_of(curve.data.points.begin(), curve.data.points.end(),
                  [](const StressPoint& point) { return point.nominal_stress == 0; }))
    block.refuse("file", "no stress other than 0 in " + table.file, "a curve with stresses");
  return curve;
}

}  // namespace

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

void read_shots(const TomlTable& root, CalibrationJob& job) {
  for (const TomlTable& block : root.tables("shots")) {
    auto shots = shots_from(block);
    const int material = material_index(block, job), set = set_index(block, job),
              group = group_index(block, "shots", job);
    const bool several = job.materials.size() > 1;
    const double speed_error = block.quantity("speed_error", dimension::speed, not_negative("speed"), 0);
    for (MeasuredShot& shot : shots) {
      shot.material = material;
      shot.set = set;
      shot.group = group;
      shot.speed_error = speed_error;
      if (several && block.has("file")) shot.label += " into " + job.materials[material].name;
      read_layer(block, shot);
      check_width(block, job, shot);
      job.shots.push_back(std::move(shot));
    }
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
