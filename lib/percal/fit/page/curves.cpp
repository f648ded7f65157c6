// Figures of a curve fit: curves over points, residuals.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "percal/fit/page/sections.hpp"
#include "percal/page/numbers.hpp"

namespace percal::page_of_fit {
namespace {

std::string words(Deformation deformation) {
  std::string text = word(deformation);
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

ShownUnit unit_of(const std::vector<const PageCurve*>& curves) {
  double largest = 0;
  for (const PageCurve* curve : curves)
    for (const double stress : curve->points.stress) largest = std::max(largest, std::abs(stress));
  return pressure_unit(largest);
}

std::string amount_label(Deformation deformation) {
  return deformation == Deformation::simple_shear ? "shear gamma" : "stretch";
}

Series points_series(const PageCurve& curve, int colour, const ShownUnit& unit) {
  const PagePoints& points = curve.points;
  const bool bars = std::any_of(points.error.begin(), points.error.end(), [](double e) { return std::isfinite(e); });
  Series drawn = series(points.name + ": points", bars ? Mark::points_with_bars : Mark::points, colour);
  for (std::size_t i = 0; i < points.stress.size(); ++i) {
    const double stress = points.stress[i] / unit.size, error = points.error[i] / unit.size;
    if (bars)
      add_bar(drawn, points.strained[i].amount, stress, stress - error, stress + error);
    else
      add_point(drawn, points.strained[i].amount, stress);
  }
  return drawn;
}

// From the undeformed state, or from the first point where that is nearer to it, to the last.
std::pair<double, double> range_of(const PagePoints& points) {
  double low = points.deformation == Deformation::simple_shear ? 0 : 1, high = low;
  for (const Strained& strained : points.strained) {
    low = std::min(low, strained.amount);
    high = std::max(high, strained.amount);
  }
  return {low, high};
}

void add_curve(Chart& chart, const PageCurve& curve, int colour, const ShownUnit& unit) {
  const auto [low, high] = range_of(curve.points);
  Series line = series(curve.name, Mark::line, colour), band = series("", Mark::band, colour);
  for (const double amount : spaced(low, high, 81)) {
    const Strained strained{curve.points.deformation, amount};
    const double stress = curve.stress(strained) / unit.size, half = curve.half_width(strained) / unit.size;
    add_point(line, amount, stress);
    if (std::isfinite(half)) add_bar(band, amount, stress, stress - half, stress + half);
  }
  add(chart, band);
  add(chart, line);
}

// Tests that share a curve, tension and compression say, get it once.
std::vector<PageCurve> joined(const std::vector<const PageCurve*>& curves) {
  std::vector<PageCurve> all;
  for (const PageCurve* curve : curves) {
    const auto same = std::find_if(all.begin(), all.end(), [&](const PageCurve& c) { return c.name == curve->name; });
    if (same == all.end()) {
      all.push_back(*curve);
    } else {
      auto& strained = same->points.strained;
      strained.insert(strained.end(), curve->points.strained.begin(), curve->points.strained.end());
    }
  }
  return all;
}

Figure curve_figure(Deformation deformation, const std::vector<const PageCurve*>& curves,
                    const std::string& band_words) {
  const ShownUnit unit = unit_of(curves);
  Figure figure;
  figure.name = "curve_" + word(deformation);
  figure.chart.title = "Nominal stress, " + words(deformation);
  figure.chart.x.label = amount_label(deformation);
  figure.chart.y.label = "nominal stress, " + unit.name;
  int colour = 0;
  if (deformation != Deformation::biaxial)
    for (const PageCurve& curve : joined(curves)) add_curve(figure.chart, curve, colour++, unit);
  const int of_points = colour > 1 ? 0 : 1;  // one curve: the points in other colours; several: each in its curve's
  for (std::size_t k = 0; k < curves.size(); ++k)
    add(figure.chart, points_series(*curves[k], of_points + static_cast<int>(k), unit));
  figure.caption = deformation == Deformation::biaxial
                       ? "The points; a curve would need the second stretch as a second axis, see the residuals."
                       : "Points and the fitted curve. " + band_words;
  figure.alt =
      fmt::format("Nominal stress over {} in {}: measured points and the fitted curve{}.", figure.chart.x.label,
                  words(deformation), band_words.starts_with("No band") ? "" : " with its confidence band");
  return figure;
}

double residual_of(const PageCurve& curve, std::size_t i, const std::string& kind) {
  const double stress = curve.points.stress[i], miss = stress - curve.stress(curve.points.strained[i]);
  if (kind == "relative") return stress == 0 ? NAN : 100 * miss / stress;
  return kind == "error" ? miss / curve.points.error[i] : miss;
}

}  // namespace

std::vector<PagePoints> points_of(const Json& result) {
  std::vector<PagePoints> all;
  for (const Json& test : list(result, "data")) {
    PagePoints points;
    points.name = text(test, "name");
    points.deformation = deformation_of(text(test, "deformation")).value_or(Deformation::uniaxial);
    const auto amount = numbers(at(test, "amount")), across = numbers(at(test, "across"));
    points.stress = numbers(at(test, "stress_Pa"));
    points.error = numbers(at(test, "error_Pa"));
    points.stress.resize(amount.size(), NAN);
    points.error.resize(amount.size(), NAN);
    for (std::size_t i = 0; i < amount.size(); ++i)
      points.strained.push_back(
          {points.deformation, amount[i], i < across.size() && std::isfinite(across[i]) ? across[i] : 1});
    all.push_back(points);
  }
  return all;
}

void add_curve_figures(Section& section, const std::vector<PageCurve>& curves, const std::string& band_words) {
  std::map<Deformation, std::vector<const PageCurve*>> of;
  for (const PageCurve& curve : curves) of[curve.points.deformation].push_back(&curve);
  for (const auto& [deformation, some] : of) add(section, curve_figure(deformation, some, band_words));
}

Figure residual_figure(const std::vector<PageCurve>& curves, const std::string& kind) {
  std::vector<const PageCurve*> all;
  for (const PageCurve& curve : curves) all.push_back(&curve);
  const ShownUnit unit = kind == "absolute" ? unit_of(all) : ShownUnit{"", 1};
  Figure figure;
  figure.name = "residuals";
  figure.chart.title = "Residuals";
  figure.chart.x.label = "stretch (shear: gamma)";
  figure.chart.y.label = kind == "relative" ? "(stress - model)/stress, %"
                         : kind == "error"  ? "(stress - model)/standard error"
                                            : "stress - model, " + unit.name;
  double low = HUGE_VAL, high = -HUGE_VAL, squares = 0;
  int count = 0;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    Series drawn = series(curves[k].points.name, Mark::points, static_cast<int>(k) + 1);
    for (std::size_t i = 0; i < curves[k].points.stress.size(); ++i) {
      const double residual = residual_of(curves[k], i, kind) / unit.size, x = curves[k].points.strained[i].amount;
      add_point(drawn, x, residual);
      if (!std::isfinite(residual)) continue;
      low = std::min(low, x);
      high = std::max(high, x);
      squares += residual * residual;
      ++count;
    }
    add(figure.chart, drawn);
  }
  if (count == 0) return figure;
  Series zero = series("", Mark::line, -1);
  zero.x = {low, high};
  zero.y = {0, 0};
  add(figure.chart, zero);
  const std::string size = fmt::format("{:.3g} {}", std::sqrt(squares / count), kind == "relative" ? "%" : unit.name);
  figure.caption = fmt::format(
      "What the model leaves, point by point, in the kind of residual that was made small ({}). Root of the mean "
      "square {}. A pattern, instead of scatter about zero, is a misfit of the model.",
      kind, size);
  figure.alt = fmt::format("Residuals of {} points over the stretch; root of the mean square {}.", count, size);
  return figure;
}

}  // namespace percal::page_of_fit
