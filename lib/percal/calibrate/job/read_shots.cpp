// Shots: [[shots]], rows of a table or points written into the job.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "percal/calibrate/job/read_job.hpp"
#include "percal/calibrate/job/trajectory.hpp"
#include "percal/invert/reach.hpp"
#include "percal/scene/sphere_toml.hpp"
#include "percal/text/job_table.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

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

// A record's own stays where none is given.
void take_depth_error(const TomlTable& block, MeasuredShot& shot) {
  const double given = depth_error_from(block, shot.depth);
  if (block.has("depth_error")) shot.depth_error = given;
}

void read_depth_errors(const TomlTable& block, const CsvTable& table, std::vector<MeasuredShot>& shots) {
  if (block.has("depth_error_column")) {
    for (const char* key : {"depth_error", "depth_error_where"})
      if (block.has(key)) block.refuse(key, "this beside depth_error_column", "one of the two");
    const auto errors = some_of_column(block, "depth_error_column", table, dimension::length, not_negative("length"));
    for (std::size_t i = 0; i < shots.size(); ++i) shots[i].depth_error = errors[i].value_or(shots[i].depth_error);
    return;
  }
  if (block.has("depth_error_where") && !block.has("depth_error"))
    block.refuse("depth_error", "no such key beside depth_error_where", "the error of these rows");
  const auto meets = rows_meeting(block, "depth_error_where", table);
  for (std::size_t i = 0; i < shots.size(); ++i)
    if (meets[i] && shots[i].depth > 0) take_depth_error(block, shots[i]);
}

void read_use(const TomlTable& block, const CsvTable& table, std::vector<MeasuredShot>& shots) {
  const bool fitted = block.word("use", use_words, 0) == 0;
  if (!fitted && block.has("fit_where")) block.refuse("fit_where", "this beside use = \"predict\"", "one of the two");
  const auto chosen = rows_meeting(block, "fit_where", table);
  for (std::size_t i = 0; i < shots.size(); ++i) shots[i].used = fitted && chosen[i];
}

const std::pair<std::string, ShotDatum> bounds[] = {{"at_least", ShotDatum::at_least}, {"at_most", ShotDatum::at_most}};

// Bounds in place of depths, and the rows of which they are true.
void read_bounds(const TomlTable& block, const CsvTable& table, std::vector<MeasuredShot>& shots) {
  for (const auto& [key, datum] : bounds) {
    const bool all = block.flag(key, false);
    const std::string where = key + "_where";
    if (all && block.has(where)) block.refuse(where, "this beside " + key + " = true", "one of the two");
    block.knows(where);
    const auto meets = rows_meeting(block, where, table);
    for (std::size_t i = 0; i < shots.size(); ++i) {
      if (!all && !(block.has(where) && meets[i])) continue;
      if (shots[i].datum != ShotDatum::depth)
        block.refuse(
            all ? key : where,
            fmt::format("the shot in line {}, of which {}", table.rows[i].line,
                        shots[i].datum == ShotDatum::none ? "nothing was measured" : "no depth alone is known"),
            "a shot with a depth, and one bound at most");
      shots[i].datum = datum;
    }
  }
}

std::string column_of_number(RunNumber number) { return std::string(kind_of(number).key) + "_column"; }

const std::string outcome_forms = "\"passed\" (perforated, complete) or \"stopped\" (caught, partial)";

std::optional<ShotDatum> outcome_of(const std::string& text) {
  const std::string word = lower_case(text);
  for (const char* passed : {"passed", "perforated", "complete"})
    if (word == passed) return ShotDatum::passed;
  for (const char* stopped : {"stopped", "caught", "partial"})
    if (word == stopped) return ShotDatum::stopped;
  return std::nullopt;
}

// What was seen of one shot: numbers before words. `refuse` is for what contradicts itself.
struct SeenOfShot {
  std::optional<double> depth;
  std::map<RunNumber, double> beside = {};
  std::optional<double> speed_left;
  std::optional<ShotDatum> outcome;
  std::optional<RecordedShot> record;
};

