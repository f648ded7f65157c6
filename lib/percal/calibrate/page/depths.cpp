// Depths of a calibration's shots: measured against the model's, and both against the impact parameter rho_p v a.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "percal/calibrate/page/parts.hpp"
#include "percal/page/numbers.hpp"

namespace percal::page {
namespace {

constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();

// The shot of the data that an entry of a hypothesis belongs to.
const Json& datum_of(const Json& result, const Json& entry) {
  static const Json nothing = nullptr;
  const Json& shots = list(at(result, "data"), "shots");
  const double index = number_or(entry, "shot", -1);
  return index >= 0 && index < static_cast<double>(shots.size()) ? shots[static_cast<std::size_t>(index)] : nothing;
}

// What was measured: the depth, or the least depth.
double measured_depth(const Json& shot) {
  return number(shot, "measured_m").value_or(number_or(shot, "measured_at_least_m", nowhere));
}

double impact_parameter(const Json& datum) {
  return number_or(datum, "density_kg_m3", nowhere) * number_or(datum, "speed_m_s", nowhere) *
         number_or(datum, "radius_m", nowhere);
}

std::vector<std::string> each_once(const Json& shots, const char* key) {
  std::vector<std::string> all;
  for (const Json& shot : shots)
    if (const std::string word = text(shot, key); std::find(all.begin(), all.end(), word) == all.end())
      all.push_back(word);
  return all;
}

// Every shot, measured and as each hypothesis has it.
Table shot_table(const Json& result) {
  const Json& hypotheses = list(result, "hypotheses");
  Table table{.caption = "Shots: model over measured, less 1", .rows = {{"shot", "measured"}}, .notes = {}};
  for (std::size_t n = 1; n <= hypotheses.size(); ++n) table.rows[0].push_back(fmt::format("hypothesis {}", n));
  const Json& shots = list(at(result, "data"), "shots");
  for (std::size_t i = 0; i < shots.size(); ++i) {
    const auto measured = number(shots[i], "measured_m");
    std::vector<std::string> row{text(shots[i], "label"),
                                 (measured ? "" : "at least ") + length(measured_depth(shots[i]))};
    for (const Json& hypothesis : hypotheses) {
      std::string cell = "-";
      for (const Json& entry : list(hypothesis, "shots"))
        if (number(entry, "shot") == static_cast<double>(i))
          cell = (measured ? signed_percent(number(entry, "deviation")) : length(number(entry, "depth_m"))) +
                 (yes(entry, "fitted") ? "" : ", predicted");
      row.push_back(cell);
    }
    table.rows.push_back(row);
  }
  table.notes.push_back("Of shots whose depth is only known to be at least something: the model's depth.");
  return table;
}

}  // namespace

Figure depths_figure(const Json& result, const Json& hypothesis, int number_of_hypothesis) {
  Chart chart{.title = "Depths: the model's against the measured",
              .x = {.label = "measured, radii", .logarithmic = true},
              .y = {.label = "model, radii; interval of one shot", .logarithmic = true}};
  int colour = 0, fitted_shots = 0, within = 0;
  double low = HUGE_VAL, high = 0, sum = 0;
  for (const std::string& set : each_once(list(at(result, "data"), "shots"), "set")) {
    Series fitted = series(set + ", fitted", Mark::points_with_bars, colour),
           predicted = series(set + ", predicted", Mark::points_with_bars, colour + 1);
    for (const Json& entry : list(hypothesis, "shots")) {
      const Json& datum = datum_of(result, entry);
      if (text(datum, "set") != set) continue;
      const double radius = number_or(datum, "radius_m", nowhere), measured = measured_depth(entry) / radius;
      const double depth = number_or(entry, "depth_m", nowhere) / radius,
                   least = number_or(entry, "low_m", nowhere) / radius,
                   most = number_or(entry, "high_m", nowhere) / radius;
      add_bar(yes(entry, "fitted") ? fitted : predicted, measured, depth, least, most);
      for (const double value : {measured, depth})
        if (std::isfinite(value)) {
          low = std::min(low, value);
          high = std::max(high, value);
        }
      if (!yes(entry, "fitted") || !number(entry, "deviation")) continue;
      ++fitted_shots;
      sum += std::abs(*number(entry, "deviation"));
      within += least <= measured && measured <= most;
    }
    colour += predicted.x.empty() ? 1 : 2;
    add(chart, std::move(fitted));
    add(chart, std::move(predicted));
  }
  if (!drawable(chart)) return {};
  Series same = series("", Mark::dashes, -1);
  for (const double end : {low, high}) add_point(same, end, end);
  add(chart, std::move(same));
  std::string finding;
  if (fitted_shots > 0)
    finding = fmt::format("The fitted depths deviate by {} in the mean; {} of {} lie in the interval of one shot.",
                          percent(sum / fitted_shots), within, fitted_shots);
  return {
      .name = fmt::format("depths_{}", number_of_hypothesis),
      .caption = finding + " Dashed: the same depth.",
      .alt = fmt::format("Model's depths against measured ones, from {:.3g} to {:.3g} radii, about the diagonal. {}",
                         low, high, finding),
      .chart = chart};
}

Section impact_parameter_section(const Json& result) {
  Section section{.id = "depths", .title = "Depth against the impact parameter", .blocks = {}};
  const Json& shots = list(at(result, "data"), "shots");
  int n = 0;
  for (const std::string& material : each_once(shots, "material")) {
    double deepest = 0;
    std::set<double> places;
    for (const Json& shot : shots)
      if (text(shot, "material") == material) {
        deepest = std::max(deepest, measured_depth(shot));
        places.insert(impact_parameter(shot));
      }
    if (places.size() < 2) continue;
    const ShownUnit unit = length_unit(deepest);
    Chart chart{.title = "Depth in " + material,
                .x = {.label = "rho_p v a, kg/(m s)"},
                .y = {.label = "depth, " + unit.name, .low = 0}};
    int colour = 1;
    std::string finding;
    for (const Json& hypothesis : list(result, "hypotheses")) {
      Series model = series(text(hypothesis, "name"), colour == 1 ? Mark::points_with_bars : Mark::points, colour);
      ++colour;
      double sum = 0;
      int count = 0;
      for (const Json& entry : list(hypothesis, "shots")) {
        const Json& datum = datum_of(result, entry);
        if (text(datum, "material") != material) continue;
        const double x = impact_parameter(datum), depth = number_or(entry, "depth_m", nowhere) / unit.size;
        if (model.mark == Mark::points_with_bars)
          add_bar(model, x, depth, number_or(entry, "low_m", nowhere) / unit.size,
                  number_or(entry, "high_m", nowhere) / unit.size);
        else
          add_point(model, x, depth);
        if (const auto deviation = number(entry, "deviation")) {
          sum += std::abs(*deviation);
          ++count;
        }
      }
      if (count > 0)
        finding += fmt::format(" {}: {} from the measured depths in the mean.", model.name, percent(sum / count));
      add(chart, std::move(model));
    }
    Series measured = series("measured", Mark::points, 0), least = series("went at least so deep", Mark::points, -1);
    for (const Json& shot : shots)
      if (text(shot, "material") == material)
        add_point(number(shot, "measured_m") ? measured : least, impact_parameter(shot),
                  measured_depth(shot) / unit.size);
    add(chart, std::move(measured));
    add(chart, std::move(least));
    add(section,
        Figure{.name = fmt::format("impact_parameter_{}", ++n),
               .caption =
                   fmt::format("Shots into {}, against density times speed times radius of the sphere.{} Bars: where "
                               "one such shot would lie.",
                               material, finding),
               .alt = fmt::format("Depth against the impact parameter for {} different shots into {}, rising.{}",
                                  places.size(), material, finding),
               .chart = chart});
  }
  add(section, shot_table(result));
  return section;
}

}  // namespace percal::page
