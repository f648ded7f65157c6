// The distribution of a prediction: for each point of a sample a Student distribution of one width about that point's own answer.
//                                                                                               docs/theory/prediction.md
#pragma once
#include <Eigen/Core>

namespace percal {

struct Mixture {
  Eigen::VectorXd centres;  // never empty; the first is the best
  double deviation = 0;     // scale of each about its centre, above 0
  double freedom = 0;       // degrees of freedom of each; 0: normal

  double share_below(double x) const;
  // The x below which a share lies, 0 < share < 1; not a number where the centres are not finite.
  double quantile(double share) const;
  // Root mean square distance of the centres from the first.
  double spread() const;
};

}  // namespace percal