// The record in place of numbers.
template <class Refuse>
void take_record(MeasuredShot& shot, SeenOfShot& seen, const Refuse& refuse) {
  if (seen.depth || !seen.beside.empty() || seen.speed_left || seen.outcome == ShotDatum::passed)
    refuse("a number, or \"passed\", beside a trajectory", "one of the two");
  shot.depth_error = seen.record->standard_error;
  if (seen.record->end == RecordedShot::End::half_speed)
    seen.beside[RunNumber::half_speed_depth] = seen.record->depth;
  else
    seen.depth = seen.record->depth;
  if (seen.record->end == RecordedShot::End::still_faster) shot.datum = ShotDatum::at_least;
}

template <class Refuse>
void check_numbers_beside(const SeenOfShot& seen, bool passed, const Refuse& refuse) {
  for (const auto& [number, value] : seen.beside) {
    const std::string words = std::string("a ") + kind_of(number).words;
    if (passed) refuse(words + " of a shot that passed", words + ", or a speed left, or \"passed\"");
    if (!kind_of(number).over_depth && (seen.depth || seen.beside.size() > 1))
      refuse(words + " beside a depth", "a block of its own, for its scatter is another");
    if (seen.depth && kind_of(number).over_depth && value > *seen.depth)
      refuse(words + " of " + format_quantity(value, dimension::length),
             "no more than the deepest depth, " + format_quantity(*seen.depth, dimension::length));
  }
}

template <class Refuse>
void take(MeasuredShot& shot, SeenOfShot seen, const Refuse& refuse) {
  if (seen.record) take_record(shot, seen, refuse);
  const bool left = seen.speed_left.value_or(0) > 0;
  const bool stopped = seen.outcome == ShotDatum::stopped || (seen.speed_left && !left);
  const bool passed = left || seen.outcome == ShotDatum::passed;
  if (left && stopped) refuse("a speed left of a shot that was stopped", "one of the two");
  if (seen.depth && passed) refuse("a depth of a shot that passed", "a depth, or a speed left, or \"passed\"");
  check_numbers_beside(seen, passed, refuse);
  if (left && *seen.speed_left >= shot.speed)
    refuse("a speed left of " + format_quantity(*seen.speed_left, dimension::speed),
           "less than the speed at impact, " + format_quantity(shot.speed, dimension::speed));
  if (seen.depth) {
    shot.depth = *seen.depth;
  } else if (!seen.beside.empty()) {
    std::tie(shot.number, shot.depth) = *seen.beside.begin();
  } else if (left) {
    shot.datum = ShotDatum::speed_left;
    shot.speed_left = *seen.speed_left;
  } else if (stopped) {
    shot.datum = ShotDatum::stopped;
  } else {
    shot.datum = seen.outcome.value_or(ShotDatum::none);
    if (shot.datum == ShotDatum::none && shot.used)
      refuse("a fitted shot of which nothing was seen",
             "a depth, a final depth, another number, a trajectory, an outcome or a speed left; or use = \"predict\"");
  }
}

void read_seen(const TomlTable& block, const CsvTable& table, std::vector<MeasuredShot>& shots) {
  const auto depths = some_of_column(block, "depth_column", table, dimension::length, length);
  std::map<RunNumber, std::vector<std::optional<double>>> beside;
  for (const RunNumber number : numbers_beside)
    beside[number] = some_of_column(block, column_of_number(number), table, dimension::length, length);
  const auto speeds_left = some_of_column(block, "speed_left_column", table, dimension::speed, not_negative("speed"));
  const int outcome = block.has("outcome_column") ? column_index(block, "outcome_column", table) : -1;
  block.knows("outcome_column");
  for (std::size_t i = 0; i < shots.size(); ++i) {
    SeenOfShot seen{.depth = depths[i], .speed_left = speeds_left[i], .outcome = {}, .record = {}};
    for (const auto& [number, values] : beside)
      if (values[i]) seen.beside[number] = *values[i];
    const std::string word = outcome < 0 ? "" : table.cell(table.rows[i], outcome);
    if (!word.empty()) {
      seen.outcome = outcome_of(word);
      if (!seen.outcome)
        throw BadInput({table.file, table.rows[i].line, table.columns[outcome].header}, in_quotes(word), outcome_forms);
    }
    take(shots[i], seen, [&](const std::string& found, const std::string& accepted) {
      throw BadInput({table.file, table.rows[i].line, ""}, found, accepted);
    });
  }
}

Sphere measures_of(const ShotBody& body) { return {body.scene.particle.radius, body.scene.particle.density}; }

