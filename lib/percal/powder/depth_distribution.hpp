// Where the particles of a powder end at one point of the parameters.                              docs/theory/powder.md
#pragma once
#include <Eigen/Core>
#include <span>
#include <variant>
#include <vector>

#include "percal/powder/powder.hpp"

namespace percal {

// Which particles bounce: none; those below an impact parameter (kg/(m s)); those whose mean depth is less than so many of their radii.
struct NoBounce {};
struct Breach {
  double impact_parameter = 7;  // Guha 2009, 2.2.2: of skin
};
struct LeastDepth {
  double radii = 2;  // the particle is just covered
};
using Bounce = std::variant<NoBounce, Breach, LeastDepth>;

enum class By { number, mass };

// Shares of all particles or of their mass over ln depth: even within bins of one width, before the scatter of single particles, which is
// normal.
class DepthDistribution {
 public:
  // Of each class the ln depth of its low and of its high end, m.
  DepthDistribution(std::span<const ParticleClass> classes, const Eigen::VectorXd& low, const Eigen::VectorXd& high,
                    const Bounce& bounce, double scatter);

  double bounced(By by) const { return bounced_[static_cast<int>(by)]; }
  // Of all: went in, and ended above this depth, m.                                                               (6)
  double above(By by, double depth) const;

  // Of those that end above a depth, m. NaN where nothing does.                                                   (7)
  struct Moments {
    double mean = 0, deviation = 0;
  };
  Moments moments_above(By by, double depth) const;
  // The depth above which this share of those lies that end above `depth`.
  double quantile_above(By by, double depth, double share) const;

 private:
  // Mean over each bin of the chance to stay below x, ln m.
  Eigen::ArrayXd chance_below(double x) const;
  void put(double low, double high, double number, double mass);

  double first_ = 0, width_ = 0;  // ln m
  Eigen::ArrayXd shares_[2];      // by number, by mass
  double bounced_[2] = {0, 0};
  double scatter_;
};

}  // namespace percal
