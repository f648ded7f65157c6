#include <fmt/format.h>

#include <map>
#include <set>

#include "percal/observe/page/outcome_row.hpp"
#include "percal/page/numbers.hpp"
#include "percal/sweep/page/page.hpp"
#include "percal/sweep/sweep_runs.hpp"

namespace percal {
namespace {

using page::Json;
using page::ResultColumn;

Json axis_to_json(const SweepAxis& axis) {
  return {{"key", axis.key},
          {"unit", axis.unit.empty() ? Json(nullptr) : Json(axis.unit)},
          {"changes", axis.group ? changed_key(*axis.group) : axis.key},
          {"is_group", axis.group.has_value()},
          {"is_number", axis.is_number}};
}

Json value_to_json(const SweptValue& value, const SweepAxis& axis) {
  if (axis.is_number) return value.number;
  if (const auto* text = std::get_if<std::string>(&value.given)) return *text;
  return written(value.given);
}

Json point_to_json(const SweepFindings& f, std::size_t index) {
  const SweepPoint& point = f.points[index];
  const Penetration penetration = summarise(f.runs[index], point.reduction.problem, point.reduction.scales);
  Json row = outcome_row(
      {.scene = point.scene, .reduction = point.reduction, .runs = f.runs[index], .penetration = penetration});
  Json values = Json::array();
  for (std::size_t k = 0; k < f.plan.axes.size(); ++k)
    values.push_back(value_to_json(f.plan.points[index].values[k], f.plan.axes[k]));
  row.update({{"point", index + 1}, {"values", values}, {"store_key_sha256", store_digest(point)}});
  return row;
}

// Each once, with how many points it is said of.
std::vector<std::string> warnings_of(const std::vector<SweepPoint>& points) {
  std::map<std::string, long> counts;
  for (const SweepPoint& point : points)
    for (const std::string& warning : point.reduction.warnings) ++counts[warning];
  std::vector<std::string> sentences;
  for (const auto& [warning, count] : counts)
    sentences.push_back(count == static_cast<long>(points.size())
                            ? warning
                            : fmt::format("{} ({})", warning, page::counted(count, "point")));
  return sentences;
}

bool ended_well(Outcome outcome) { return outcome == Outcome::stopped || outcome == Outcome::passed_through; }

}  // namespace

Json sweep_to_json(const SweepFindings& f) {
  Json result = page::result_head("campaign", {{"job", f.plan.file}, {"toml", f.plan.text}});
  Json axes = Json::array(), points = Json::array();
  std::map<std::string, int> outcomes;
  for (const SweepAxis& axis : f.plan.axes) axes.push_back(axis_to_json(axis));
  for (std::size_t k = 0; k < f.points.size(); ++k) {
    points.push_back(point_to_json(f, k));
    ++outcomes[points.back()[outcome_key::outcome].get<std::string>()];
  }
  result.update({{"scene", f.plan.scene_file},
                 {"scene_toml", f.plan.scene_is_inside ? Json(nullptr) : Json(f.plan.scene_text)},
                 {"list", f.plan.list_file.empty() ? Json(nullptr) : Json(f.plan.list_file)},
                 {"design", word(f.plan.design)},
                 {"axes", axes},
                 {"points", points},
                 {"outcomes", outcomes},
                 {"findings", warnings_of(f.points)},
                 {"cost", page::cost_to_json(f.cost)}});
  return result;
}

std::string sweep_to_csv(const Json& result) {
  std::vector<ResultColumn> columns{{"point", "point"}};
  std::vector<Json> rows = page::list(result, "points");
  const Json& axes = page::list(result, "axes");
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const std::string unit = page::text(axes[k], "unit"), cell = "value" + std::to_string(k);
    columns.push_back(
        {page::text(axes[k], "key") + (unit.empty() ? "" : " [" + unit + "]"), cell, ResultColumn::free_text});
    for (Json& row : rows) row[cell] = page::list(row, "values")[k];
  }
  for (ResultColumn& column : outcome_columns()) columns.push_back(std::move(column));
  columns.push_back({"store_key_sha256", "store_key_sha256"});
  return page::as_csv(columns, rows);
}

bool all_points_ended_well(const SweepFindings& f) {
  for (const auto& runs : f.runs)
    for (const Evaluation& run : runs)
      if (!ended_well(run.result.outcome)) return false;
  return true;
}

Json estimate_to_json(const CostEstimate& e) {
  return {{"runs", e.runs},
          {"stored", e.stored},
          {"element_steps", e.element_steps},
          {"cpu_s", e.cpu_seconds},
          {"wall_s", e.wall_seconds},
          {"longest_run_s", e.longest_seconds},
          {"threads", e.threads},
          {"side_by_side", e.side_by_side},
          {"bytes", e.bytes},
          {"measured", {{"runs", e.measured_runs}, {"cpu_s", e.measured_cpu_seconds}}}};
}

std::string in_words(const CostEstimate& e) {
  if (e.runs == e.stored) return fmt::format("{}, all of them in the store", page::counted(e.runs, "run"));
  const auto seconds = [](double s) { return page::shown(s, 2) + " s"; };
  std::string words = fmt::format("{}, {} of them in the store\n", page::counted(e.runs, "run"), e.stored);
  words += fmt::format("processor time: about {}; a run takes {}, the longest {}\n", seconds(e.cpu_seconds),
                       seconds(e.cpu_seconds / static_cast<double>(e.runs - e.stored)), seconds(e.longest_seconds));
  words += fmt::format("wall time:      about {}, {} side by side\n", seconds(e.wall_seconds),
                       page::counted(e.side_by_side, "run"));
  words += fmt::format("memory:         about {:.3g} MB\n", 1e-6 * e.bytes);
  return words + fmt::format("from {} on coarser meshes, which took {} and are not kept",
                             page::counted(e.measured_runs, "run"), seconds(e.measured_cpu_seconds));
}

}  // namespace percal
