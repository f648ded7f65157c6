// Contact without springs: nodes that a step would leave inside the particle are kept at its surface by impulses between
// the two. Each takes as much from the particle as it gives to the node. docs/theory/impact.md, "Contact".
#pragma once
#include <array>
#include <vector>

#include "percal/impact/kernel/kernel.hpp"

namespace percal {

// One node at the surface. Positions and velocities with z downwards. y, across the plane in which a body turns and moves, is that of
// three dimensions; elsewhere it is 0.
struct Touch {
  int column = 0;
  long node = 0;
  double mass = 0;
  double x = 0, y = 0, z = 0;     // at the end of the step
  double from_x = 0, from_z = 0;  // at its beginning
  // Outward: how fast the gap closes for each of the node's velocities. Of length 1, but where two sides are as near.
  double away_x = 0, away_y = 0, away_z = 0;
  double rate = 0;     // at which it has to part from the particle, more than it does now
  double before = 0;   // the node's own velocity along `away` before the step's forces
  double now = 0;      // the same after them
  double impulse = 0;  // along `away`, not negative

  // Friction's. Of length 1, across `away`; 0 where the node cannot slide, on the axis, and where there is no friction.
  double along_x = 0, along_y = 0, along_z = 0;
  double along_before = 0, along_now = 0;  // as before and now, along `along`
  double rub = 0;                          // impulse along it, of either sign

  double steepness() const { return away_x * away_x + away_y * away_y + away_z * away_z; }
  // Its own velocity along `away` in the middle of the step, once it has its impulse.
  double mean_velocity() const { return 0.5 * (before + now + steepness() * impulse / mass); }
  double mean_sliding() const { return 0.5 * (along_before + along_now + rub / mass); }
};

// Columns of nodes that are looked at for contact.
struct ContactColumns {
  int begin = 0, end = 0;
};

// Velocities of a rigid body, or what changes them.
struct BodyMotion {
  double down = 0, right = 0, spin = 0;  // spin anticlockwise
};

// A rigid body's inverse masses, 0 where it is held, and its centre of mass.
struct RigidBody {
  BodyMotion inverse_mass;
  double x = 0, z = 0;
  bool whole = false;  // both sides of x = 0 are there: sums are taken in pairs of columns

  // Finds the impulses that part every touch at its rate or faster while they slow the body down. Changes `motion`
  // accordingly and returns the kinetic energy that body and nodes lose. Touches are in the order of their columns.
  double part(std::vector<Touch>& touches, ContactColumns columns, BodyMotion& motion) const;

  // Behind part(): the impulses along the surface that stop each touch from sliding, or brake it with `coefficient` times its
  // impulse across where that is less. Changes `motion` accordingly and returns the kinetic energy that body and nodes lose.
  double rub(std::vector<Touch>& touches, ContactColumns columns, double coefficient, BodyMotion& motion) const;
};

// Sums columns from the outermost inwards; those of a whole mesh in pairs, left and right, so that the mirrored scene
// has the mirrored sum to the last bit, and half a model has half of it.
template <class Sum>
Sum sum_of_columns(const std::vector<Sum>& columns, bool whole) {
  Sum sum{};
  if (!whole) {
    for (auto column = columns.rbegin(); column != columns.rend(); ++column) sum += *column;
    return sum;
  }
  for (std::size_t left = 0, right = columns.size(); left < right--; ++left) {
    Sum pair = columns[left];
    if (left < right) pair += columns[right];
    sum += pair;
  }
  return sum;
}

// Gives the nodes their impulses, and moves them on by what these change over `drift`.
template <class Real>
void push_nodes(const FieldsView<Real>& fields, const std::vector<Touch>& touches, double drift) {
  for (const Touch& touch : touches) {
    if (touch.impulse == 0) continue;
    const double x = touch.impulse / touch.mass * touch.away_x + touch.rub / touch.mass * touch.along_x;
    const double z = touch.impulse / touch.mass * touch.away_z + touch.rub / touch.mass * touch.along_z;
    fields.v_r[touch.node] += static_cast<Real>(x);
    fields.v_z[touch.node] += static_cast<Real>(z);
    fields.u_r[touch.node] += static_cast<Real>(x * drift);
    fields.u_z[touch.node] += static_cast<Real>(z * drift);
  }
}

}  // namespace percal
