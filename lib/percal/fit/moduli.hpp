// The best moduli at given exponents: a linear problem of one to three unknowns.          docs/theory/curves.md (13)
#pragma once
#include <Eigen/Core>
#include <limits>
#include <vector>

#include "percal/fit/curve_problem.hpp"
#include "percal/fit/loss.hpp"

namespace percal {

// Whether every term's modulus has to be positive, which makes the solid stable, or may have any sign.
enum class Signs { positive, free };

// One column for each term: the weighted stresses of all points for mu = 1, and their derivatives with respect to
// alpha.
struct TermColumns {
  Eigen::MatrixXd stress;
  Eigen::MatrixXd by_alpha;
};
TermColumns term_columns(const std::vector<WeightedPoint>& points, const std::vector<double>& alphas);
Eigen::VectorXd weighted_stress(const std::vector<WeightedPoint>& points);

struct Moduli {
  Eigen::VectorXd mu;                                          // 0 for a term that is left out
  double objective = std::numeric_limits<double>::infinity();  // where no moduli are finite
};

// Moduli that make the sum of the loss of data - columns mu smallest. With positive signs a term that would be negative
// is left out (mu = 0), the best choice of terms taken; terms that the points cannot tell apart are never used
// together.
Moduli best_moduli(const Eigen::MatrixXd& columns, const Eigen::VectorXd& data, Signs signs, const ScaledLoss& loss);

}  // namespace percal
