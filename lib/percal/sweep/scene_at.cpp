#include "percal/sweep/scene_at.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "percal/impact/target/size.hpp"
#include "percal/scene/document_kind.hpp"
#include "percal/scene/scene_toml.hpp"
#include "percal/text/toml_edits.hpp"

namespace percal {
namespace {

Scene read_with(const Plan& plan, std::vector<TomlEdit> edits) {
  if (plan.scene_is_inside)
    for (TomlEdit& edit : edits) edit.path = "scene." + edit.path;
  const TomlTable root = parse_toml_with(plan.scene_text, plan.scene_file, edits);
  if (!plan.scene_is_inside) need_kind(root, DocumentKind::scene);
  const TomlTable table = plan.scene_is_inside ? root.table("scene") : root;
  Scene scene = scene_from(table);
  table.finish();
  scene.output.history = scene.output.channel = false;  // the table of points has neither
  return scene;
}

struct WantedGroup {
  GroupChange change;
  double value;
};

// In the order in which they are to be changed.
std::vector<WantedGroup> wanted_groups(const Plan& plan, const PlanPoint& point) {
  std::vector<WantedGroup> wanted;
  for (std::size_t k = 0; k < plan.axes.size(); ++k)
    if (plan.axes[k].group) wanted.push_back({*plan.axes[k].group, point.values[k].number});
  std::ranges::stable_sort(wanted, [](const auto& a, const auto& b) { return goes_before(a.change, b.change); });
  return wanted;
}

void check_groups(const std::vector<WantedGroup>& wanted, const Scene& scene) {
  constexpr double rounding = 1e-9;
  for (const auto& [change, asked] : wanted) {
    const auto found = value_in(change, scene);
    if (!found || !(std::abs(*found - asked) <= rounding * std::abs(asked)))
      throw BadInput(Place{scene.source, 0, group(change.group).symbol},
                     fmt::format("{} for {} that the plan asks for", found.value_or(NAN), asked),
                     "sweeps that leave the group what it is to be");
  }
}

Scene made_scene(const Plan& plan, const PlanPoint& point) {
  std::vector<TomlEdit> edits;
  if (plan.replicates) edits.push_back({"replicates", std::int64_t{*plan.replicates}});
  for (std::size_t k = 0; k < plan.axes.size(); ++k)
    if (!plan.axes[k].group) edits.push_back({plan.axes[k].key, point.values[k].given});
  Scene scene = read_with(plan, edits);
  const auto wanted = wanted_groups(plan, point);
  for (const auto& [change, value] : wanted) {
    edits.push_back(edit_for(change, value, scene));
    scene = read_with(plan, edits);
  }
  check_groups(wanted, scene);
  return scene;
}

// The axis that a message is about.
const SweepAxis& axis_of(const Plan& plan, const std::string& message) {
  const auto is_named = [&](const SweepAxis& axis) {
    return message.find((axis.group ? changed_key(*axis.group) : axis.key) + ":") != std::string::npos;
  };
  const auto found = std::ranges::find_if(plan.axes, is_named);
  return found == plan.axes.end() ? plan.axes.front() : *found;
}

// The reader's words, behind the place in the plan and the point.
[[noreturn]] void refuse(const Plan& plan, std::size_t index, const BadInput& error) {
  const PlanPoint& point = plan.points[index];
  const SweepAxis& axis = axis_of(plan, error.what());
  const Place& place = point.place.line > 0 ? point.place : axis.place;
  throw BadInput(fmt::format("{}:{}: {}: point {} of {} ({}): {}", place.file, place.line, axis.key, index + 1,
                             plan.points.size(), in_words(plan, point), error.what()));
}

template <class Make>
auto of_point(const Plan& plan, std::size_t index, const Make& make) {
  try {
    return make();
  } catch (const BadInput& error) {
    refuse(plan, index, error);
  }
}

}  // namespace

std::string in_words(const Plan& plan, const PlanPoint& point) {
  std::string words;
  for (std::size_t k = 0; k < plan.axes.size(); ++k) {
    const auto* text = std::get_if<std::string>(&point.values[k].given);
    words += (k == 0 ? "" : ", ") + plan.axes[k].key + " = " + (text ? *text : written(point.values[k].given));
  }
  return words;
}

Scene scene_at(const Plan& plan, std::size_t point) {
  return of_point(plan, point, [&] { return made_scene(plan, plan.points[point]); });
}

std::vector<SweepPoint> points_to_run(const Plan& plan) {
  std::vector<SweepPoint> points;
  for (std::size_t k = 0; k < plan.points.size(); ++k)
    points.push_back(of_point(plan, k, [&] {
      Scene scene = made_scene(plan, plan.points[k]);
      Reduction reduction = reduce(scene);
      refuse_what_is_too_large(reduction.problem, plan.scene_file);
      return SweepPoint{std::move(scene), std::move(reduction)};
    }));
  return points;
}

}  // namespace percal
