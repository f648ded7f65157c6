#include "percal/material/prony.hpp"

#include <cmath>

namespace percal {
namespace {

constexpr double short_step = 1e-4;  // of tau: below it the series' next term is rounding

}  // namespace

double share_left(const PronySeries& series, double time) {
  double share = 1;
  for (const PronyTerm& term : series.terms) share += term.share * std::expm1(-time / term.time);
  return share;
}

double lasting_share(const PronySeries& series) {
  double share = 1;
  for (const PronyTerm& term : series.terms) share -= term.share;
  return share;
}

ShareSlopes share_slopes(const PronySeries& series, double time) {
  const double left = share_left(series, time);
  const auto count = static_cast<Eigen::Index>(series.terms.size());
  ShareSlopes slopes{Eigen::RowVectorXd(2 * count)};
  for (Eigen::Index k = 0; k < count; ++k) {
    const auto& [share, relaxation_time] = series.terms[static_cast<std::size_t>(k)];
    const double x = time / relaxation_time, moving = share * x * std::exp(-x) / left;
    slopes.by_parameter[k] = std::expm1(-x) / left;
    slopes.by_parameter[count + k] = moving;
    slopes.by_log_elapsed -= moving;
  }
  return slopes;
}

HereditaryStep hereditary_step(double elapsed, double time) {
  const double x = elapsed / time, decay = std::exp(-x);
  if (x < short_step) return {decay, 1 - x / 2 + x * x / 6 - x * x * x / 24, x * decay, x / 2 - x * x / 3 + x * x * x / 8};
  const double taken = -std::expm1(-x) / x;
  return {decay, taken, x * decay, taken - decay};
}

}  // namespace percal
