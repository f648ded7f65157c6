// Shots: their depths as they were measured and as the hypotheses have them, against each other and against the impact parameter
// rho_p v a.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "percal/calibrate/page/sections.hpp"
#include "percal/invert/reach.hpp"
#include "percal/page/numbers.hpp"

namespace percal::calibration_page {
namespace {

// What was seen, and its number: the keys that are not of it are null.
Json measured_to_json(const MeasuredShot& shot) {
  const auto of = [&](ShotDatum datum, double value) { return shot.datum == datum ? Json(value) : Json(); };
  return {{"seen", seen_words(shot)},
          {"number", kind_of(shot.number).key},
          {"measured_m", of(ShotDatum::depth, shot.depth)},
          {"measured_at_least_m", of(ShotDatum::at_least, shot.depth)},
          {"measured_at_most_m", of(ShotDatum::at_most, shot.depth)},
          {"speed_left_m_s", of(ShotDatum::speed_left, shot.speed_left)}};
}

}  // namespace

Json measured_shots_to_json(const CalibrationJob& job) {
  Json all = Json::array();
  for (const MeasuredShot& shot : job.shots) {
    all.push_back({{"label", shot.label},
                   {"set", job.sets[shot.set].name},
                   {"material", job.materials[job.targets[shot.target].material].name},
                   {"target", job.targets[shot.target].name},
                   {"scatter", job.groups[shot.group].name},
                   {"radius_m", shot.radius},
                   {"density_kg_m3", shot.density},
                   {"speed_m_s", shot.speed},
                   {"speed_error_m_s", shot.speed_error},
                   {"layer_depth_m", shot.layer_depth},
                   {"layer_width_m", shot.layer_width},
                   {"depth_error_m", shot.depth_error},
                   {"used", shot.used}});
    if (shot.body) all.back()["body"] = shot.body->name();
    all.back().update(measured_to_json(shot));
  }
  return all;
}

Json shots_to_json(const CalibrationJob& job, const std::vector<ShotDepth>& depths) {
  Json all = Json::array();
  for (const ShotDepth& depth : depths) {
    const MeasuredShot& shot = job.shots[depth.shot];
    all.push_back({{"shot", depth.shot},
                   {"label", shot.label},
                   {"depth_m", finite(depth.depth)},
                   {"low_m", finite(depth.low)},
                   {"high_m", finite(depth.high)},
                   {"model_error", finite(depth.model_error)},
                   {"fitted", depth.fitted},
                   {"passes_probability", finite(depth.passes)},
                   {"deviation", finite(depth.deviation)}});
    if (depth.deepest) all.back()["deepest_m"] = *depth.deepest;
    all.back().update(measured_to_json(shot));
  }
  return all;
}

// --- the page -------------------------------------------------------------------------------------------------------

const Json& datum_of(const Json& result, const Json& entry) {
  static const Json nothing = nullptr;
  const Json& shots = list(at(result, "data"), "shots");
  const double index = number_or(entry, "shot", -1);
  return index >= 0 && index < static_cast<double>(shots.size()) ? shots[static_cast<std::size_t>(index)] : nothing;
}

bool is_along_depth(const Json& shot) {
  const auto number = run_number_of(text(shot, "number"));
  return !number || kind_of(*number).over_depth;
}

double measured_depth(const Json& shot) {
  return number(shot, "measured_m").value_or(number_or(shot, "measured_at_least_m", nowhere));
}

std::vector<std::string> each_once(const Json& shots, const char* key) {
  std::vector<std::string> all;
  for (const Json& shot : shots)
    if (const std::string word = text(shot, key); std::find(all.begin(), all.end(), word) == all.end())
      all.push_back(word);
  return all;
}

namespace {

double impact_parameter(const Json& datum) {
  return number_or(datum, "density_kg_m3", nowhere) * number_or(datum, "speed_m_s", nowhere) *
         number_or(datum, "radius_m", nowhere);
}

bool is_of_passage(const Json& entry) {
  const std::string seen = text(entry, "seen");
  return seen == "passed" || seen == "stopped" || seen == "speed left";
}

std::string measured_words(const Json& shot) {
  const std::string seen = text(shot, "seen");
  if (seen == "depth") return length(number(shot, "measured_m"));
  for (const char* key : {"measured_m", "measured_at_least_m", "measured_at_most_m"})
    if (const auto measured = number(shot, key)) return seen + " " + length(measured);
  if (seen == "speed left") return quantity(number(shot, "speed_left_m_s"), dimension::speed) + " left";
  return seen == "none" ? "" : seen;
}

// Of a shot that tells of passing: what its reach means in its layer.
std::string reach_words(const Json& result, const Json& entry, const char* key) {
  const Json& datum = datum_of(result, entry);
  const double layer = number_or(datum, "layer_depth_m", nowhere);
  const auto reach = number(entry, key);
  if (!is_of_passage(entry) || !reach || *reach <= layer) return length(reach);
  return quantity(std::optional(share_left(layer, *reach) * number_or(datum, "speed_m_s", nowhere)), dimension::speed) +
         " left";
}

std::string interval_of_shot(const Json& result, const Json& entry) {
  if (is_of_passage(entry) && text(entry, "seen") != "speed left")
    return "passes with " + percent(number_or(entry, "passes_probability", nowhere));
  return reach_words(result, entry, "low_m") + " to " + reach_words(result, entry, "high_m");
}

// A shot's entry of a hypothesis, or of the closed form; null where there is none.
const Json& entry_of(const Json& with_shots, std::size_t shot) {
  static const Json nothing = nullptr;
  for (const Json& entry : list(with_shots, "shots"))
    if (number(entry, "shot") == static_cast<double>(shot)) return entry;
  return nothing;
}

// Every shot as each hypothesis has it, and as the closed form does.
Table deviation_table(const Json& result) {
  Table table{.caption = "Shots: model over measured, less 1", .rows = {{"shot"}}, .notes = {}};
  std::vector<const Json*> columns;
  for (const Json& hypothesis : list(result, "hypotheses")) {
    columns.push_back(&hypothesis);
    table.rows[0].push_back(fmt::format("hypothesis {}", columns.size()));
  }
  if (const Json& dehn = at(result, "dehn"); dehn.is_object()) {
    columns.push_back(&dehn);
    table.rows[0].push_back("Dehn's");
  }
  const Json& shots = list(at(result, "data"), "shots");
  for (std::size_t i = 0; i < shots.size(); ++i) {
    std::vector<std::string> row{text(shots[i], "label")};
    for (const Json* column : columns) {
      const Json& entry = entry_of(*column, i);
      row.push_back(number(entry, "deviation") ? signed_percent(number(entry, "deviation"))
                                               : reach_words(result, entry, "depth_m"));
      if (at(entry, "fitted") == Json(false)) row.back() += ", predicted";
    }
    table.rows.push_back(row);
  }
  table.notes.push_back("Of shots without a measured number: the model's depth, or the speed left behind the layer.");
  if (std::ranges::any_of(shots, [](const Json& shot) { return text(shot, "seen") == "speed left"; }))
    table.notes.push_back(
        "Of a speed left: the deviation of the reach L/(1 - (v_left/v)^2), the depth at which all energy would be "
        "gone.");
  return table;
}

Table depth_table(const Json& result, const Json& hypothesis) {
  Table table{
      .caption = "Depths", .rows = {{"shot", "measured", "model", level_words(result) + " of one shot"}}, .notes = {}};
  for (const Json& entry : list(hypothesis, "shots"))
    table.rows.push_back({text(entry, "label"), measured_words(entry), reach_words(result, entry, "depth_m"),
                          interval_of_shot(result, entry)});
  return table;
}

Figure depths_figure(const Json& result, const Json& hypothesis, int number_of_hypothesis) {
  Chart chart{.title = "Depths: the model's against the measured",
              .x = {.label = "measured, radii", .logarithmic = true},
              .y = {.label = "model, radii; interval of one shot", .logarithmic = true}};
  int colour = 0;
  double low = HUGE_VAL, high = 0;
  for (const std::string& set : each_once(list(at(result, "data"), "shots"), "set")) {
    Series fitted = series(set + ", fitted", Mark::points_with_bars, colour),
           predicted = series(set + ", predicted", Mark::points_with_bars, colour + 1);
    for (const Json& entry : list(hypothesis, "shots")) {
      const Json& datum = datum_of(result, entry);
      if (text(datum, "set") != set || !is_along_depth(datum)) continue;
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
  if (const FittedDepths fitted = fitted_depths(hypothesis); fitted.count > 0)
    finding = fmt::format("The fitted depths deviate by {} in the mean; {} of {} lie in the interval of one shot.",
                          percent(fitted.deviation), fitted.within, fitted.count);
  return {
      .name = fmt::format("depths_{}", number_of_hypothesis),
      .caption = finding + " Dashed: the same depth.",
      .alt = fmt::format("Model's depths against measured ones, from {:.3g} to {:.3g} radii, about the diagonal. {}",
                         low, high, finding),
      .chart = chart};
}

}  // namespace

FittedDepths fitted_depths(const Json& hypothesis) {
  FittedDepths fitted;
  for (const Json& entry : list(hypothesis, "shots")) {
    const auto deviation = number(entry, "deviation");
    if (!yes(entry, "fitted") || !deviation) continue;
    const double measured = measured_depth(entry);
    ++fitted.count;
    fitted.deviation += std::abs(*deviation);
    fitted.within += number_or(entry, "low_m", nowhere) <= measured && measured <= number_or(entry, "high_m", nowhere);
  }
  if (fitted.count > 0) fitted.deviation /= fitted.count;
  return fitted;
}

void add_shots(Section& section, const Json& result, const Json& hypothesis, int number_of_hypothesis) {
  add_speeds(section, result, hypothesis, number_of_hypothesis);
  add(section, depths_figure(result, hypothesis, number_of_hypothesis));
  add(section, depth_table(result, hypothesis));
}

Section depths_section(const Json& result) {
  Section section{.id = "depths", .title = "Depth against the impact parameter", .blocks = {}};
  const Json& shots = list(at(result, "data"), "shots");
  int n = 0;
  for (const std::string& material : each_once(shots, "material")) {
    double deepest = 0;
    std::set<double> places;
    for (const Json& shot : shots)
      if (text(shot, "material") == material && is_along_depth(shot)) {
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
        if (text(datum, "material") != material || !is_along_depth(datum)) continue;
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
      if (text(shot, "material") == material && is_along_depth(shot))
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
  add(section, deviation_table(result));
  return section;
}

}  // namespace percal::calibration_page
