// Contact and motion of one column of nodes. Compiled once for each instruction level (kernel_level.cpp).
#pragma once
#include "percal/impact/kernel/internal_forces.hpp"

namespace percal::PERCAL_LEVEL {

template <class V>
PERCAL_INLINE V depths_of_lanes(double row_height) {
  V below_first;
  for (int l = 0; l < Lane<V>::count; ++l) below_first[l] = static_cast<RealOf<V>>(l * row_height);
  return below_first;
}

// A group of nodes gets its push, and the particle the opposite.
template <class V>
PERCAL_INLINE void push_apart(RealOf<V>* fr, RealOf<V>* fz, V push_r, V push_z, V stiffness, V gap,
                              ContactReport& report) {
  store(fr, load<V>(fr) + push_r);
  store(fz, load<V>(fz) + push_z);
  report.force += lane_sum(push_z);
  report.spring_energy += 0.5 * lane_sum(stiffness * gap * gap);
  const double deepest = static_cast<double>(lane_largest(gap));
  if (deepest > report.largest_gap) report.largest_gap = deepest;
}

// Frictionless penalty: a node inside the sphere by `gap` is pushed out along the radius with force stiffness gap.
template <class Real>
void sphere_contact(const FieldsView<const Real>& fields, const NodeForces<Real>& forces, const ContactNodes& nodes,
                    double centre, ContactReport& report) {
  using V = typename VectorOf<Real>::type;
  constexpr int lanes = Lane<V>::count;
  const long start = static_cast<long>(nodes.column) * fields.stride;
  const Real *ur = fields.u_r + start, *uz = fields.u_z + start, *stiffness = fields.contact_stiffness + start;
  Real *fr = forces.r + start, *fz = forces.z + start;
  const V below_first = depths_of_lanes<V>(nodes.row_height);
  const V zero{};
  for (int j = nodes.rows.begin; j < nodes.rows.end; j += lanes) {
    const V k = load<V>(stiffness + j);
    if (!any(k > Real(0))) continue;
    const V r = load<V>(ur + j) + static_cast<Real>(nodes.x);
    const V z = load<V>(uz + j) +
                (below_first + static_cast<Real>(j * nodes.row_height - centre));  // from the centre downwards
    const V distance2 = r * r + z * z;
    const auto touching = (distance2 < Real(1)) & (k > Real(0));
    if (!any(touching)) continue;
    const V distance = square_root(distance2 + Real(1e-20));
    const V gap = select(touching, Real(1) - distance, zero);
    const V push = k * gap / distance;
    const V push_z = push * z;
    push_apart(fr + j, fz + j, push * r, push_z, k, gap, report);
  }
}

// The same of a convex polygon: a node behind all sides is pushed out across the nearest one. Where two are as near,
// the push is along the mean of their normals, so that a tip pushes straight ahead.
template <class Real>
void polygon_contact(const FieldsView<const Real>& fields, const NodeForces<Real>& forces, const ContactNodes& nodes,
                     const PolygonSide* sides, int side_count, double centre_x, double centre_z,
                     ContactReport& report) {
  using V = typename VectorOf<Real>::type;
  constexpr int lanes = Lane<V>::count;
  const long start = static_cast<long>(nodes.column) * fields.stride;
  const Real *ur = fields.u_r + start, *uz = fields.u_z + start, *stiffness = fields.contact_stiffness + start;
  Real *fr = forces.r + start, *fz = forces.z + start;
  const V below_first = depths_of_lanes<V>(nodes.row_height);
  const V zero{}, one = broadcast<V>(Real(1));
  for (int j = nodes.rows.begin; j < nodes.rows.end; j += lanes) {
    const V k = load<V>(stiffness + j);
    if (!any(k > Real(0))) continue;
    const V x = load<V>(ur + j) + static_cast<Real>(nodes.x - centre_x);
    const V z = load<V>(uz + j) + (below_first + static_cast<Real>(j * nodes.row_height - centre_z));
    V gap = broadcast<V>(Real(1e30)), normal_x = zero, normal_z = zero, nearest = one;
    for (int side = 0; side < side_count; ++side) {
      const Real nx = Real(sides[side].normal_x), nz = Real(sides[side].normal_z), offset = Real(sides[side].offset);
      const V behind = offset - (x * nx + z * nz);
      const auto nearer = behind < gap, as_near = behind == gap;
      normal_x = select(nearer, broadcast<V>(nx), select(as_near, normal_x + nx, normal_x));
      normal_z = select(nearer, broadcast<V>(nz), select(as_near, normal_z + nz, normal_z));
      nearest = select(nearer, one, select(as_near, nearest + one, nearest));
      gap = select(nearer, behind, gap);
    }
    const auto touching = (gap > Real(0)) & (k > Real(0));
    if (!any(touching)) continue;
    gap = select(touching, gap, zero);
    const V push = k * gap / nearest, push_x = push * normal_x, push_z = push * normal_z;
    push_apart(fr + j, fz + j, push_x, push_z, k, gap, report);
    report.sideways -= lane_sum(push_x);
    report.torque += lane_sum(push_z * x - push_x * z);
  }
}

template <class Real>
void kick_and_drift(const FieldsView<Real>& fields, const NodeForces<Real>& forces, int column, Rows rows, bool held,
                    double kick, double drift) {
  using V = typename VectorOf<Real>::type;
  constexpr int lanes = Lane<V>::count;
  const long start = static_cast<long>(column) * fields.stride;
  Real *ur = fields.u_r + start, *uz = fields.u_z + start, *vr = fields.v_r + start, *vz = fields.v_z + start;
  const Real *fr = forces.r + start, *fz = forces.z + start, *inverse_mass = fields.inverse_mass + start;
  const Real kick_r = held ? Real(0) : Real(kick), kick_z = Real(kick), dt = Real(drift);
  for (int j = rows.begin; j < rows.end; j += lanes) {
    const V per_mass = load<V>(inverse_mass + j);
    const V r = load<V>(vr + j) + (load<V>(fr + j) * per_mass) * kick_r;
    const V z = load<V>(vz + j) + (load<V>(fz + j) * per_mass) * kick_z;
    store(vr + j, r);
    store(vz + j, z);
    store(ur + j, load<V>(ur + j) + r * dt);
    store(uz + j, load<V>(uz + j) + z * dt);
  }
}

}  // namespace percal::PERCAL_LEVEL
