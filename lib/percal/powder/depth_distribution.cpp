#include "percal/powder/depth_distribution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "percal/math/root.hpp"

namespace percal {
namespace {

constexpr double bins_per_scatter = 10, most_bins = 3000, fewest_bins = 300;
constexpr double no_width = 1e-6;  // of ln depth

// Integral of Phi(s/deviation) over s from -inf to t.
double integral_of_normal_cdf(double t, double deviation) {
  if (!(std::abs(t) < 40 * deviation)) return std::max(t, 0.0);
  const double z = t / deviation;
  return t * 0.5 * std::erfc(-z * M_SQRT1_2) + deviation * std::exp(-z * z / 2) / std::sqrt(2 * M_PI);
}

// Above 0 where the particle goes in.
double margin(const Bounce& bounce, const PowderParticle& particle, double log_depth) {
  if (const auto* breach = std::get_if<Breach>(&bounce))
    return std::log(impact_parameter(particle) / breach->impact_parameter);
  if (const auto* least = std::get_if<LeastDepth>(&bounce)) return log_depth - std::log(least->radii * particle.radius);
  return 1;
}

// Where on the way from 0 to 1 a straight line from `low` to `high` is not below 0.
struct Part {
  double from = 0, to = 1;
};
Part part_above(double low, double high) {
  if (low >= 0 && high >= 0) return {};
  if (low < 0 && high < 0) return {1, 1};
  const double crossing = low / (low - high);
  return low < 0 ? Part{crossing, 1} : Part{0, crossing};
}

}  // namespace

DepthDistribution::DepthDistribution(std::span<const ParticleClass> classes, const Eigen::VectorXd& low,
                                     const Eigen::VectorXd& high, const Bounce& bounce, double scatter)
    : scatter_(scatter) {
  const double least = std::min(low.minCoeff(), high.minCoeff()),
               range = std::max(low.maxCoeff(), high.maxCoeff()) - least;
  width_ = std::max(no_width, std::clamp(scatter / bins_per_scatter, range / most_bins, range / fewest_bins));
  const auto bins = static_cast<Eigen::Index>(std::ceil(range / width_)) + 1;
  first_ = least - (static_cast<double>(bins) * width_ - range) / 2;
  for (Eigen::ArrayXd& shares : shares_) shares = Eigen::ArrayXd::Zero(bins);
  for (std::size_t i = 0; i < classes.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    const auto& one = classes[i];
    const Part in = part_above(margin(bounce, one.low, low[k]), margin(bounce, one.high, high[k]));
    const double share = in.to - in.from;
    bounced_[0] += (1 - share) * one.number;
    bounced_[1] += (1 - share) * one.mass;
    if (share > 0)
      put(low[k] + in.from * (high[k] - low[k]), low[k] + in.to * (high[k] - low[k]), share * one.number,
          share * one.mass);
  }
}

// Evenly between the ends.
void DepthDistribution::put(double low, double high, double number, double mass) {
  if (low > high) std::swap(low, high);
  const double from = (low - first_) / width_, to = (high - first_) / width_;
  const auto last_bin = shares_[0].size() - 1;
  const auto bin = [&](double at) { return std::clamp<Eigen::Index>(static_cast<Eigen::Index>(at), 0, last_bin); };
  for (Eigen::Index k = bin(from); k <= bin(to); ++k) {
    const double here = to - from < no_width ? 1.0 / static_cast<double>(bin(to) - bin(from) + 1)
                                             : (std::min(to, k + 1.0) - std::max(from, k + 0.0)) / (to - from);
    shares_[0][k] += here * number;
    shares_[1][k] += here * mass;
  }
}

Eigen::ArrayXd DepthDistribution::chance_below(double x) const {
  const Eigen::Index bins = shares_[0].size();
  Eigen::ArrayXd chance(bins);
  double at_edge = integral_of_normal_cdf(x - first_, scatter_);
  for (Eigen::Index k = 0; k < bins; ++k) {
    const double at_next = integral_of_normal_cdf(x - first_ - static_cast<double>(k + 1) * width_, scatter_);
    chance[k] = (at_edge - at_next) / width_;
    at_edge = at_next;
  }
  return chance;
}

double DepthDistribution::above(By by, double depth) const {
  if (!(depth > 0)) return 0;
  return (shares_[static_cast<int>(by)] * chance_below(std::log(depth))).sum();
}

DepthDistribution::Moments DepthDistribution::moments_above(By by, double depth) const {
  const Eigen::ArrayXd& shares = shares_[static_cast<int>(by)];
  const double whole = above(by, depth), variance = scatter_ * scatter_;
  if (!(whole > 0)) return {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  const Eigen::ArrayXd middles =
      first_ + width_ * (Eigen::ArrayXd::LinSpaced(shares.size(), 0, static_cast<double>(shares.size() - 1)) + 0.5);
  const auto moment = [&](double power) {
    const double half = power * width_ / 2;
    return std::exp(power * power * variance / 2) * std::sinh(half) / half *
           (shares * (power * middles).exp() * chance_below(std::log(depth) - power * variance)).sum() / whole;
  };
  const double mean = moment(1);
  return {mean, std::sqrt(std::max(0.0, moment(2) - mean * mean))};
}

double DepthDistribution::quantile_above(By by, double depth, double share) const {
  const double wanted = share * above(by, depth);
  if (!(wanted > 0)) return std::numeric_limits<double>::quiet_NaN();
  const auto excess = [&](double x) { return above(by, std::exp(x)) - wanted; };
  const double high = std::log(depth), low = std::min(high, first_) - 10 * scatter_ - width_;
  if (excess(low) > 0) return std::exp(low);
  return std::exp(root(excess, low, high, 1e-6));
}

}  // namespace percal
