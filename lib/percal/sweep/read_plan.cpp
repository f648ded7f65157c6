#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "percal/scene/document_kind.hpp"
#include "percal/sweep/plan_points.hpp"
#include "percal/text/file.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

constexpr std::array root_keys{"geometry", "replicates"};  // of a scene, that have no dot
const std::vector<std::string>& design_words() {
  static const std::vector<std::string> words{"grid", "sobol"};
  return words;
}

void read_base_scene(const TomlTable& root, Plan& plan) {
  root.describe("scene", {"file or table", "the name of a scene's file, or a table", ""});
  plan.scene_is_inside = root.is_table("scene");
  if (plan.scene_is_inside) {
    root.knows("scene");
    plan.scene_file = plan.file;
    plan.scene_text = plan.text;
    return;
  }
  plan.scene_file = root.path("scene");
  plan.scene_text = read_file(plan.scene_file);
}

// Of a key or group that the plan names, at its place.
SweepAxis axis_named(const std::string& key, const Place& place, const std::optional<std::string>& changed,
                     const Place& place_of_changed) {
  SweepAxis axis{.key = key, .group = group_named(key), .place = place};
  if (axis.group) {
    axis.key = group(axis.group->group).symbol;
    if (!changed) return axis;
    axis.group = changing(*axis.group, *changed);
    if (!axis.group)
      throw BadInput(place_of_changed, in_quotes(*changed),
                     "of " + axis.key + ": " + listed(changes_of(*group_named(key))));
    return axis;
  }
  if (changed) throw BadInput(place_of_changed, "this beside a key of the scene", "nothing, or a group as key");
  if (key.find('.') != std::string::npos || std::ranges::find(root_keys, key) != root_keys.end()) return axis;
  std::vector<std::string> known(root_keys.begin(), root_keys.end());
  for (const Group& one : groups()) known.insert(known.end(), {one.symbol, one.name});
  const auto meant = nearest_word(key, known);
  throw BadInput(
      place, in_quotes(key) + (meant && group_named(*meant) ? " (did you mean " + *meant + "?)" : ""),
      "a key of the scene such as particle.speed (percal keys scene), or a group: " + listed(groups_in_words()));
}

// What a plan changes is changed by one axis.
void add_axis(Plan& plan, const SweepAxis& axis) {
  const auto changed = [](const SweepAxis& one) { return one.group ? changed_key(*one.group) : one.key; };
  if (axis.key == "replicates" && plan.replicates)
    throw BadInput(axis.place, "replicates, which the plan has", "replicates of the plan, or a sweep of them");
  for (const SweepAxis& other : plan.axes)
    if (changed(other) == changed(axis))
      throw BadInput(axis.place, fmt::format("{}, which changes {} as {} does", axis.key, changed(axis), other.key),
                     "sweeps that change different things");
  plan.axes.push_back(axis);
}

SweptRange range_of(const TomlTable& block, const SweepAxis& axis) {
  block.describe("from", {"quantity", "a number, with its unit in quotes where it has one", ""});
  block.describe("to", {"quantity", "as from", ""});
  SweptRange range{.from = block.scalar("from"), .to = block.scalar("to")};
  range.is_logarithmic = block.word("spacing", {"linear", "log"}, 0) == 1;
  check_range(range, axis, block);
  return range;
}

// Ranges of a Sobol design are kept for the end, all others are a block of their own.
void read_sweep(const TomlTable& block, Plan& plan, std::vector<PointBlock>& blocks, std::vector<SweptRange>& ranges) {
  SweepAxis axis = axis_named(block.text("key"), block.place("key"), block.optional_text("by"), block.place("by"));
  const std::size_t index = plan.axes.size();
  block.knows("values");
  if (block.has("values")) {
    for (const char* other : {"from", "to", "count", "spacing"})
      if (block.has(other)) block.refuse(other, "this beside values", "values, or from, to and count");
    blocks.push_back(block_of(block.scalars("values"), axis, index, block.place("values")));
    add_axis(plan, axis);
    return;
  }
  if (!block.has("from") && !block.has("to"))
    block.refuse("values", "no such key", "values = [...], or from, to and count");
  SweptRange range = range_of(block, axis);
  range.axis = index;
  axis.unit = range.unit;
  if (plan.design == Design::sobol) {
    if (block.has("count")) block.refuse("count", "this in a Sobol design", "count of the plan, for all ranges");
    ranges.push_back(range);
  } else {
    blocks.push_back(
        block_of(spaced_values(range, block.integer("count", 2, most_plan_points)), axis, index, block.place("from")));
  }
  block.knows("count");
  add_axis(plan, axis);
}

std::vector<PointBlock> read_list(Plan& plan) {
  const CsvTable table = read_csv(plan.list_file);
  PointBlock block = rows_of(table);
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    const Place place{table.file, table.header_line, table.columns[column].header};
    SweepAxis axis = axis_named(table.columns[column].name, place, {}, place);
    read_column(table, static_cast<int>(column), axis, block);
    block.axes.push_back(plan.axes.size());
    add_axis(plan, axis);
  }
  return {block};
}

Plan plan_from(const TomlTable& root, const std::string& text, const std::string& file) {
  Plan plan{.file = file, .text = text};
  read_base_scene(root, plan);
  plan.replicates = root.optional_integer("replicates", 1, 1000);
  plan.design = static_cast<Design>(root.word("design", design_words(), 0));
  plan.list_file = root.optional_path("list").value_or("");
  const auto count = root.optional_integer("count", 1, most_plan_points);
  if (count && plan.design != Design::sobol) root.refuse("count", "this in a grid", "count of each [[sweep]]");
  std::vector<PointBlock> blocks;
  std::vector<SweptRange> ranges;
  if (!plan.list_file.empty()) blocks = read_list(plan);
  for (const TomlTable& block : root.tables("sweep")) read_sweep(block, plan, blocks, ranges);
  root.finish();
  if (plan.axes.empty()) root.refuse("sweep", "no such table", "one [[sweep]] or more, or list = \"FILE.csv\"");
  if (plan.design == Design::sobol) {
    if (ranges.empty()) root.refuse("design", "\"sobol\" without a range", "a [[sweep]] with from and to");
    if (ranges.size() > most_sobol_ranges)
      root.refuse("design", fmt::format("\"sobol\" over {} ranges", ranges.size()),
                  fmt::format("up to {}", most_sobol_ranges));
    if (!count)
      throw BadInput({file, root.place("design").line, "count"}, "no such key",
                     "the number of points of a Sobol design");
    blocks.push_back(sobol_block(ranges, *count));
  }
  plan.points = all_points(blocks, plan.axes.size(), root.place("sweep"));
  return plan;
}

}  // namespace

std::string word(Design design) { return design_words().at(static_cast<std::size_t>(design)); }

Plan read_plan(const std::string& path) {
  const std::string text = read_file(path);
  const TomlTable root = parse_toml(text, path);
  need_kind(root, DocumentKind::campaign);
  return plan_from(root, text, path);
}

}  // namespace percal
