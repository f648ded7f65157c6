#include "percal/powder/depth_table.hpp"

#include <algorithm>
#include <cmath>

namespace percal {
namespace {

constexpr double widest_step = 0.12;  // of a logarithm: cubics are then within 1e-4 of an emulator's ln depth
constexpr int most_nodes = 60, at_a_time = 64;

}  // namespace

ParticleBox box_of(std::span<const ParticleClass> classes) {
  ParticleBox box{classes.front().low, classes.front().low};
  for (const ParticleClass& one : classes)
    for (const PowderParticle& end : {one.low, one.high})
      for (double PowderParticle::*number :
           {&PowderParticle::radius, &PowderParticle::density, &PowderParticle::speed}) {
        box.low.*number = std::min(box.low.*number, end.*number);
        box.high.*number = std::max(box.high.*number, end.*number);
      }
  return box;
}

DepthTable::LogAxis DepthTable::axis_between(double low, double high) {
  const double width = std::log(high / low);
  if (!(width > 1e-12)) return {std::log(low), 1, 1};
  const int count = std::clamp(1 + static_cast<int>(std::ceil(width / widest_step)), 4, most_nodes);
  return {std::log(low), width / (count - 1), count};
}

// Lagrange's polynomial.
DepthTable::Weights DepthTable::weights(const LogAxis& axis, double value) {
  if (axis.count == 1) return {};
  const double along = (std::log(value) - axis.first) / axis.step;
  Weights found{std::clamp(static_cast<int>(std::floor(along)) - 1, 0, axis.count - 4), 4, {1, 1, 1, 1}};
  for (int k = 0; k < 4; ++k)
    for (int other = 0; other < 4; ++other)
      if (other != k) found.of[k] *= (along - found.first - other) / (k - other);
  return found;
}

DepthTable::DepthTable(const ForwardModel& model, const ParticleBox& box)
    : radius_(axis_between(box.low.radius, box.high.radius)),
      density_(axis_between(box.low.density, box.high.density)),
      speed_(axis_between(box.low.speed, box.high.speed)) {
  const auto node = [](const LogAxis& axis, int k) { return std::exp(axis.first + k * axis.step); };
  std::vector<PowderParticle> nodes;
  for (int r = 0; r < radius_.count; ++r)
    for (int d = 0; d < density_.count; ++d)
      for (int s = 0; s < speed_.count; ++s) nodes.push_back({node(radius_, r), node(density_, d), node(speed_, s)});
  for (std::size_t first = 0; first < nodes.size(); first += at_a_time) {
    const auto some = std::span(nodes).subspan(first, std::min<std::size_t>(at_a_time, nodes.size() - first));
    const Eigen::MatrixXd depths = model.log_depths(some);
    if (first == 0) values_.resize(depths.rows() + 1, static_cast<Eigen::Index>(nodes.size()));
    values_.middleCols(static_cast<Eigen::Index>(first), depths.cols()) << depths, model.errors(some).transpose();
  }
}

Eigen::MatrixXd DepthTable::at(std::span<const PowderParticle> particles) const {
  Eigen::MatrixXd found = Eigen::MatrixXd::Zero(values_.rows(), static_cast<Eigen::Index>(particles.size()));
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const Weights r = weights(radius_, particles[i].radius), d = weights(density_, particles[i].density),
                  s = weights(speed_, particles[i].speed);
    auto answer = found.col(static_cast<Eigen::Index>(i));
    for (int a = 0; a < r.count; ++a)
      for (int b = 0; b < d.count; ++b)
        for (int c = 0; c < s.count; ++c)
          answer += r.of[a] * d.of[b] * s.of[c] *
                    values_.col(((r.first + a) * density_.count + d.first + b) * speed_.count + s.first + c);
  }
  return found;
}

}  // namespace percal
