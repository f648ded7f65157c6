// Depth over speed: for each ball its measured depths, the model's line through its speeds, and the band of one shot.
#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <set>

#include "percal/calibrate/page/sections.hpp"
#include "percal/page/numbers.hpp"

namespace percal::calibration_page {
namespace {

// What a sphere is called in labels: "steel 3.18 mm" of "steel 3.18 mm at 45 m/s"; with its other numbers apart.
std::string ball_of(const Json& datum) {
  const std::string label = text(datum, "label");
  const std::string ball = label.substr(0, label.find(" at "));
  const auto number = run_number_of(text(datum, "number"));
  return number.value_or(RunNumber::depth) == RunNumber::depth ? ball : ball + ", " + kind_of(*number).words;
}

// Shots of one sphere into one material by their speed.
using Ball = std::multimap<double, const Json*>;

struct BallsInMaterial {
  std::vector<std::pair<std::string, Ball>> balls;  // in the order of the data
  std::set<double> speeds;
  double deepest = 0;
};

BallsInMaterial balls_in(const std::string& material, const Json& result, const Json& hypothesis) {
  BallsInMaterial all;
  for (const Json& entry : list(hypothesis, "shots")) {
    const Json& datum = datum_of(result, entry);
    if (text(datum, "material") != material || !is_along_depth(datum)) continue;
    const std::string name = ball_of(datum);
    auto ball = std::find_if(all.balls.begin(), all.balls.end(), [&](const auto& one) { return one.first == name; });
    if (ball == all.balls.end()) ball = all.balls.insert(ball, {name, {}});
    const double speed = number_or(datum, "speed_m_s", nowhere);
    ball->second.emplace(speed, &entry);
    all.speeds.insert(speed);
    all.deepest = std::max(all.deepest, measured_depth(entry));
  }
  return all;
}

void add_ball(Chart& chart, const std::string& name, const Ball& ball, int colour, double unit) {
  Series band = series("", Mark::band, colour), model = series("", Mark::line, colour),
         measured = series(name, Mark::points, colour), least = series(name + ", or deeper", Mark::points, -1);
  for (const auto& [speed, entry] : ball) {
    const double depth = number_or(*entry, "depth_m", nowhere) / unit;
    if (model.x.empty() || model.x.back() != speed) {
      add_point(model, speed, depth);
      add_bar(band, speed, depth, number_or(*entry, "low_m", nowhere) / unit,
              number_or(*entry, "high_m", nowhere) / unit);
    }
    add_point(number(*entry, "measured_m") ? measured : least, speed, measured_depth(*entry) / unit);
  }
  if (model.x.size() < 2) {  // a line of one point is none
    model.mark = Mark::points_with_bars;
    model.low = band.low;
    model.high = band.high;
    band = {};
  }
  for (Series* one : {&band, &model, &measured, &least}) add(chart, std::move(*one));
}

}  // namespace

void add_speeds(Section& section, const Json& result, const Json& hypothesis, int number_of_hypothesis) {
  int number_of_material = 0;
  for (const std::string& material : each_once(list(at(result, "data"), "shots"), "material")) {
    const BallsInMaterial shots = balls_in(material, result, hypothesis);
    if (shots.speeds.size() < 2) continue;
    const ShownUnit unit = length_unit(shots.deepest);
    Chart chart{.title = "Depth over speed in " + material,
                .x = {.label = "speed, m/s"},
                .y = {.label = "depth, " + unit.name, .low = 0}};
    int colour = 0;
    for (const auto& [name, ball] : shots.balls) add_ball(chart, name, ball, colour++, unit.size);
    const std::string balls = counted(static_cast<int>(shots.balls.size()), "ball");
    add(section,
        Figure{.name = fmt::format("speed_{}_{}", number_of_hypothesis, ++number_of_material),
               .caption = fmt::format("Depth over speed in {}. Points: measured; lines: the model at the shots' "
                                      "speeds; bands: where {} of single shots would lie.",
                                      material, level_words(result)),
               .alt = fmt::format("Depths of {} in {} over speed, measured points about the model's lines.", balls,
                                  material),
               .chart = chart});
  }
}

}  // namespace percal::calibration_page