std::vector<MeasuredShot> shots_of_table(const TomlTable& block, const std::shared_ptr<const ShotBody>& body) {
  const CsvTable table = table_of(block);
  const auto spheres = body ? std::vector(table.rows.size(), measures_of(*body)) : spheres_of_rows(block, table);
  const auto speeds = values_of_rows(block, "speed", table, dimension::speed, speed);
  if (block.has("particle") && block.has("particle_column"))
    block.refuse("particle_column", "this beside particle", "one of the two");
  std::vector<std::string> particles(table.rows.size(), body ? "" : block.text("particle", "sphere"));
  if (block.has("particle_column"))
    for (std::size_t i = 0; i < particles.size(); ++i)
      particles[i] = table.cell(table.rows[i], column_index(block, "particle_column", table));
  std::vector<MeasuredShot> shots(table.rows.size());
  for (std::size_t i = 0; i < shots.size(); ++i) {
    MeasuredShot& shot = shots[i];
    shot.radius = spheres[i].radius;
    shot.density = spheres[i].density;
    shot.speed = speeds[i];
    shot.file = table.file;
    shot.body = body;
    shot.label = (body ? "" : particles[i] + " ") + words_of(shot);
    const auto cells = table.cells(table.rows[i]);
    for (std::size_t c = 0; c < table.columns.size(); ++c) shot.row[table.columns[c].header] = cells[c];
  }
  read_use(block, table, shots);
  read_seen(block, table, shots);
  read_depth_errors(block, table, shots);
  read_bounds(block, table, shots);
  return shots;
}

// The first of a point's numbers, for messages.
std::string key_of_what_was_seen(const TomlTable& point) {
  if (point.has("speed_left")) return "speed_left";
  for (const RunNumber number : numbers_beside)
    if (point.has(kind_of(number).key)) return kind_of(number).key;
  return point.has("trajectory") ? "trajectory" : "depth";
}

MeasuredShot shot_of_point(const TomlTable& point, const std::shared_ptr<const ShotBody>& body) {
  MeasuredShot shot;
  shot.body = body;
  const Sphere sphere = body ? measures_of(*body) : sphere_from(point, "particle_");
  shot.radius = sphere.radius;
  shot.density = sphere.density;
  shot.speed = point.quantity("speed", dimension::speed, speed);
  shot.used = point.word("use", use_words, 0) == 0;
  point.knows("outcome");
  SeenOfShot seen;
  seen.depth = point.optional_quantity("depth", dimension::length, length);
  for (const RunNumber number : numbers_beside)
    if (const auto value = point.optional_quantity(kind_of(number).key, dimension::length, length))
      seen.beside[number] = *value;
  if (const auto path = record_path(point)) seen.record = recorded_shot(*path, point, shot.speed);
  seen.speed_left = point.optional_quantity("speed_left", dimension::speed, not_negative("speed"));
  if (point.has("outcome")) {
    seen.outcome = outcome_of(point.text("outcome"));
    if (!seen.outcome) point.refuse("outcome", in_quotes(point.text("outcome")), outcome_forms);
  }
  take(shot, seen, [&](const std::string& found, const std::string& accepted) {
    point.refuse(key_of_what_was_seen(point), found, accepted);
  });
  take_depth_error(point, shot);
  for (const auto& [key, datum] : bounds) {
    if (!point.flag(key, false)) continue;
    if (shot.datum != ShotDatum::depth)
      point.refuse(key, "this without a depth of its own", "a depth, and one bound at most");
    shot.datum = datum;
  }
  shot.label = point.text("label", (body ? "" : "sphere ") + words_of(shot));
  shot.row["label"] = shot.label;
  return shot;
}

std::vector<MeasuredShot> shots_of_points(const TomlTable& block, const std::shared_ptr<const ShotBody>& body) {
  std::vector<MeasuredShot> shots;
  for (const TomlTable& point : block.tables("points")) shots.push_back(shot_of_point(point, body));
  return shots;
}

// In radii of each sphere, or one length for all.
std::optional<double> layer_size(const TomlTable& block, const std::string& key, const SphereShot& shot) {
  const double radius = shot.radius;
  const std::string in_radii = key + "_radii";
  const Range above_one{.low = 1, .high = 1e6, .low_open = true, .words = "more than one radius"};
  if (block.has(key) && block.has(in_radii)) block.refuse(in_radii, "this beside " + key, "one of the two");
  if (block.has(in_radii)) return block.number(in_radii, above_one) * radius;
  const auto size = block.optional_quantity(key, dimension::length, length);
  if (size && *size <= radius)
    block.refuse(key, format_quantity(*size, dimension::length),
                 (shot.body ? "more than half the width of the body, " : "more than the sphere's radius, ") +
                     format_quantity(radius, dimension::length));
  return size;
}

