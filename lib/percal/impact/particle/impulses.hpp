// How a rigid body of so many velocities meets the nodes that it touches: what RigidBody and its sister in three dimensions share. A body says
//   Velocities               a vector of its velocities
//   inverse_mass()           what takes impulses to velocities
//   lever(touch)             what a touch's rate gains from each velocity
//   sliding_lever(touch)     the same of the velocity along the surface
//   may_slide(touch)         whether friction has a direction
//   whole()                  how columns are summed: sum_of_columns()
// docs/theory/impact.md, "Contact"
#pragma once
#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

#include "percal/impact/particle/touch.hpp"

namespace percal {

// What impulses do to a body.
template <class Body>
struct ImpulseChange {
  typename Body::Velocities velocity, impulse;
  double lost;  // kinetic energy of body and nodes
};

// How hard it is to part a node from a body that does not move.
inline double stiffness_of(const Touch& touch) { return touch.mass / touch.steepness(); }

template <class Body>
struct ColumnOfTouches {
  using Vector = typename Body::Velocities;
  using Matrix = Eigen::Matrix<double, Vector::RowsAtCompileTime, Vector::RowsAtCompileTime>;
  Matrix per_velocity = Matrix::Zero();
  Vector at_rest = Vector::Zero();
  ColumnOfTouches& operator+=(const ColumnOfTouches& other) {
    per_velocity += other.per_velocity;
    at_rest += other.at_rest;
    return *this;
  }
};

inline constexpr int most_rounds = 20;

// Impulses some of which follow the body's motion: all at first, and then those that do after it has changed, until these stay the same.
// add(touch, follows, q, column) adds what a touch says to its column's sum, follows(touch, q) whether it does; q, the change of the
// body's velocities, is -W (sum per velocity . q + sum at rest).
template <class Body>
struct Settled {
  typename Body::Velocities q = Body::Velocities::Zero(), impulse = Body::Velocities::Zero();
  std::vector<char> following;
};
template <class Body, class Add, class Follows>
Settled<Body> settle(const Body& body, const std::vector<Touch>& touches, ContactColumns among, const Add& add,
                     const Follows& follows) {
  using Column = ColumnOfTouches<Body>;
  const auto W = body.inverse_mass();
  Settled<Body> settled{.following = std::vector<char>(touches.size(), 1)};
  std::vector<Column> columns;
  bool changed = !touches.empty();
  for (int round = 0; round < most_rounds && changed; ++round) {
    columns.assign(among.end - among.begin, {});
    for (std::size_t k = 0; k < touches.size(); ++k)
      add(touches[k], static_cast<bool>(settled.following[k]), settled.q, columns[touches[k].column - among.begin]);
    const Column sum = sum_of_columns(columns, body.whole());
    settled.q = -(Column::Matrix::Identity() + W * sum.per_velocity).inverse() * (W * sum.at_rest);
    settled.impulse = -(sum.per_velocity * settled.q + sum.at_rest);
    changed = false;
    for (std::size_t k = 0; k < touches.size(); ++k) {
      const char now = static_cast<char>(follows(touches[k], settled.q));
      changed |= now != settled.following[k];
      settled.following[k] = now;
    }
  }
  return settled;
}

// With W the inverse masses, m_k = stiffness_of and J_k the levers: q = -W sum_k J_k p_k, p_k = m_k (rate_k + J_k . q) where
// positive, else 0. `before`: the body's velocities.
template <class Body>
ImpulseChange<Body> part_touches(const Body& body, std::vector<Touch>& touches, ContactColumns among,
                                 const typename Body::Velocities& before) {
  using Vector = typename Body::Velocities;
  // Whoever parts by itself, once the body has slowed down, needs no impulse.
  const auto add = [&](const Touch& touch, bool pushes, const Vector&, ColumnOfTouches<Body>& column) {
    if (!pushes) return;
    const Vector J = body.lever(touch);
    column.per_velocity += stiffness_of(touch) * J * J.transpose();
    column.at_rest += stiffness_of(touch) * touch.rate * J;
  };
  const auto needs_impulse = [&](const Touch& touch, const Vector& q) {
    return touch.rate + body.lever(touch).dot(q) > 0;
  };
  const auto [q, impulse, pushes] = settle(body, touches, among, add, needs_impulse);
  const Vector middle = before + 0.5 * q;
  double lost = 0;
  for (std::size_t k = 0; k < touches.size(); ++k) {
    Touch& touch = touches[k];
    const Vector J = body.lever(touch);
    touch.impulse = pushes[k] ? std::max(0.0, stiffness_of(touch) * (touch.rate + J.dot(q))) : 0;
    lost -= touch.impulse * (touch.mean_velocity() - J.dot(middle));
  }
  return {q, impulse, lost};
}

// With L_k the levers along the surface and s_k the velocity of the body's surface over the node's: q = -W sum_k L_k j_k, j_k = m_k
// (s_k + L_k . q) where that is no more than the bound, else the bound with its sign. Who sticks is found as who pushes is in
// part_touches().
template <class Body>
ImpulseChange<Body> rub_touches(const Body& body, std::vector<Touch>& touches, ContactColumns among, double coefficient,
                                const typename Body::Velocities& before) {
  using Vector = typename Body::Velocities;
  using Column = ColumnOfTouches<Body>;
  const auto sliding = [&](const Touch& touch, const Vector& q) {
    return body.sliding_lever(touch).dot(before + q) - touch.along_now;
  };
  const auto braked = [&](const Touch& touch, const Vector& q) {
    const double bound = coefficient * touch.impulse;
    return std::clamp(touch.mass * sliding(touch, q), -bound, bound);
  };
  const auto sticks = [&](const Touch& touch, const Vector& q) {
    return std::abs(touch.mass * sliding(touch, q)) <= coefficient * touch.impulse;
  };
  const auto slides = [&](const Touch& touch) { return touch.impulse != 0 && body.may_slide(touch); };
  const auto add = [&](const Touch& touch, bool stuck, const Vector& q, Column& column) {
    if (!slides(touch)) return;
    const Vector L = body.sliding_lever(touch);
    if (stuck) column.per_velocity += touch.mass * L * L.transpose();
    column.at_rest += (stuck ? touch.mass * sliding(touch, Vector::Zero()) : braked(touch, q)) * L;
  };
  const Vector q = settle(body, touches, among, add, sticks).q;
  // What the nodes get, and just as much from the body.
  std::vector<Column> columns(among.end - among.begin);
  for (Touch& touch : touches) {
    touch.rub = slides(touch) ? braked(touch, q) : 0;
    columns[touch.column - among.begin].at_rest += touch.rub * body.sliding_lever(touch);
  }
  const Vector taken = sum_of_columns(columns, body.whole()).at_rest, change = -(body.inverse_mass() * taken),
               middle = before + 0.5 * change;
  double lost = 0;
  for (const Touch& touch : touches) lost -= touch.rub * (touch.mean_sliding() - body.sliding_lever(touch).dot(middle));
  return {change, -taken, lost};
}

}  // namespace percal
