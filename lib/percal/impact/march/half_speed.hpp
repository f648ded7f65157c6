// How deep the tip was when the particle had half of its speed left.                docs/theory/field_measures.md
#pragma once
#include "percal/problem/problem.hpp"

namespace percal {

// Velocities belong to the middles of steps, and so do the depths taken here; between two of them the speed is linear in the depth.
class HalfSpeedDepth {
 public:
  explicit HalfSpeedDepth(const Problem& problem)
      : wanted_(0.5 * problem.speed_factor), before_{0, problem.speed_factor} {}

  // The particle moved from one tip position to another at this speed.
  void moved(double tip_before, double tip, double speed) {
    const Sample now{0.5 * (tip_before + tip), speed};
    if (depth_ == 0 && speed <= wanted_)
      depth_ = before_.depth + (now.depth - before_.depth) * (before_.speed - wanted_) / (before_.speed - speed);
    before_ = now;
  }

  double depth() const { return depth_; }  // 0: it has more

 private:
  struct Sample {
    double depth, speed;
  };
  const double wanted_;
  Sample before_;
  double depth_ = 0;
};

}  // namespace percal
