#include "percal/fit/alpha_scan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "percal/fit/moduli.hpp"

namespace percal {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

// A dip shallower than this share of the objective, or of this share squared of all weighted stress, is rounding.
constexpr double shallow = 1e-10;

// Stresses of all points for mu = 1 at alpha = 0, step, 2 step, .. and their negatives, by the addition theorems: no
// transcendental function after the first, and no digits lost, since everything that is added is positive.   (3)
//   stress(alpha) = 4 weight factor sinh(alpha half)/alpha exp(alpha mean)
class Responses {
 public:
  Responses(const std::vector<WeightedPoint>& points, double step) : step_(step) {
    const auto n = static_cast<Eigen::Index>(points.size());
    for (auto* array : {&factor_, &half_, &sinh_step_, &cosh_step_, &exp_step_}) array->resize(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto& [pair, stress, weight, test] = points[i];
      factor_(i) = 4 * weight * pair.nominal_factor;
      half_(i) = (pair.log_i - pair.log_j) / 2;
      sinh_step_(i) = std::sinh(step * half_(i));
      cosh_step_(i) = std::cosh(step * half_(i));
      exp_step_(i) = std::exp(step * (pair.log_i + pair.log_j) / 2);
    }
    sinh_ = Eigen::ArrayXd::Zero(n);
    cosh_ = exp_ = Eigen::ArrayXd::Ones(n);
    inverse_step_ = exp_step_.inverse();
    inverse_ = exp_;
  }
  void advance() {
    ++steps_;
    const Eigen::ArrayXd sinh_before = sinh_;
    sinh_ = sinh_ * cosh_step_ + cosh_ * sinh_step_;
    cosh_ = cosh_ * cosh_step_ + sinh_before * sinh_step_;
    exp_ *= exp_step_;
    inverse_ *= inverse_step_;
  }
  double alpha() const { return steps_ * step_; }
  Eigen::VectorXd at_zero() const { return factor_ * half_; }
  Eigen::VectorXd at_alpha() const { return factor_ * sinh_ * exp_ / alpha(); }
  Eigen::VectorXd at_minus_alpha() const { return factor_ * sinh_ * inverse_ / alpha(); }

 private:
  double step_;
  int steps_ = 0;
  Eigen::ArrayXd factor_, half_, sinh_step_, cosh_step_, exp_step_, inverse_step_, sinh_, cosh_, exp_, inverse_;
};

ProfileValue least_squares(double alpha, const Eigen::VectorXd& response, const Eigen::VectorXd& data) {
  const double largest = response.lpNorm<Eigen::Infinity>();
  if (!(largest > 0) || !std::isfinite(largest)) return {alpha, 0, never};
  const double inverse = 1 / largest;
  const double scaled = (response * inverse).dot(data) / (response * inverse).squaredNorm();
  const double mu = scaled * inverse;
  if (!(mu > 0) || !std::isnormal(mu)) return {alpha, std::isnormal(mu) ? mu : 0, never};
  return {alpha, mu, (data - (scaled * inverse) * response).squaredNorm()};
}

ProfileValue at(double alpha, const Eigen::VectorXd& response, const Eigen::VectorXd& data, const ScaledLoss& loss) {
  if (loss.loss == Loss::squares) return least_squares(alpha, response, data);
  const Moduli best = best_moduli(response, data, Signs::positive, loss);
  if (!std::isfinite(best.objective) || !std::isnormal(best.mu(0))) return {alpha, 0, never};
  return {alpha, best.mu(0), best.objective};
}

}  // namespace

std::vector<ProfileValue> profile(const std::vector<WeightedPoint>& points, const ScaledLoss& loss, double largest,
                                  int half) {
  const Eigen::VectorXd data = weighted_stress(points);
  std::vector<ProfileValue> scan(2 * half + 1);
  Responses responses(points, largest / half);
  scan[half] = at(0, responses.at_zero(), data, loss);
  for (int i = 1; i <= half; ++i) {
    responses.advance();
    scan[half + i] = at(responses.alpha(), responses.at_alpha(), data, loss);
    scan[half - i] = at(-responses.alpha(), responses.at_minus_alpha(), data, loss);
  }
  return scan;
}

std::vector<Bracket> minima_of(const std::vector<ProfileValue>& scan, double weighted_squares) {
  const double floor = shallow * shallow * weighted_squares;
  const int steps = static_cast<int>(scan.size()) - 1;
  const auto at = [&](int i) { return scan[std::clamp(i, 0, steps)]; };

  std::vector<int> lowest;  // of each basin
  for (int i = 0; i <= steps; ++i) {
    if (!std::isfinite(scan[i].objective)) continue;
    if ((i > 0 && scan[i - 1].objective <= scan[i].objective) ||
        (i < steps && scan[i + 1].objective < scan[i].objective))
      continue;
    if (!lowest.empty()) {
      double ridge = 0;
      for (int k = lowest.back(); k <= i; ++k) ridge = std::max(ridge, scan[k].objective);
      const double higher = std::max(scan[lowest.back()].objective, scan[i].objective);
      if (ridge - higher <= shallow * higher + floor) {
        if (scan[i].objective < scan[lowest.back()].objective) lowest.back() = i;
        continue;
      }
    }
    lowest.push_back(i);
  }
  std::vector<Bracket> brackets;
  for (int i : lowest) brackets.push_back({scan[i], at(i - 1).alpha, at(i + 1).alpha});
  return brackets;
}

}  // namespace percal
