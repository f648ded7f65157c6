#include <fmt/format.h>

#include "percal/powder/page/page.hpp"

namespace percal {
namespace {

using page::finite;
using page::Json;

Json point_to_json(const DesignPoint& point) {
  Json json = particle_to_json(point.middle);
  json.update({{"dose", finite(point.shares.dose)},
               {"bounced", finite(point.shares.bounced)},
               {"passed", finite(point.shares.passed)},
               {"deeper", finite(point.shares.deeper)},
               {"beyond_fitted", finite(point.shares.beyond)},
               {"allowed", point.allowed}});
  return json;
}

Json points_to_json(const std::vector<DesignPoint>& points) {
  Json all = Json::array();
  for (const DesignPoint& point : points) all.push_back(point_to_json(point));
  return all;
}

Json tolerance_to_json(const Tolerance& tolerance) {
  return {{"low", finite(tolerance.low)},
          {"high", finite(tolerance.high)},
          {"low_open", tolerance.low_open},
          {"high_open", tolerance.high_open}};
}

Json limits_to_json(const DoseLimits& limits) {
  return {{"bounced", finite(limits.bounced)},
          {"passed", finite(limits.passed)},
          {"deeper_than_m", finite(limits.deeper_than)},
          {"deeper", finite(limits.deeper)},
          {"beyond", finite(limits.beyond)},
          {"most_impact_kg_m_s", finite(limits.most_impact)}};
}

Json best_to_json(const PowderDesign& design) {
  if (!design.best) return nullptr;
  Json json = particle_to_json(design.best->middle);
  json.update({{"expected_dose", finite(design.best->shares.dose)},
               {"dose", estimate_to_json(design.dose)},
               {"bounced", estimate_to_json(design.bounced)},
               {"passed", estimate_to_json(design.passed)},
               {"deeper", estimate_to_json(design.deeper)},
               {"radius_tolerance_m", tolerance_to_json(design.radius)},
               {"speed_tolerance_m_s", tolerance_to_json(design.speed)},
               {"best_speed_interval_m_s", tolerance_to_json(design.best_speed)}});
  return json;
}

}  // namespace

Json design_to_json(const PowderJob& job, const DesignAnswer& answer) {
  const PowderDesign& design = answer.design;
  Json spreads = Json::array();
  for (const OtherSpread& one : design.spreads)
    spreads.push_back({{"of", one.of}, {"geometric_deviation", one.geometric_deviation}, {"dose", finite(one.dose)}});
  Json json = powder_head("design", job, answer);
  json.update({{"band", {{"from_m", job.band->from}, {"to_m", job.band->to}}},
               {"limits", limits_to_json(job.design->limits)},
               {"enough", job.design->enough},
               {"best", best_to_json(design)},
               {"by_density", points_to_json(design.by_density)},
               {"line", points_to_json(design.line)},
               {"spreads", spreads},
               {"map", points_to_json(design.map)}});
  return json;
}

std::string design_to_csv(const DesignAnswer& answer) {
  std::string csv = "radius_m,density_kg_m3,speed_m_s,dose,bounced,passed,deeper,beyond_fitted,allowed\n";
  for (const DesignPoint& point : answer.design.map)
    csv += fmt::format("{},{},{},{},{},{},{},{},{}\n", point.middle.radius, point.middle.density, point.middle.speed,
                       point.shares.dose, point.shares.bounced, point.shares.passed, point.shares.deeper,
                       point.shares.beyond, point.allowed ? "yes" : "no");
  return csv;
}

}  // namespace percal
