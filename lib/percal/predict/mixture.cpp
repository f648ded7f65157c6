#include "percal/predict/mixture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "percal/math/distributions.hpp"
#include "percal/math/root.hpp"

namespace percal {
namespace {

constexpr double fine_enough = 1e-9;   // of a deviation
constexpr double of_a_centre = 1e-14;  // what rounding leaves of its digits

double degrees(const Mixture& mixture) {
  return mixture.freedom > 0 ? mixture.freedom : std::numeric_limits<double>::infinity();
}

}  // namespace

double Mixture::share_below(double x) const {
  const double freedom = degrees(*this);
  double sum = 0;
  for (const double centre : centres) sum += student_cdf((x - centre) / deviation, freedom);
  return sum / static_cast<double>(centres.size());
}

// Between the quantiles of the outermost two.
double Mixture::quantile(double share) const {
  const double reach = student_quantile(share, degrees(*this)) * deviation;
  const double low = centres.minCoeff() + reach, high = centres.maxCoeff() + reach;
  if (!centres.allFinite() || !std::isfinite(reach)) return std::numeric_limits<double>::quiet_NaN();
  const auto above = [&](double x) { return share_below(x) - share; };
  const double margin = std::max(fine_enough * deviation, of_a_centre * std::max(std::abs(low), std::abs(high)));
  return root(above, low - margin, high + margin, margin);
}

double Mixture::spread() const {
  return std::sqrt((centres.array() - centres[0]).square().sum() / static_cast<double>(centres.size()));
}

}  // namespace percal