// What a layer turns an outcome or a speed left into.
void settle_passage(const TomlTable& block, MeasuredShot& shot) {
  const double error = block.quantity("speed_left_error", dimension::speed, not_negative("speed"), 0);
  if (shot.datum == ShotDatum::speed_left) {
    const double left = shot.speed_left / shot.speed;
    shot.depth = reach_of_passage(shot.layer_depth, left);
    shot.depth_error = shot.depth * reach_slope(left) * error / shot.speed;
  } else if (shot.depth == 0) {
    shot.depth = shot.layer_depth;
  }
}

void read_layer(const TomlTable& block, MeasuredShot& shot) {
  const auto depth = layer_size(block, "layer_depth", shot);
  if (!depth) {
    block.knows("layer_depth_radii");
    block.refuse("layer_depth", "no such key", "the layer's size, or layer_depth_radii in radii of the sphere");
  }
  shot.layer_depth = *depth;
  shot.layer_width = layer_size(block, "layer_width", shot).value_or(0);  // settle_width
  settle_passage(block, shot);
  if (shot.datum != ShotDatum::speed_left && shot.depth > shot.layer_depth)
    block.refuse(block.has("layer_depth_radii") ? "layer_depth_radii" : "layer_depth",
                 fmt::format("{}, but the shot {} went {} deep", format_quantity(shot.layer_depth, dimension::length),
                             in_quotes(shot.label), format_quantity(shot.depth, dimension::length)),
                 "a layer as deep as its shots, or deeper");
}

// Something must be left below the covers.
void check_covers(const TomlTable& block, const CalibrationTarget& target, const MeasuredShot& shot) {
  double thickness = 0;
  for (const TargetCover& cover : target.covers) thickness += cover.thickness;
  if (thickness > 0 && shot.layer_depth <= thickness + shot.radius)
    block.refuse(block.has("layer_depth_radii") ? "layer_depth_radii" : "layer_depth",
                 format_quantity(shot.layer_depth, dimension::length),
                 fmt::format("more than a radius below the covers of {}, which are {} thick", in_quotes(target.name),
                             format_quantity(thickness, dimension::length)));
}

// The emulator has the layer's depth among its inputs, not its width.
void check_width(const TomlTable& block, const CalibrationJob& job, const MeasuredShot& shot) {
  const auto first = std::ranges::find_if(job.shots, [&](const MeasuredShot& other) {
    return other.layer_width > 0 && place_of_body(other) == place_of_body(shot);
  });
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

std::vector<MeasuredShot> shots_from(const TomlTable& block, CalibrationJob& job) {
  if (block.has("file") && block.has("points")) block.refuse("points", "this beside file", "one of the two");
  if (!block.has("file") && !block.has("points"))
    block.refuse("file", "neither file nor points", "file = \"TABLE.csv\", or [[shots.points]]");
  const auto body = body_of_block(block, job);
  return block.has("file") ? shots_of_table(block, body) : shots_of_points(block, body);
}

}  // namespace

void read_shots(const TomlTable& root, CalibrationJob& job) {
  for (const TomlTable& block : root.tables("shots")) {
    auto shots = shots_from(block, job);
    const bool of_channels =
        std::ranges::all_of(shots, [](const MeasuredShot& shot) { return shot.number == RunNumber::channel_radius; });
    const int target = target_index(block, job), set = set_index(block, job),
              group = group_index(block, of_channels ? "channel radii" : "shots", job);
    const bool several = job.targets.size() > 1;
    const double speed_error = block.quantity("speed_error", dimension::speed, not_negative("speed"), 0);
    for (MeasuredShot& shot : shots) {
      shot.target = target;
      shot.set = set;
      shot.group = group;
      shot.speed_error = speed_error;
      if (several && block.has("file")) shot.label += " into " + job.targets[target].name;
      if (shot.body) check_body(block, job, shot);
      read_layer(block, shot);
      check_covers(block, job.targets[target], shot);
      check_width(block, job, shot);
      job.shots.push_back(std::move(shot));
    }
  }
}

}  // namespace percal
