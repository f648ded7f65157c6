// A hypothesis's curves over the measured ones, with the band in which one more point would lie, and what is left.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "percal/calibrate/page/sections.hpp"
#include "percal/page/numbers.hpp"

namespace percal::calibration_page {
namespace {

// Every point of a curve: how it was deformed, how far, and what stress was measured.
Json points_to_json(const MeasuredCurve& curve) {
  Json deformation = Json::array(), amount = Json::array(), stress = Json::array();
  for (const StressPoint& point : curve.data.points) {
    deformation.push_back(word(point.strained.deformation));
    amount.push_back(finite(point.strained.amount));
    stress.push_back(finite(point.nominal_stress));
  }
  return {{"deformation", deformation}, {"stretch_or_shear", amount}, {"stress_Pa", stress}};
}

}  // namespace

Json measured_curves_to_json(const CalibrationJob& job) {
  Json all = Json::array();
  for (const MeasuredCurve& curve : job.curves)
    all.push_back({{"name", curve.name},
                   {"material", job.materials[curve.material].name},
                   {"scatter", job.groups[curve.group].name},
                   {"file", curve.data.sources.empty() ? Json() : Json(curve.data.sources.front().file)},
                   {"points", curve.data.points.size()},
                   {"measured", points_to_json(curve)},
                   {"rate_factor", curve.rate_factor},
                   {"rate_factor_error", curve.rate_factor_error},
                   {"rate_1_s", finite(curve.rate)},
                   {"relative_error", curve.relative_error},
                   {"synthetic", curve.synthetic}});
  return all;
}

Json curves_to_json(const CalibrationJob& job, const std::vector<CurveStresses>& curves) {
  Json all = Json::array();
  for (const CurveStresses& curve : curves)
    all.push_back({{"curve", curve.curve},
                   {"name", job.curves[curve.curve].name},
                   {"stress_Pa", numbers_to_json(curve.stress)},
                   {"low_Pa", numbers_to_json(curve.low)},
                   {"high_Pa", numbers_to_json(curve.high)}});
  return all;
}

// --- the page -------------------------------------------------------------------------------------------------------

namespace {

struct CurvePoint {
  double amount = 0, measured = 0, model = 0, low = 0, high = 0;  // stretch or shear; Pa
};

// The points of one deformation, from the least stretch on.
std::vector<CurvePoint> points_of(const Json& curve, const Json& ours, const std::string& deformation) {
  const Json& measured = at(curve, "measured");
  const auto words = texts(at(measured, "deformation"));
  const auto amount = numbers(at(measured, "stretch_or_shear")), stress = numbers(at(measured, "stress_Pa"));
  const auto model = numbers(at(ours, "stress_Pa")), low = numbers(at(ours, "low_Pa")),
             high = numbers(at(ours, "high_Pa"));
  const std::size_t count =
      std::min({words.size(), amount.size(), stress.size(), model.size(), low.size(), high.size()});
  std::vector<CurvePoint> points;
  for (std::size_t i = 0; i < count; ++i)
    if (words[i] == deformation) points.push_back({amount[i], stress[i], model[i], low[i], high[i]});
  std::stable_sort(points.begin(), points.end(),
                   [](const CurvePoint& a, const CurvePoint& b) { return a.amount < b.amount; });
  return points;
}

// The deformations of a curve, each once.
std::vector<std::string> deformations_of(const Json& curve) {
  std::vector<std::string> all;
  for (const std::string& word : texts(at(at(curve, "measured"), "deformation")))
    if (std::find(all.begin(), all.end(), word) == all.end()) all.push_back(word);
  return all;
}

Chart chart_of(const std::string& title, const std::string& deformation, const std::string& y) {
  return {.title = title,
          .x = {.label = deformation == "simple_shear" ? "shear" : "stretch, " + deformation},
          .y = {.label = y}};
}

void add_figures(const Json& result, const Json& curve, const std::vector<CurvePoint>& points,
                 const std::string& deformation, const std::string& name, Section& section) {
  double largest = 0, squares = 0;
  int within = 0;
  for (const CurvePoint& p : points) {
    largest = std::max(largest, std::abs(p.measured));
    squares += (p.measured - p.model) * (p.measured - p.model);
    within += p.low <= p.measured && p.measured <= p.high;
  }
  const ShownUnit unit = pressure_unit(largest);
  const std::string kind = yes(curve, "synthetic") ? "synthetic" : "measured",
                    title = text(curve, "name") + ", " + text(curve, "material");
  Series band = series(level_words(result) + " of one point", Mark::band, 0), model = series("model", Mark::line, 0),
         measured = series(kind, Mark::points, 1), left = series(kind + " less model", Mark::points, 1),
         around = series(level_words(result) + " of one point", Mark::band, 0), zero = series("", Mark::line, 0);
  for (const CurvePoint& p : points) {
    add_bar(band, p.amount, p.model / unit.size, p.low / unit.size, p.high / unit.size);
    add_point(model, p.amount, p.model / unit.size);
    add_point(measured, p.amount, p.measured / unit.size);
    add_point(left, p.amount, (p.measured - p.model) / unit.size);
    add_bar(around, p.amount, 0, (p.low - p.model) / unit.size, (p.high - p.model) / unit.size);
    add_point(zero, p.amount, 0);
  }
  Chart over = chart_of(title, deformation, "nominal stress, " + unit.name),
        residuals = chart_of(title + ": residuals", deformation, "measured less model, " + unit.name);
  for (const Series& one : {band, model, measured}) add(over, one);
  for (const Series& one : {around, zero, left}) add(residuals, one);
  const double rms = std::sqrt(squares / static_cast<double>(points.size()));
  const std::string finding = fmt::format("{} of {} points lie in the band; root mean square of the residuals {}.",
                                          within, points.size(), pressure(rms, 3));
  add(section,
      Figure{.name = name,
             .caption = "The curve over its data. " + finding,
             .alt = fmt::format("Nominal stress against stretch: {} points and the model's curve through its band. {}",
                                points.size(), finding),
             .chart = over});
  add(section, Figure{.name = name + "_residuals",
                      .caption = "What the curve leaves of the data. " + finding,
                      .alt = "Residuals against stretch, about zero, with the band. " + finding,
                      .chart = residuals});
}

}  // namespace

void add_curves(Section& section, const Json& result, const Json& hypothesis, int number_of_hypothesis) {
  const Json& curves = list(at(result, "data"), "curves");
  int n = 0;
  for (const Json& ours : list(hypothesis, "curves")) {
    const auto index = static_cast<std::size_t>(number_or(ours, "curve", -1));
    if (index >= curves.size()) continue;
    for (const std::string& deformation : deformations_of(curves[index])) {
      const auto points = points_of(curves[index], ours, deformation);
      if (points.size() > 1)
        add_figures(result, curves[index], points, deformation, fmt::format("curve_{}_{}", number_of_hypothesis, ++n),
                    section);
    }
  }
}

}  // namespace percal::calibration_page
