#include "percal/impact/particle/touch.hpp"

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace percal {
namespace {

using Vector = Eigen::Vector3d;  // down, right, spin

// What a touch's rate gains from each velocity of the body.
Vector lever(const Touch& touch, double x, double z, const RigidBody& body) {
  return {z, x, x * (touch.z - body.z) - z * (touch.x - body.x)};
}
Vector lever_of(const Touch& touch, const RigidBody& body) { return lever(touch, touch.away_x, touch.away_z, body); }
Vector sliding_lever_of(const Touch& touch, const RigidBody& body) {
  return lever(touch, touch.along_x, touch.along_z, body);
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

Vector inverse_mass_of(const RigidBody& body) {
  return {body.inverse_mass.down, body.inverse_mass.right, body.inverse_mass.spin};
}

constexpr int most_rounds = 20;

// Impulses some of which follow the body's motion: all at first, and then those that do after it has changed, until these stay the same.
// add(touch, follows, q, column) adds what a touch says to its column's sum, follows(touch, q) whether it does; q, the change of the
// body's velocities, is -W (sum per velocity . q + sum at rest).
struct Settled {
  Vector q = Vector::Zero();
  std::vector<char> following;
};
template <class Add, class Follows>
Settled settle(const RigidBody& body, const std::vector<Touch>& touches, ContactColumns among, const Add& add,
               const Follows& follows) {
  const Vector W = inverse_mass_of(body);
  Settled settled{.following = std::vector<char>(touches.size(), 1)};
  std::vector<Column> columns;
  bool changed = !touches.empty();
  for (int round = 0; round < most_rounds && changed; ++round) {
    columns.assign(among.end - among.begin, {});
    for (std::size_t k = 0; k < touches.size(); ++k)
      add(touches[k], static_cast<bool>(settled.following[k]), settled.q, columns[touches[k].column - among.begin]);
    const Column sum = sum_of_columns(columns, body.whole);
    settled.q = -(Eigen::Matrix3d::Identity() + W.asDiagonal() * sum.per_velocity).inverse() * (W.asDiagonal() * sum.at_rest);
    changed = false;
    for (std::size_t k = 0; k < touches.size(); ++k) {
      const char now = static_cast<char>(follows(touches[k], settled.q));
      changed |= now != settled.following[k];
      settled.following[k] = now;
    }
  }
  return settled;
}

}  // namespace

// With W the inverse masses, m_k = stiffness_of and J_k the levers: q = -W sum_k J_k p_k, p_k = m_k (rate_k + J_k . q) where
// positive, else 0.
double RigidBody::part(std::vector<Touch>& touches, ContactColumns among, BodyMotion& motion) const {
  // Whoever parts by itself, once the body has slowed down, needs no impulse.
  const auto add = [&](const Touch& touch, bool pushes, const Vector&, Column& column) {
    if (!pushes) return;
    const Vector J = lever_of(touch, *this);
    column.per_velocity += stiffness_of(touch) * J * J.transpose();
    column.at_rest += stiffness_of(touch) * touch.rate * J;
  };
  const auto needs_impulse = [&](const Touch& touch, const Vector& q) { return touch.rate + lever_of(touch, *this).dot(q) > 0; };
  const auto [q, pushes] = settle(*this, touches, among, add, needs_impulse);
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

// With L_k the levers along the surface and s_k the velocity of the body's surface over the node's: q = -W sum_k L_k j_k, j_k = m_k
// (s_k + L_k . q) where that is no more than the bound, else the bound with its sign. Who sticks is found as who pushes is in part().
double RigidBody::rub(std::vector<Touch>& touches, ContactColumns among, double coefficient, BodyMotion& motion) const {
  const Vector V{motion.down, motion.right, motion.spin};
  const auto sliding = [&](const Touch& touch, const Vector& q) {
    return sliding_lever_of(touch, *this).dot(V + q) - touch.along_now;
  };
  const auto braked = [&](const Touch& touch, const Vector& q) {
    const double bound = coefficient * touch.impulse;
    return std::clamp(touch.mass * sliding(touch, q), -bound, bound);
  };
  const auto sticks = [&](const Touch& touch, const Vector& q) {
    return std::abs(touch.mass * sliding(touch, q)) <= coefficient * touch.impulse;
  };
  const auto slides = [](const Touch& touch) { return touch.impulse != 0 && (touch.along_x != 0 || touch.along_z != 0); };
  const auto add = [&](const Touch& touch, bool stuck, const Vector& q, Column& column) {
    if (!slides(touch)) return;
    const Vector L = sliding_lever_of(touch, *this);
    if (stuck) column.per_velocity += touch.mass * L * L.transpose();
    column.at_rest += (stuck ? touch.mass * sliding(touch, Vector::Zero()) : braked(touch, q)) * L;
  };
  const Vector q = settle(*this, touches, among, add, sticks).q;
  // What the nodes get, and just as much from the body.
  std::vector<Column> columns(among.end - among.begin);
  for (Touch& touch : touches) {
    touch.rub = slides(touch) ? braked(touch, q) : 0;
    columns[touch.column - among.begin].at_rest += touch.rub * sliding_lever_of(touch, *this);
  }
  const Vector change = -(inverse_mass_of(*this).asDiagonal() * sum_of_columns(columns, whole).at_rest), middle = V + 0.5 * change;
  double lost = 0;
  for (const Touch& touch : touches)
    lost -= touch.rub * (touch.mean_sliding() - sliding_lever_of(touch, *this).dot(middle));
  motion = {V[0] + change[0], V[1] + change[1], V[2] + change[2]};
  return lost;
}

}  // namespace percal
