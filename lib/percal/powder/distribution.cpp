#include "percal/powder/distribution.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace percal {
namespace {

constexpr double reach =
    5.5;  // standard deviations of ln x on either side, of the number and of what the moment weights

double normal_cdf(double z) { return 0.5 * std::erfc(-z * M_SQRT1_2); }

double middle(const ValueClass& one) { return std::sqrt(one.low * one.high); }

// Mean of x^power over an even spread of ln x.
double mean_power(double low, double high, double power) {
  const double width = std::log(high / low);
  if (power == 0) return 1;
  if (power * width < 1e-6) return std::pow(low * high, power / 2);
  return (std::pow(high, power) - std::pow(low, power)) / (power * width);
}

// Spread evenly within its cells, a normal distribution cut to cells of h deviations has 1 + h^2/6 of its variance: one as much narrower
// is cut. The moment's distribution lies power s^2 higher.
std::vector<DistributionCell> cells(const Lognormal& all, int count, double power) {
  const double s = all.log_deviation, shift = power * s;
  if (s == 0) return {{all.median, all.median, 1, std::pow(all.median, power)}};
  const double first = -reach + std::min(0.0, shift), last = reach + std::max(0.0, shift);
  const double step = (last - first) / count, narrower = 1 / std::sqrt(1 + step * step / 6);
  const double whole = std::pow(all.median, power) * std::exp(shift * shift / 2);
  const auto value = [&](double z) { return all.median * std::exp(z * s * narrower); };
  // The tails beyond the reach, below 1e-7, belong to the outermost cells.
  const auto below = [&](int edge, double by) {
    return edge == 0 ? 0 : edge == count ? 1 : normal_cdf(first + edge * step - by);
  };
  std::vector<DistributionCell> found;
  for (int k = 0; k < count; ++k)
    found.push_back({value(first + k * step), value(first + (k + 1) * step), below(k + 1, 0) - below(k, 0),
                     whole * (below(k + 1, shift / narrower) - below(k, shift / narrower))});
  return found;
}

// The trapezoidal rule, which converges geometrically on a normal density.
std::vector<DistributionCell> nodes(const Lognormal& all, int count, double power) {
  const double s = all.log_deviation, shift = power * s;
  if (s == 0) return cells(all, 1, power);
  const double first = -reach + std::min(0.0, shift), last = reach + std::max(0.0, shift);
  std::vector<DistributionCell> found;
  double sum = 0;
  for (int k = 0; k < count; ++k) {
    const double z = first + (k + 0.5) * (last - first) / count, value = all.median * std::exp(z * s);
    found.push_back({value, value, std::exp(-z * z / 2), 0});
    sum += found.back().share;
  }
  for (DistributionCell& node : found) {
    node.share /= sum;
    node.moment = node.share * std::pow(node.low, power);
  }
  return found;
}

// Neighbours together, `count` of them at the end; their shares and moments are kept.
std::vector<DistributionCell> merged(const std::vector<DistributionCell>& cells, int count) {
  std::vector<DistributionCell> found;
  const std::size_t size = cells.size(), groups = static_cast<std::size_t>(count);
  for (std::size_t group = 0; group < groups; ++group) {
    const std::size_t first = group * size / groups, last = (group + 1) * size / groups - 1;
    found.push_back({cells[first].low, cells[last].high, 0, 0});
    for (std::size_t k = first; k <= last; ++k) {
      found.back().share += cells[k].share;
      found.back().moment += cells[k].moment;
    }
  }
  return found;
}

std::vector<DistributionCell> cells(const Histogram& classes, int count, double power) {
  std::vector<DistributionCell> found;
  const int parts = std::max(1, (count + static_cast<int>(classes.size()) - 1) / static_cast<int>(classes.size()));
  for (const ValueClass& one : classes) {
    const int here = one.high > one.low ? parts : 1;
    const double ratio = std::pow(one.high / one.low, 1.0 / here);
    for (int k = 0; k < here; ++k) {
      const double low = one.low * std::pow(ratio, k), high = k + 1 == here ? one.high : low * ratio;
      found.push_back({low, high, one.share / here, one.share / here * mean_power(low, high, power)});
    }
  }
  return static_cast<int>(classes.size()) > count ? merged(found, count) : found;
}

std::vector<DistributionCell> nodes(const Histogram& classes, int count, double power) {
  std::vector<DistributionCell> found = cells(classes, count, power);
  for (DistributionCell& node : found) node.low = node.high = std::sqrt(node.low * node.high);
  return found;
}

}  // namespace

Lognormal lognormal_of(double mean, double deviation) {
  const double variance = std::log1p(deviation * deviation / (mean * mean));
  return {mean * std::exp(-variance / 2), std::sqrt(variance)};
}

Distribution by_number(const Distribution& by_mass) {
  if (const auto* lognormal = std::get_if<Lognormal>(&by_mass)) {
    const double s = lognormal->log_deviation;
    return Lognormal{lognormal->median * std::exp(-3 * s * s), s};
  }
  // Mass evenly spread over ln x is number spread as x^-3: classes narrow enough for that to be one number in each.
  constexpr int fine = 200;
  Histogram classes;
  double sum = 0;
  for (const DistributionCell& cell : cells(std::get<Histogram>(by_mass), fine, -3)) {
    classes.push_back({cell.low, cell.high, cell.moment});
    sum += cell.moment;
  }
  for (ValueClass& one : classes) one.share /= sum;
  return classes;
}

double median_of(const Distribution& distribution) {
  if (const auto* lognormal = std::get_if<Lognormal>(&distribution)) return lognormal->median;
  double below = 0;
  for (const ValueClass& one : std::get<Histogram>(distribution)) {
    if (below + one.share >= 0.5) return one.low * std::pow(one.high / one.low, (0.5 - below) / one.share);
    below += one.share;
  }
  return std::get<Histogram>(distribution).back().high;
}

double log_deviation_of(const Distribution& distribution) {
  if (const auto* lognormal = std::get_if<Lognormal>(&distribution)) return lognormal->log_deviation;
  const auto& classes = std::get<Histogram>(distribution);
  const double mean = std::accumulate(classes.begin(), classes.end(), 0.0, [](double sum, const ValueClass& one) {
    return sum + one.share * std::log(middle(one));
  });
  double variance = 0;
  for (const ValueClass& one : classes) {
    const double width = std::log(one.high / one.low);
    variance += one.share * (std::pow(std::log(middle(one)) - mean, 2) + width * width / 12);
  }
  return std::sqrt(variance);
}

bool is_one_value(const Distribution& distribution) { return !(log_deviation_of(distribution) > 0); }

Distribution spread_by(const Distribution& distribution, double factor) {
  const double median = median_of(distribution);
  if (factor == 0) return Lognormal{median, 0};
  if (const auto* lognormal = std::get_if<Lognormal>(&distribution))
    return Lognormal{median, factor * lognormal->log_deviation};
  Histogram classes = std::get<Histogram>(distribution);
  for (ValueClass& one : classes)
    for (double* end : {&one.low, &one.high}) *end = median * std::pow(*end / median, factor);
  return classes;
}

std::vector<DistributionCell> cells_of(const Distribution& distribution, int count, double power) {
  return std::visit([&](const auto& one) { return cells(one, count, power); }, distribution);
}

std::vector<DistributionCell> nodes_of(const Distribution& distribution, int count, double power) {
  return std::visit([&](const auto& one) { return nodes(one, count, power); }, distribution);
}

}  // namespace percal
