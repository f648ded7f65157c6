#include <fmt/format.h>

#include "percal/powder/page/page.hpp"

namespace percal {
namespace {

using page::finite;
using page::Json;

Json shares_to_json(const DoseShares& shares, const std::vector<DepthLayer>& layers) {
  Json in_layers = Json::array();
  for (std::size_t k = 0; k < layers.size(); ++k)
    in_layers.push_back({{"name", layers[k].name},
                         {"from_m", layers[k].from},
                         {"to_m", layers[k].to},
                         {"share", estimate_to_json(shares.layers[k])}});
  return {{"bounced", estimate_to_json(shares.bounced)}, {"layers", in_layers},
          {"deeper", estimate_to_json(shares.deeper)},   {"passed", estimate_to_json(shares.passed)},
          {"in_band", estimate_to_json(shares.in_band)}, {"beyond_known", estimate_to_json(shares.beyond_known)}};
}

Json depths_to_json(const DoseDepths& depths) {
  return {{"mean_m", estimate_to_json(depths.mean)},
          {"deviation_m", estimate_to_json(depths.deviation)},
          {"tenth_m", estimate_to_json(depths.tenth)},
          {"median_m", estimate_to_json(depths.median)},
          {"ninetieth_m", estimate_to_json(depths.ninetieth)}};
}

Json measured_to_json(const PowderJob& job, const DoseAnswer& answer) {
  if (!job.measured) return nullptr;
  return {{"measured_mean_m", job.measured->mean},
          {"measured_deviation_m", estimate_to_json(answer.verdict->measured)},
          {"particles", job.measured->particles ? Json(*job.measured->particles) : Json()},
          {"explained_by_size", answer.verdict->by_size_alone},
          {"explained_by_all", answer.verdict->by_all},
          {"note", job.measured->note}};
}

}  // namespace

Json estimate_to_json(const DoseEstimate& estimate) {
  return {{"best", finite(estimate.best)},
          {"low", finite(estimate.low)},
          {"high", finite(estimate.high)},
          {"low_open", false},
          {"high_open", false}};
}

Json particle_to_json(const PowderParticle& particle) {
  return {{"radius_m", particle.radius},
          {"density_kg_m3", particle.density},
          {"speed_m_s", particle.speed},
          {"impact_kg_m_s", impact_parameter(particle)}};
}

Json powder_to_json(const PowderJob& job) {
  const Powder& powder = job.powder;
  Json sizes = Json::array();
  for (const DistributionCell& cell : cells_of(powder.radius, 120, 3))
    sizes.push_back({{"from_m", cell.low}, {"to_m", cell.high}, {"number", cell.share}, {"mass", cell.moment}});
  double mass = 0;
  for (const Json& cell : sizes) mass += cell["mass"].get<double>();
  for (Json& cell : sizes) cell["mass"] = cell["mass"].get<double>() / mass;
  return {{"middle", particle_to_json(middle_particle(powder))},
          {"radius_log_deviation", log_deviation_of(powder.radius)},
          {"density_log_deviation", log_deviation_of(powder.density)},
          {"speed_log_deviation", log_deviation_of(powder.speed)},
          {"speed_by_size", powder.by_size.has_value()},
          {"sizes_by_mass", job.sizes_by_mass},
          {"sizes", sizes}};
}

Json beyond_to_json(const std::vector<BeyondFitted>& beyond) {
  Json all = Json::array();
  for (const BeyondFitted& one : beyond)
    all.push_back({{"of", one.number}, {"by_number", one.by_number}, {"by_mass", one.by_mass}});
  return all;
}

Json dose_to_json(const PowderJob& job, const DoseAnswer& answer) {
  const Dose& dose = answer.dose;
  Json curve = Json::array(), spread = Json::array();
  for (const DosePoint& point : dose.curve)
    curve.push_back({{"depth_m", point.depth},
                     {"mass_above", estimate_to_json(point.mass)},
                     {"number_above", estimate_to_json(point.number)}});
  for (const SpreadSource& source : answer.spread)
    spread.push_back({{"source", source.name},
                      {"spread_m", estimate_to_json(source.deviation)},
                      {"spread_mean_m", estimate_to_json(source.mean)}});
  Json json = powder_head("dose", job, answer);
  json.update({{"scatter", answer.scatter},
               {"band", job.band ? Json{{"from_m", job.band->from}, {"to_m", job.band->to}} : Json()},
               {"by_mass", shares_to_json(dose.mass_shares, job.layers)},
               {"by_number", shares_to_json(dose.number_shares, job.layers)},
               {"depths_by_mass", depths_to_json(dose.mass_depths)},
               {"depths_by_number", depths_to_json(dose.number_depths)},
               {"curve", curve},
               {"spread", spread},
               {"measured", measured_to_json(job, answer)},
               {"integration_error", finite(dose.integration_error)}});
  return json;
}

std::string dose_to_csv(const DoseAnswer& answer) {
  std::string csv =
      "depth_m,mass_above,mass_above_low,mass_above_high,number_above,number_above_low,number_above_high\n";
  for (const DosePoint& point : answer.dose.curve)
    csv += fmt::format("{},{},{},{},{},{},{}\n", point.depth, point.mass.best, point.mass.low, point.mass.high,
                       point.number.best, point.number.low, point.number.high);
  return csv;
}

}  // namespace percal
