#include "percal/fit/search/moduli.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <vector>

namespace percal {
namespace {

constexpr double dependent = 1e-9;  // of the columns' norm: what is left of one beside the others
constexpr int most_rounds = 300;    // of the reweighting
constexpr double settled = 1e-13;   // relative change of the moduli in a round

// Least squares over one column.
Moduli over_one(const Eigen::VectorXd& column, const Eigen::VectorXd& data) {
  Moduli found{Eigen::VectorXd::Zero(1)};
  const double largest = column.lpNorm<Eigen::Infinity>();
  if (!(largest > 0) || !std::isfinite(largest)) return found;
  const Eigen::VectorXd scaled = column / largest;
  const double mu = scaled.dot(data) / scaled.squaredNorm();
  if (!std::isfinite(mu / largest)) return found;
  return {Eigen::VectorXd::Constant(1, mu / largest), (data - mu * scaled).squaredNorm()};
}

// Least squares over the terms of `chosen` (a bit for each); an infinite objective where they are dependent.
Moduli over(const Eigen::MatrixXd& columns, const Eigen::VectorXd& data, unsigned chosen) {
  Moduli found{Eigen::VectorXd::Zero(columns.cols())};
  std::vector<Eigen::Index> terms;
  for (Eigen::Index k = 0; k < columns.cols(); ++k)
    if (chosen >> k & 1u) terms.push_back(k);
  Eigen::MatrixXd part(columns.rows(), terms.size());
  Eigen::VectorXd size(terms.size());
  for (std::size_t k = 0; k < terms.size(); ++k) {
    size(k) = columns.col(terms[k]).stableNorm();
    if (!(size(k) > 0) || !std::isfinite(size(k))) return found;
    part.col(k) = columns.col(terms[k]) / size(k);
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(part);
  qr.setThreshold(dependent);
  if (qr.rank() < part.cols()) return found;
  const Eigen::VectorXd scaled = qr.solve(data);
  found.objective = (data - part * scaled).squaredNorm();
  for (std::size_t k = 0; k < terms.size(); ++k) found.mu(terms[k]) = scaled(k) / size(k);
  if (!found.mu.allFinite()) found.objective = std::numeric_limits<double>::infinity();
  return found;
}

bool allowed(const Moduli& moduli, Signs signs) {
  return std::isfinite(moduli.objective) && (signs == Signs::free || moduli.mu.minCoeff() >= 0);
}

// All terms where that is allowed, which is then the best there is; otherwise the best allowed choice of fewer.
Moduli least_squares(const Eigen::MatrixXd& columns, const Eigen::VectorXd& data, Signs signs) {
  const unsigned all = (1u << columns.cols()) - 1;
  Moduli best = columns.cols() == 1 ? over_one(columns, data) : over(columns, data, all);
  if (allowed(best, signs)) return best;
  best = {Eigen::VectorXd::Zero(columns.cols())};
  for (unsigned chosen = 1; chosen < all; ++chosen) {
    const Moduli found = over(columns, data, chosen);
    if (allowed(found, signs) && found.objective < best.objective) best = found;
  }
  return best;
}

// Iteratively reweighted least squares from moduli that are about right.
Moduli reweighted(const Eigen::MatrixXd& columns, const Eigen::VectorXd& data, Signs signs, const ScaledLoss& loss,
                  Moduli moduli) {
  for (int round = 0; round < most_rounds && std::isfinite(moduli.objective); ++round) {
    Eigen::VectorXd root = data - columns * moduli.mu;
    for (double& entry : root) entry = std::sqrt(weight_of(loss, entry));
    const Eigen::VectorXd before = moduli.mu;
    moduli = least_squares(root.asDiagonal() * columns, root.asDiagonal() * data, signs);
    if ((moduli.mu - before).norm() <= settled * before.norm()) break;
  }
  if (!std::isfinite(moduli.objective)) return moduli;
  moduli.objective = 0;
  for (const double residual : data - columns * moduli.mu) moduli.objective += loss_of(loss, residual);
  return moduli;
}

}  // namespace

double loss_of(const ScaledLoss& loss, double residual) {
  const double size = std::abs(residual), s = loss.scale;
  switch (loss.loss) {
    case Loss::huber: return size <= s ? size * size : 2 * s * size - s * s;
    case Loss::cauchy: return s * s * std::log1p(size / s * (size / s));
    case Loss::squares: break;
  }
  return size * size;
}

double weight_of(const ScaledLoss& loss, double residual) {
  const double size = std::abs(residual), s = loss.scale;
  switch (loss.loss) {
    case Loss::huber: return size <= s ? 1 : s / size;
    case Loss::cauchy: return 1 / (1 + size / s * (size / s));
    case Loss::squares: break;
  }
  return 1;
}

double scale_for(Loss loss, const Eigen::VectorXd& residuals) {
  std::vector<double> sizes(residuals.data(), residuals.data() + residuals.size());
  for (double& size : sizes) size = std::abs(size);
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  return (loss == Loss::cauchy ? 2.385 : 1.345) * 1.4826 * *middle;
}

std::string word(Loss loss) {
  switch (loss) {
    case Loss::huber: return "huber";
    case Loss::cauchy: return "cauchy";
    case Loss::squares: break;
  }
  return "squares";
}

TermColumns term_columns(const std::vector<WeightedPoint>& points, const std::vector<double>& alphas) {
  TermColumns columns{Eigen::MatrixXd(points.size(), alphas.size()), Eigen::MatrixXd(points.size(), alphas.size())};
  for (std::size_t k = 0; k < alphas.size(); ++k)
    for (std::size_t i = 0; i < points.size(); ++i) {
      const UnitTerm unit = unit_term(alphas[k], points[i].pair);
      columns.stress(i, k) = points[i].weight * unit.stress;
      columns.by_alpha(i, k) = points[i].weight * unit.by_alpha;
    }
  return columns;
}

Eigen::VectorXd weighted_stress(const std::vector<WeightedPoint>& points) {
  Eigen::VectorXd data(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) data(i) = points[i].weight * points[i].stress;
  return data;
}

// Huber's problem has one minimum at given exponents; Cauchy's may have several, and the one that is reached from
// Huber's is taken.
Moduli best_moduli(const Eigen::MatrixXd& columns, const Eigen::VectorXd& data, Signs signs, const ScaledLoss& loss) {
  Moduli moduli = least_squares(columns, data, signs);
  if (loss.loss == Loss::squares) return moduli;
  moduli = reweighted(columns, data, signs, {Loss::huber, loss.scale}, moduli);
  return loss.loss == Loss::cauchy ? reweighted(columns, data, signs, loss, moduli) : moduli;
}

}  // namespace percal
