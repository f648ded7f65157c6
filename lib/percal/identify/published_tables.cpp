// The published tables that a job names, computed again.

#include <fmt/core.h>

#include <cmath>

#include "percal/identify/identification.hpp"
#include "percal/math/statistics.hpp"

namespace percal {
namespace {

void add_ridge_tables(const IdentifyJob& job, const Identification& found, std::vector<ComparedNumbers>& tables) {
  const auto* scan = std::get_if<AlphaScan>(&job.alpha);
  if (!scan) return;
  ComparedNumbers moduli{.name = scan->target_name + ", identified modulus",
                         .note = "as given; alpha was fitted to this table",
                         .rows = {}};
  ComparedNumbers mapped{.name = scan->target_name + ", modulus of the model system",
                         .note = "the printed tissue modulus carried over by pi4",
                         .rows = {}};
  for (const RidgePoint& point : found.ridge) {
    if (!point.known) continue;
    moduli.rows.push_back({.what = fmt::format("erosion strain {}", point.erosion_strain),
                           .unit = "MPa",
                           .reference = point.known->mu / MPa,
                           .ours = point.mu != 0 ? std::optional(point.mu / MPa) : std::nullopt,
                           .error = point.mu / MPa * std::hypot(point.solver_error, point.data_error)});
    if (point.known->mu_model)
      mapped.rows.push_back(
          {.what = fmt::format("{:.4g} MPa", point.known->mu / MPa),
           .unit = "kPa",
           .reference = *point.known->mu_model / kPa,
           .ours = map_modulus(point.known->mu, found.similarity.prototype, found.similarity.model) / kPa});
  }
  tables.push_back(std::move(moduli));
  if (!mapped.rows.empty()) tables.push_back(std::move(mapped));
}

void add_formulation_table(const IdentifyJob& job, const Identification& found, std::vector<ComparedNumbers>& tables) {
  ComparedNumbers table{
      .name = job.gelatin.table + ", high-rate modulus by law and rate factor", .note = "", .rows = {}};
  for (const Formulation& f : job.gelatin.formulations)
    table.rows.push_back(
        {.what = fmt::format("{} wt%", f.concentration),
         .unit = "kPa",
         .reference = over(f.mu_high_rate, kPa),
         .ours = high_rate_modulus(found.gelatin.law.at(f.concentration), job.gelatin.rate_factor) / kPa});
  tables.push_back(std::move(table));
}

void add_line(const ScaledLine& scaled, const Line& line, std::vector<ComparedNumbers>& tables) {
  ComparedNumbers table{
      .name = scaled.shots_table + ": line through the model's shots", .note = "depth against rho v a", .rows = {}};
  table.rows.push_back({.what = "slope",
                        .unit = "cm per kg/(m s)",
                        .reference = over(scaled.reference_slope, cm),
                        .ours = line.slope / cm,
                        .error = over(line.slope_error, cm),
                        .digits = 5});
  table.rows.push_back({.what = "intercept",
                        .unit = "cm",
                        .reference = over(scaled.reference_intercept, cm),
                        .ours = line.intercept / cm,
                        .error = over(line.intercept_error, cm),
                        .digits = 5});
  tables.push_back(std::move(table));
}

void add_scaled_line(const ScaledLine& scaled, const Identification& found, std::vector<ComparedNumbers>& tables) {
  const Line line = depth_trend(scaled.shots);
  add_line(scaled, line, tables);
  const double speed_ratio = *found.similarity.model.speed / *found.similarity.prototype.speed;
  ComparedNumbers table{.name = scaled.name, .note = "from the line through the model's shots", .rows = {}};
  std::vector<double> computed, measured;
  for (const PredictedShot& shot : scaled.cases) {
    System prototype;
    prototype.radius = shot.radius;
    prototype.speed = shot.speed;
    prototype.particle_density = shot.density;
    const double depth = depth_from_model(line, found.similarity.model, speed_ratio, prototype);
    if (shot.measured) {
      computed.push_back(depth);
      measured.push_back(*shot.measured);
    }
    table.rows.push_back(
        {.what = fmt::format("{}, a = {:.3g} um, {:.4g} m/s", shot.particle, shot.radius / um, shot.speed),
         .unit = "um",
         .reference = over(shot.reference, um),
         .ours = depth / um});
  }
  if (!computed.empty())
    table.rows.push_back(
        {.what = "mean error against the measured depths",
         .unit = "%",
         .reference = scaled.reference_mean_error ? std::optional(100 * *scaled.reference_mean_error) : std::nullopt,
         .ours = 100 * mean_relative_error(computed, measured)});
  tables.push_back(std::move(table));
}

void add_prediction_tables(const IdentifyJob& job, const Identification& found, std::vector<ComparedNumbers>& tables) {
  for (const PredictionResult& result : found.predictions) {
    bool has_reference = false;
    for (const PredictedShot& shot : result.set->shots) has_reference |= shot.reference.has_value();
    const std::string system =
        result.set->table.empty() ? result.set->system : result.set->table + ", " + result.set->system;
    ComparedNumbers table{.name = fmt::format("{} ({:.5g} kg/m3)", system, result.set->target_density),
                          .note = has_reference ? "beside the " + job.reference_name + "'s finite elements"
                                                : "beside the measured depths",
                          .rows = {}};
    for (std::size_t i = 0; i < result.shots.size(); ++i) {
      const PredictedShot& shot = result.set->shots[i];
      const double unit = shot.radius < 1e-4 ? um : cm;
      const auto other = has_reference ? shot.reference : shot.measured;
      const Penetration& p = result.shots[i].penetration;
      table.rows.push_back(
          {.what = fmt::format("{}, a = {:.4g} mm, {:.4g} m/s", shot.particle, shot.radius * 1e3, shot.speed),
           .unit = unit == um ? "um" : "cm",
           .reference = over(other, unit),
           .ours = over(p.depth, unit),
           .error = over(p.standard_error, unit),
           .remark = p.depth ? "" : word(p.outcome)});
    }
    tables.push_back(std::move(table));
  }
}

Line line_of(const TrendTable& trend) { return linear_trend(trend.x, trend.y); }

void add_trends(const IdentifyJob& job, std::vector<ComparedNumbers>& tables) {
  for (const TrendTable& trend : job.trends) {
    const Line line = line_of(trend);
    ComparedNumbers table{.name = trend.name + ": line", .note = trend.y_name + " against " + trend.x_name, .rows = {}};
    table.rows.push_back({.what = "slope",
                          .unit = trend.unit,
                          .reference = trend.reference_slope,
                          .ours = line.slope,
                          .error = line.slope_error,
                          .digits = 5});
    table.rows.push_back({.what = "intercept",
                          .reference = trend.reference_intercept,
                          .ours = line.intercept,
                          .error = line.intercept_error,
                          .digits = 5});
    tables.push_back(std::move(table));
  }
}

void add_equal_mass(const IdentifyJob& job, std::vector<ComparedNumbers>& tables) {
  if (!job.equal_mass) return;
  const EqualMass& equal = *job.equal_mass;
  ComparedNumbers table{
      .name = equal.table,
      .note = fmt::format("{:.4g} g at {:.4g} m/s, each from its own line", equal.mass * 1e3, equal.speed),
      .rows = {}};
  for (const auto& shape : equal.shapes) {
    double depth = 0;
    if (shape.trend.empty()) {
      const auto& shots = job.scaled_line->shots;
      const Shot& ball = shots.front();
      const double radius = equal_mass_radius(equal.mass, ball.density);
      depth = depth_trend(shots).at(impact_parameter(ball.density, equal.speed, ball.radius)) * radius / ball.radius;
    } else {
      for (const TrendTable& trend : job.trends)
        if (trend.name == shape.trend) depth = line_of(trend).at(equal.speed / trend.x_unit) * trend.y_unit;
      if (shape.mass) depth *= equal_mass_prism_scale(*shape.mass, equal.mass);
    }
    table.rows.push_back(
        {.what = shape.name, .unit = "cm", .reference = shape.reference / cm, .ours = depth / cm, .digits = 3});
  }
  tables.push_back(std::move(table));
}

}  // namespace

std::vector<ComparedNumbers> published_tables(const IdentifyJob& job, const Identification& found) {
  std::vector<ComparedNumbers> tables;
  add_ridge_tables(job, found, tables);
  add_formulation_table(job, found, tables);
  if (job.scaled_line) add_scaled_line(*job.scaled_line, found, tables);
  add_prediction_tables(job, found, tables);
  add_trends(job, tables);
  add_equal_mass(job, tables);
  return tables;
}

}  // namespace percal
