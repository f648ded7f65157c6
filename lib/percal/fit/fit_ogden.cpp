#include "percal/fit/fit_ogden.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "percal/base/error.hpp"
#include "percal/fit/alpha_scan.hpp"
#include "percal/fit/polish.hpp"

namespace percal {
namespace {

constexpr int scan_steps = 800;          // 0.1 in alpha: basins are about 1/ln(largest stretch) wide
constexpr double same_alpha = 1e-6;      // two results closer than this are one minimum
constexpr double same_objective = 1e-9;  // relative: below this two minima are equally good
constexpr double rounding = 1e-24;       // share of the sum of squares of the data that is only rounding
constexpr double singular = 1e-12;       // 1 - correlation^2 below which mu and alpha cannot be told apart

// The points that count, and the stress that their stresses are divided by: no number depends on the unit of stress.
struct Prepared {
  std::vector<StressPoint> used;
  std::vector<WeightedPoint> weighted;
  double scale = 1;  // Pa
};

Prepared prepare(const CurveData& data, Residual residual, OgdenFit& fit) {
  Prepared prepared;
  double largest = 0;
  std::set<std::pair<double, double>> different;
  for (const auto& point : data.points) {
    if (residual == Residual::relative && point.nominal_stress == 0) {
      ++fit.left_out_zero_stress;
      continue;
    }
    prepared.used.push_back(point);
    ++fit.points_of_mode[point.strained.deformation];
    largest = std::max(largest, std::abs(point.nominal_stress));
    const auto pair = principal_pair(point.strained);
    if (pair.log_i != pair.log_j) different.insert({pair.log_i, pair.log_j});
  }
  fit.points = static_cast<int>(prepared.used.size());
  if (different.size() < 2 || largest == 0)
    throw BadInput(std::string("found ") +
                   (largest == 0 && fit.points > 0
                        ? "no stress that differs from zero"
                        : std::to_string(different.size()) + " different deformed point(s)") +
                   "; accepted: curves with at least 2 different deformed points with stress, for mu and alpha");
  prepared.scale = largest;
  for (const auto& point : prepared.used) {
    const double stress = point.nominal_stress / largest;
    prepared.weighted.push_back(
        {principal_pair(point.strained), stress, residual == Residual::relative ? 1 / stress : 1.0});
  }
  return prepared;
}

// 1 - SSE/SST, with the stresses in units of the scale.
std::optional<double> coefficient_of_determination(const std::vector<WeightedPoint>& points, const Ogden& scaled) {
  double mean = 0, sse = 0, sst = 0;
  for (const auto& point : points) mean += point.stress / static_cast<double>(points.size());
  for (const auto& point : points) {
    const double error = point.stress - nominal_stress(scaled, point.pair), deviation = point.stress - mean;
    sse += error * error;
    sst += deviation * deviation;
  }
  if (sst == 0 || !std::isfinite(sse / sst)) return std::nullopt;
  return 1 - sse / sst;
}

// Standard errors and correlation of (mu, alpha) from the normal matrix of (ln mu, alpha). docs/theory/curves.md (14)
void add_standard_errors(OgdenMinimum& minimum, const Polished& polished, int points) {
  const auto [a, b, c] = polished.normal_matrix;
  const double determinant = a * c - b * b;
  if (minimum.at_bound || points < 3 || !(determinant > singular * a * c)) return;
  const double variance = polished.objective / (points - 2);
  minimum.mu_standard_error = minimum.solid.mu * std::sqrt(variance * c / determinant);
  minimum.alpha_standard_error = std::sqrt(variance * a / determinant);
  minimum.correlation = std::clamp(-b / std::sqrt(a * c), -1.0, 1.0);
}

double rounding_of_objective(const Prepared& prepared, double objective_unit) {
  double sum = 0;
  for (const auto& point : prepared.weighted) sum += point.weight * point.stress * point.weight * point.stress;
  return rounding * sum * objective_unit;
}

// Best first; of two equal ones the positive alpha first, so that the order is no matter of rounding.
void sort_and_compare(std::vector<OgdenMinimum>& minima, double floor) {
  std::sort(minima.begin(), minima.end(), [](const auto& a, const auto& b) { return a.objective < b.objective; });
  const auto equal = [&](const auto& a, const auto& b) {
    return b.objective - a.objective <= same_objective * a.objective + floor;
  };
  for (std::size_t i = 0; i + 1 < minima.size(); ++i)
    if (equal(minima[i], minima[i + 1]) && minima[i].solid.alpha < 0 && minima[i + 1].solid.alpha > 0)
      std::swap(minima[i], minima[i + 1]);
  for (auto& minimum : minima) {
    const double ratio = minimum.objective / minima[0].objective;
    if (std::isfinite(ratio)) minimum.above_best = ratio - 1;
    if (&minimum == &minima[0] || equal(minima[0], minimum)) minimum.above_best = 0;
  }
}

}  // namespace

OgdenFit fit_ogden(const CurveData& data, Residual residual) {
  OgdenFit fit;
  fit.residual = residual;
  const Prepared prepared = prepare(data, residual, fit);
  const auto brackets = scan_alpha(prepared.weighted, largest_alpha, scan_steps);
  fit.scanned = scan_steps + 1;
  fit.starts = static_cast<int>(brackets.size());
  const double objective_unit = residual == Residual::absolute ? prepared.scale * prepared.scale : 1;
  for (const auto& bracket : brackets) {
    const Polished polished = polish(prepared.weighted, bracket);
    OgdenMinimum minimum{};
    minimum.solid = {polished.solid.mu * prepared.scale, polished.solid.alpha};
    minimum.objective = polished.objective * objective_unit;
    if (!std::isnormal(minimum.solid.mu) || !std::isfinite(minimum.objective)) continue;
    const bool known = std::any_of(fit.minima.begin(), fit.minima.end(), [&](const auto& other) {
      return std::abs(other.solid.alpha - minimum.solid.alpha) < same_alpha * (1 + std::abs(minimum.solid.alpha));
    });
    if (known) continue;
    minimum.converged = polished.converged;
    minimum.iterations = polished.iterations;
    minimum.at_bound = std::abs(minimum.solid.alpha) > largest_alpha * (1 - 1e-9);
    minimum.r2 = coefficient_of_determination(prepared.weighted, polished.solid);
    add_standard_errors(minimum, polished, fit.points);
    fit.minima.push_back(minimum);
  }
  sort_and_compare(fit.minima, rounding_of_objective(prepared, objective_unit));
  return fit;
}

std::string word(Residual residual) { return residual == Residual::relative ? "relative" : "absolute"; }

}  // namespace percal
