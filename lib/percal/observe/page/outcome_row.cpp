#include "percal/observe/page/outcome_row.hpp"

#include <fmt/ranges.h>

#include <string>
#include <utility>

#include "percal/observe/field_measures.hpp"

namespace percal {
namespace {

using page::finite;
using page::Json;
using page::ResultColumn;

// The error's sources with their columns: half widths of 95 %.
constexpr std::pair<DepthErrorSource, const char*> error_columns[] = {
    {DepthErrorSource::mesh_phase, "error_mesh_phase_m"},
    {DepthErrorSource::mesh_size, "error_mesh_size_m"},
    {DepthErrorSource::wall, "error_wall_m"},
    {DepthErrorSource::time_step, "error_time_step_m"},
    {DepthErrorSource::bulk, "error_bulk_m"}};

void add_error(Json& row, const ImpactFindings& f) {
  const bool has_depth = f.penetration.depth.has_value();
  const DepthError error = has_depth ? depth_error(f.scene, f.reduction, f.penetration, f.evidence) : DepthError{};
  row[outcome_key::depth_error] = has_depth ? finite(error.half_width()) : Json(nullptr);
  for (const auto& [source, column] : error_columns)
    row[column] = has_depth ? finite(error.of(source).half_width) : Json(nullptr);
}

// Behind the target, or with which it leaves the way it came.
std::optional<double> speed_left(const FieldMeasures& measures) {
  if (measures.exit_speed.mean || !measures.final) return measures.exit_speed.mean;
  return measures.final->speed.mean;
}

void add_end(Json& row, const ImpactFindings& f) {
  const FieldMeasures measures = field_measures(f.runs, f.reduction.problem, f.reduction.scales);
  row["ending"] = measures.final ? Json(word(measures.final->ending)) : Json(nullptr);
  row["final_depth_m"] = measures.final ? finite(measures.final->depth.mean) : Json(nullptr);
  row[outcome_key::speed_left] = finite(speed_left(measures));
  auto sentences = warnings(f.penetration, f.runs);
  for (std::string& sentence : warnings(measures, f.runs)) sentences.push_back(std::move(sentence));
  row[outcome_key::notes] = fmt::format("{}", fmt::join(sentences, "; "));
}

}  // namespace

Json outcome_row(const ImpactFindings& f) {
  double cpu_seconds = 0;
  long reused = 0;
  for (const Evaluation& run : f.runs) {
    cpu_seconds += run.cpu_seconds;
    reused += run.reused;
  }
  Json row{{outcome_key::outcome, word(f.penetration.outcome)},
           {"runs", f.runs.size()},
           {outcome_key::depth, finite(f.penetration.depth)},
           {"depth_spread_m", finite(f.penetration.spread)},
           {outcome_key::at_least, finite(f.penetration.at_least)},
           {outcome_key::cpu_seconds, cpu_seconds},
           {"reused", reused}};
  add_error(row, f);
  add_end(row, f);
  return row;
}

std::vector<ResultColumn> outcome_columns() {
  std::vector<ResultColumn> columns;
  for (const char* key : {outcome_key::outcome, "runs", outcome_key::depth, "depth_spread_m", outcome_key::depth_error})
    columns.push_back({key, key});
  for (const auto& [source, column] : error_columns) columns.push_back({column, column});
  for (const char* key :
       {outcome_key::at_least, "ending", "final_depth_m", outcome_key::speed_left, outcome_key::cpu_seconds, "reused"})
    columns.push_back({key, key});
  columns.push_back({outcome_key::notes, outcome_key::notes, ResultColumn::free_text});
  return columns;
}

}  // namespace percal
