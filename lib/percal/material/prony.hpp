// A modulus that relaxes: mu(t) = mu (1 - sum_k g_k (1 - exp(-t/tau_k))), mu the instantaneous one.      docs/theory/relaxation.md
#pragma once
#include <Eigen/Core>
#include <vector>

namespace percal {

struct PronyTerm {
  double share;  // g_k
  double time;   // tau_k: s in a scene, radii at impact speed in a problem
  bool operator==(const PronyTerm&) const = default;
};
struct PronySeries {
  std::vector<PronyTerm> terms;
  bool operator==(const PronySeries&) const = default;
};

inline constexpr std::size_t most_relaxation_terms = 3;

// Of the instantaneous modulus: what is left after a time (not negative), and what is left for good.
double share_left(const PronySeries& series, double time);
double lasting_share(const PronySeries& series);
// The derivatives of ln share_left: with respect to each g_k, then to each ln tau_k; and to ln of the time.
struct ShareSlopes {
  Eigen::RowVectorXd by_parameter;
  double by_log_elapsed = 0;
};
ShareSlopes share_slopes(const PronySeries& series, double time);

// One step of h(t) = integral of exp(-(t - s)/tau) dS/ds ds, exact where S changes linearly over it:
//   h <- decay h + taken (S_new - S_old)                                                                (4)
// and the derivatives of both with respect to ln tau. An elapsed time of 0 is a jump: decay 1, taken 1.
struct HereditaryStep {
  double decay, taken;
  double decay_slope, taken_slope;
};
HereditaryStep hereditary_step(double elapsed, double time);

}  // namespace percal
