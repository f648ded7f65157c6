#include "percal/observe/history.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <numbers>

#include "percal/page/result.hpp"

namespace percal {
namespace {

struct Column {
  std::string key;
  double HistoryPoint::*value;
  double unit;  // in SI
};

// Forces are in units of rho_t v^2 a^2, per radian or on the part of a block that is computed; in plane strain
// of rho_t v^2 a, those on one half where the other mirrors it.
Column force_column(const Problem& problem, const Scales& scales) {
  const double density = scales.target_density, v = scales.speed, a = scales.radius;
  if (problem.geometry == Geometry::plane_strain)
    return {"force_N_per_m", &HistoryPoint::force, (problem.whole ? 1 : 2) * density * v * v * a};
  const double parts = problem.geometry != Geometry::block ? 2 * std::numbers::pi : 1 / computed_share(problem);
  return {"force_N", &HistoryPoint::force, parts * density * v * v * a * a};
}

std::vector<Column> columns_of(const Problem& problem, const Scales& scales) {
  return {{"time_s", &HistoryPoint::time, scales.radius / scales.speed},
          {"tip_m", &HistoryPoint::tip, scales.radius},
          {"speed_m_s", &HistoryPoint::speed, scales.speed},
          force_column(problem, scales)};
}

}  // namespace

std::string history_csv(const std::vector<HistoryPoint>& history, const Problem& problem, const Scales& scales) {
  const auto columns = columns_of(problem, scales);
  std::string csv;
  for (const Column& column : columns) csv += column.key + ",";
  for (const EnergyTerm& term : energy_terms) csv += fmt::format("energy_{},", term.key);
  csv += "energy_sum\n";
  for (const HistoryPoint& point : history) {
    for (const Column& column : columns) csv += fmt::format("{:.9g},", point.*column.value * column.unit);
    for (const EnergyTerm& term : energy_terms) csv += fmt::format("{:.9g},", point.energy.*term.share);
    csv += fmt::format("{:.9g}\n", point.energy.sum());
  }
  return csv;
}

nlohmann::json history_to_json(const std::vector<HistoryPoint>& history, const Problem& problem, const Scales& scales) {
  const auto list = [&](const auto& value) {
    page::Json numbers = page::Json::array();
    for (const HistoryPoint& point : history) numbers.push_back(page::finite(value(point)));
    return numbers;
  };
  page::Json json = page::Json::object();
  for (const Column& column : columns_of(problem, scales))
    json[column.key] = list([&](const HistoryPoint& point) { return point.*column.value * column.unit; });
  for (const EnergyTerm& term : energy_terms)
    json["energy"][term.key] = list([&](const HistoryPoint& point) { return point.energy.*term.share; });
  json["energy"]["sum"] = list([](const HistoryPoint& point) { return point.energy.sum(); });
  return json;
}

}  // namespace percal
