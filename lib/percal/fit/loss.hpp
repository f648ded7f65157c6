// What is summed over the residuals.                                                      docs/theory/curves.md (21)
#pragma once
#include <Eigen/Core>
#include <string>

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

}  // namespace percal
