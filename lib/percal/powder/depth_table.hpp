// Depths of many particles from a model that takes long for each: tabulated over ln radius, ln density and ln speed.
//                                                                                                  docs/theory/powder.md
#pragma once
#include <Eigen/Core>
#include <array>
#include <functional>
#include <span>
#include <vector>

#include "percal/powder/powder.hpp"

namespace percal {

// What is known of depths, at each of several points of the parameters, the best first.
struct ForwardModel {
  // Points in rows, particles in columns: ln of the mean depth of such particles, m.
  std::function<Eigen::MatrixXd(std::span<const PowderParticle>)> log_depths;
  // Of each particle: standard deviation of the model's own error of ln depth.
  std::function<Eigen::VectorXd(std::span<const PowderParticle>)> errors;
  double scatter = 0;  // standard deviation of ln depth of single particles about their mean
  double freedom = 0;  // degrees of freedom that tell it; 0: it is known
  // Whether the model has seen such particles; empty: it has seen all.
  std::function<bool(const PowderParticle&)> has_seen = {};
};

// Ends of the radii, densities and speeds.
struct ParticleBox {
  PowderParticle low, high;
};
ParticleBox box_of(std::span<const ParticleClass> classes);

class DepthTable {
 public:
  DepthTable(const ForwardModel& model, const ParticleBox& box);

  // Particles in columns; in rows ln depth at each point of the parameters, then the model's error.               (5)
  Eigen::MatrixXd at(std::span<const PowderParticle> particles) const;
  Eigen::Index points() const { return values_.rows() - 1; }

 private:
  // Nodes at even steps of a logarithm; one where every particle has the same.
  struct LogAxis {
    double first = 0, step = 0;
    int count = 1;
  };
  // Cubic through four neighbouring nodes.
  struct Weights {
    int first = 0, count = 1;
    std::array<double, 4> of{1};
  };
  static LogAxis axis_between(double low, double high);
  static Weights weights(const LogAxis& axis, double value);

  LogAxis radius_, density_, speed_;
  Eigen::MatrixXd values_;  // nodes in columns
};

}  // namespace percal
