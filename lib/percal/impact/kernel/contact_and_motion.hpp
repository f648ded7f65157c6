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

// Calls inside(x, z) with the position of each group of nodes from the particle's centre, and lists the rows for which it
// says yes. Most groups are passed over with one look.
template <class Real, class Inside>
PERCAL_INLINE int list_nodes(const FieldsView<const Real>& fields, const ContactNodes& nodes, double centre_x,
                             double centre_z, int* found, Inside inside) {
  using V = typename VectorOf<Real>::type;
  constexpr int lanes = Lane<V>::count;
  const long start = static_cast<long>(nodes.column) * fields.stride;
  const Real *ur = fields.u_r + start, *uz = fields.u_z + start, *touchable = fields.touchable + start;
  const V below_first = depths_of_lanes<V>(nodes.row_height);
  int count = 0;
  for (int j = nodes.rows.begin; j < nodes.rows.end; j += lanes) {
    const V x = load<V>(ur + j) + static_cast<Real>(nodes.x - centre_x);
    const V z = load<V>(uz + j) + (below_first + static_cast<Real>(j * nodes.row_height - centre_z));
    const auto is_in = inside(x, z) & (load<V>(touchable + j) > Real(0));
    if (!any(is_in)) continue;
    for (int l = 0; l < lanes; ++l)
      if (is_in[l]) found[count++] = j + l;
  }
  return count;
}

template <class Real>
int nodes_in_sphere(const FieldsView<const Real>& fields, const ContactNodes& nodes, double centre, int* found) {
  using V = typename VectorOf<Real>::type;
  return list_nodes(fields, nodes, 0, centre, found, [](V x, V z) { return x * x + z * z < Real(1); });
}

// Behind all sides.
template <class Real>
int nodes_in_polygon(const FieldsView<const Real>& fields, const ContactNodes& nodes, const PolygonSide* sides,
                     int side_count, double centre_x, double centre_z, int* found) {
  using V = typename VectorOf<Real>::type;
  return list_nodes(fields, nodes, centre_x, centre_z, found, [&](V x, V z) {
    V least = broadcast<V>(Real(1e30));
    for (int k = 0; k < side_count; ++k)
      least = smaller(least,
                      Real(sides[k].offset) - (x * Real(sides[k].normal_x) + z * Real(sides[k].normal_z)));
    return least > Real(0);
  });
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
