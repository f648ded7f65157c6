#include "percal/impact/particle/touch.hpp"

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>

namespace percal {
namespace {

using Vector = Eigen::Vector3d;  // down, right, spin

// What a touch's rate gains from each velocity of the body.
Vector lever_of(const Touch& touch, const RigidBody& body) {
  return {touch.away_z, touch.away_x, touch.away_x * (touch.z - body.z) - touch.away_z * (touch.x - body.x)};
}

// How hard it is to part a node from a body that does not move.
double stiffness_of(const Touch& touch) {
  return touch.mass / touch.steepness();
}

struct Column {
  Eigen::Matrix3d per_velocity = Eigen::Matrix3d::Zero();
  Vector at_rest = Vector::Zero();
  Column& operator+=(const Column& other) {
    per_velocity += other.per_velocity;
    at_rest += other.at_rest;
    return *this;
  }
};

// Whoever parts by itself, once the body has slowed down, needs no impulse.
constexpr int most_rounds = 20;

}  // namespace

// With W the inverse masses, m_k = stiffness_of and J_k the levers: q = -W sum_k J_k p_k, p_k = m_k (rate_k + J_k . q) where
// positive, else 0.
double RigidBody::part(std::vector<Touch>& touches, ContactColumns among, BodyMotion& motion) const {
  const Vector W{inverse_mass.down, inverse_mass.right, inverse_mass.spin};
  std::vector<char> pushes(touches.size(), 1);
  std::vector<Column> columns;
  Vector q = Vector::Zero();
  bool changed = !touches.empty();
  for (int round = 0; round < most_rounds && changed; ++round) {
    columns.assign(among.end - among.begin, {});
    for (std::size_t k = 0; k < touches.size(); ++k) {
      if (!pushes[k]) continue;
      const Vector J = lever_of(touches[k], *this);
      Column& column = columns[touches[k].column - among.begin];
      column.per_velocity += stiffness_of(touches[k]) * J * J.transpose();
      column.at_rest += stiffness_of(touches[k]) * touches[k].rate * J;
    }
    const Column sum = sum_of_columns(columns, whole);
    q = -(Eigen::Matrix3d::Identity() + W.asDiagonal() * sum.per_velocity).inverse() * (W.asDiagonal() * sum.at_rest);
    changed = false;
    for (std::size_t k = 0; k < touches.size(); ++k) {
      const bool needed = touches[k].rate + lever_of(touches[k], *this).dot(q) > 0;
      changed |= needed != static_cast<bool>(pushes[k]);
      pushes[k] = static_cast<char>(needed);
    }
  }
  const Vector middle = Vector{motion.down, motion.right, motion.spin} + 0.5 * q;
  double lost = 0;
  for (std::size_t k = 0; k < touches.size(); ++k) {
    Touch& touch = touches[k];
    const Vector J = lever_of(touch, *this);
    touch.impulse = pushes[k] ? std::max(0.0, stiffness_of(touch) * (touch.rate + J.dot(q))) : 0;
    lost -= touch.impulse * (touch.mean_velocity() - J.dot(middle));
  }
  motion = {motion.down + q[0], motion.right + q[1], motion.spin + q[2]};
  return lost;
}

}  // namespace percal
