// What is summed over the residuals, and the moduli that make it least at given exponents: a linear problem of one to three
// unknowns.                                                                          docs/theory/curves.md (13), (21)
#pragma once
#include <Eigen/Core>
#include <limits>
#include <string>
#include <vector>

#include "percal/fit/search/curve_problem.hpp"

namespace percal {

// squares   r^2
// huber     r^2 up to s, then 2 s |r| - s^2
// cauchy    s^2 ln(1 + r^2/s^2)
enum class Loss { squares, huber, cauchy };

struct ScaledLoss {
  Loss loss = Loss::squares;
  double scale = 1;  // s
};

double loss_of(const ScaledLoss& loss, double residual);
// The weight that gives a residual's square the same slope: 1 for squares, at most 1.
double weight_of(const ScaledLoss& loss, double residual);

// s = 1.345 (Huber) or 2.385 (Cauchy) times the scatter of the residuals, which is 1.4826 times the median of their
// sizes: both keep 95 % of the least squares' efficiency for normal errors.
double scale_for(Loss loss, const Eigen::VectorXd& residuals);

std::string word(Loss loss);  // "squares", "huber", "cauchy"

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
