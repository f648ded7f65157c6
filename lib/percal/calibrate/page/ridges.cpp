// The ridges: which moduli and erosion strains the data allow together, in all hypotheses.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "percal/calibrate/page/sections.hpp"
#include "percal/page/numbers.hpp"

namespace percal::calibration_page {
namespace {

Json ridge_to_json(const std::vector<FreeParameter>& parameters, const RidgeMap& map) {
  const FreeParameter &first = parameters[map.first], &second = parameters[map.second];
  Json rise = Json::array(), contours = Json::array();
  for (Eigen::Index i = 0; i < map.rise.rows(); ++i) {
    Json row = Json::array();
    for (Eigen::Index j = 0; j < map.rise.cols(); ++j) row.push_back(finite(map.rise(i, j)));
    rise.push_back(row);
  }
  for (const auto& line : map.contours) {
    std::vector<double> x, y;
    for (const auto& [at_x, at_y] : line) {
      x.push_back(at_x);
      y.push_back(at_y);
    }
    contours.push_back({{key_of("x", first), numbers_to_json(x)}, {key_of("y", second), numbers_to_json(y)}});
  }
  return {{"x_parameter", first.name},
          {"y_parameter", second.name},
          {key_of("x", first), numbers_to_json(map.x)},
          {key_of("y", second), numbers_to_json(map.y)},
          {"rise", rise},
          {"threshold", finite(map.threshold)},
          {"contours", contours}};
}

}  // namespace

Json ridges_to_json(const std::vector<FreeParameter>& parameters, const std::vector<RidgeMap>& maps) {
  Json all = Json::array();
  for (const RidgeMap& map : maps) all.push_back(ridge_to_json(parameters, map));
  return all;
}

Json published_to_json(const CalibrationJob& job) {
  Json all = Json::array();
  for (const PublishedPairs& published : job.published) {
    Json pairs = Json::array();
    for (const PublishedPair& pair : published.pairs)
      pairs.push_back({{"erosion_strain", pair.erosion_strain}, {"mu_as_given_Pa", pair.mu}});
    all.push_back(
        {{"name", published.name}, {"parameter", job.parameters[published.modulus].free.name}, {"pairs", pairs}});
  }
  return all;
}

// --- the page -------------------------------------------------------------------------------------------------------

namespace {

// Moduli that have a ridge in some hypothesis, in the order of the data.
std::vector<std::string> moduli_with_ridge(const Json& result) {
  std::vector<std::string> names;
  for (const Json& hypothesis : list(result, "hypotheses"))
    for (const Json& ridge : list(hypothesis, "ridges"))
      if (const std::string name = text(ridge, "y_parameter");
          std::find(names.begin(), names.end(), name) == names.end())
        names.push_back(name);
  return names;
}

double best_value(const Json& hypothesis, const std::string& parameter) {
  for (const Json& one : list(hypothesis, "parameters"))
    if (text(one, "name") == parameter) return number(with_unit(one, "value")).value_or(nowhere);
  return nowhere;
}

struct Extent {
  double low = HUGE_VAL, high = 0;
  void take(double value) {
    if (!(value > 0)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

Figure ridge_figure(const Json& result, const std::string& modulus) {
  Extent pascals;
  for (const Json& hypothesis : list(result, "hypotheses")) pascals.take(best_value(hypothesis, modulus));
  const ShownUnit unit = pressure_unit(pascals.low);
  Chart chart{.title = "What the data allow: " + modulus + " over the erosion strain",
              .x = {.label = "erosion strain (engineering)"},
              .y = {.label = modulus + " as given, " + unit.name}};
  std::string finding;
  Extent drawn;
  int colour = 0;
  for (const Json& hypothesis : list(result, "hypotheses")) {
    const std::string name = text(hypothesis, "name");
    for (const Json& ridge : list(hypothesis, "ridges")) {
      if (text(ridge, "y_parameter") != modulus) continue;
      Extent range;
      bool first = true;
      for (const Json& contour : list(ridge, "contours")) {
        const auto x = numbers(at(contour, "x")), y = numbers(at(contour, "y_Pa"));
        Series line = series(first ? name : "", Mark::line, colour);
        for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
          add_point(line, x[i], y[i] / unit.size);
          range.take(y[i]);
          drawn.take(y[i]);
        }
        first = false;
        add(chart, std::move(line));
      }
      Series best = series(first ? name : "", Mark::points, colour);
      add_point(best, best_value(hypothesis, text(ridge, "x_parameter")), best_value(hypothesis, modulus) / unit.size);
      add(chart, std::move(best));
      if (range.low < range.high)
        finding += fmt::format(" {}: from {} to {}.", name, pressure(range.low, 3), pressure(range.high, 3));
    }
    ++colour;
  }
  int published = 0;
  for (const Json& points : list(at(result, "data"), "ridge_points")) {
    if (text(points, "parameter") != modulus) continue;
    Series pairs = series(text(points, "name"), Mark::points, -1);
    for (const Json& pair : list(points, "pairs")) {
      const double mu = number_or(pair, "mu_as_given_Pa", nowhere);
      drawn.take(mu);
      add_point(pairs, number_or(pair, "erosion_strain", nowhere), mu / unit.size);
    }
    published += static_cast<int>(pairs.x.size());
    add(chart, std::move(pairs));
  }
  chart.y.logarithmic = worth_a_logarithm(drawn.low, drawn.high);
  return {.name = "ridge_" + modulus,
          .caption = "Allowed in 95 % regions:" + (finding.empty() ? " the best points alone were found." : finding),
          .alt = fmt::format("Outlines of the allowed region of {} over the erosion strain.{}{}", modulus, finding,
                             published > 0 ? fmt::format(" {} published pairs beside them.", published) : ""),
          .chart = chart};
}

}  // namespace

Section ridges_section(const Json& result) {
  Section section{.id = "ridges", .title = "The ridges", .blocks = {}};
  const auto moduli = moduli_with_ridge(result);
  if (!moduli.empty())
    add_sentence(
        section,
        "Outlines of the 95 % regions and best points of each hypothesis, all other parameters fitted anew at every "
        "point. Where a region is long and slanted, modulus and erosion strain change against each other and the "
        "data hardly tell.");
  for (const std::string& modulus : moduli) add(section, ridge_figure(result, modulus));
  return section;
}

}  // namespace percal::calibration_page
