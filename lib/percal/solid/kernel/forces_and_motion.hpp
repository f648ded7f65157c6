// Forces, motion, contact and energies of one column of bricks or nodes, a group of lanes at a time. Compiled once for each
// instruction level (kernel_level.cpp).
#pragma once
#include "percal/impact/kernel/held_energy.hpp"
#include "percal/solid/kernel/brick_solid.hpp"
#include "percal/solid/kernel/kernel.hpp"

namespace percal::PERCAL_LEVEL::hex {

template <class V>
PERCAL_INLINE Tensor<V> gradient_of(const Modes<V>& x, const Modes<V>& y, const Modes<V>& z, RealOf<V> per_x,
                                    RealOf<V> per_y, V per_z) {
  using Real = RealOf<V>;
  return {x.x * per_x + Real(1), x.y * per_y, x.z * per_z, y.x * per_x,          y.y * per_y + Real(1),
          y.z * per_z,           z.x * per_x, z.y * per_y, z.z * per_z + Real(1)};
}

// Elements that are gone are computed as undeformed: their nodes may be anywhere, and no number times nothing is nothing.
template <class V, class Mask>
PERCAL_INLINE Tensor<V> where(Mask live, const Tensor<V>& F) {
  const V zero{}, one = broadcast<V>(RealOf<V>(1));
  return {select(live, F.xx, one),  select(live, F.xy, zero), select(live, F.xz, zero),
          select(live, F.yx, zero), select(live, F.yy, one),  select(live, F.yz, zero),
          select(live, F.zx, zero), select(live, F.zy, zero), select(live, F.zz, one)};
}

// The walk down one column of elements. What they are made of answers through `solid`: UniformBrick or LayeredBrick.
template <class Real, class Solid>
class ColumnWalk {
  using V = typename VectorOf<Real>::type;
  static constexpr int lanes = Lane<V>::count;

 public:
  PERCAL_INLINE ColumnWalk(Solid& solid, const SolidFields<Real>& fields, const std::array<long, 4>& nodes,
                           const SlabForces<Real>& forces, const BoxColumn& column, const RowHeights<Real>& rows,
                           double previous_step, ColumnReport& report)
      : solid_(solid),
        fields_(fields),
        nodes_(nodes),
        forces_(forces),
        rows_(rows),
        report_(report),
        base_(Real(column.width_x * column.width_y)),
        root3_(Real(__builtin_cbrt(column.width_x * column.width_y))),
        per_x_(Real(1 / column.width_x)),
        per_y_(Real(1 / column.width_y)),
        again_(!(previous_step > 0)),
        per_step_(again_ ? Real(0) : Real(1 / previous_step)) {}

  PERCAL_INLINE void over(Rows rows) {
    for (int k = rows.begin; k < rows.end; k += lanes) {
      const V state = load<V>(fields_.alive + nodes_[0] + k);
      if (any(state > Real(0))) {
        take_group(k, state);
        ++report_.groups;
      } else {
        close_nodes(k);
      }
    }
    close_nodes(rows.end);
    report_.viscous_work += lane_sum(work_);
    const double inverse_step = static_cast<double>(lane_largest(steepest_)),
                 least = static_cast<double>(lane_smallest(tightest_));
    if (inverse_step > report_.largest_inverse_step) report_.largest_inverse_step = inverse_step;
    if (least < report_.smallest_jacobian) report_.smallest_jacobian = least;
  }

 private:
  PERCAL_INLINE Modes<V> gather(int component, int k) const {
    const Real* u = fields_.u[component] + k;
    Corners8<V> corners;
    for (int c = 0; c < 4; ++c) {
      corners.upper[c] = load<V>(u + nodes_[c]);
      corners.lower[c] = load<V>(u + nodes_[c] + 1);
    }
    return modes_of(corners);
  }

  PERCAL_INLINE void take_group(int k, V state) {
    const V zero{};
    auto live = state > Real(0);
    const auto& material = solid_.at(k);
    // Gather.
    const Modes<V> x = gather(0, k), y = gather(1, k), z = gather(2, k);
    const V per_z = load<V>(rows_.per_height + k), volume = base_ * load<V>(rows_.height + k);
    const Real quarter_x = Real(0.25) * per_x_, quarter_y = Real(0.25) * per_y_;
    const V quarter_z = Real(0.25) * per_z;
    Tensor<V> F = hex::gradient_of(x, y, z, quarter_x, quarter_y, quarter_z);
    F = where(live, F);
    solid_.add_initial_stretch(F);

    // Compute.
    const Deformation<V> d = deformation_of(F);
    const Powers<V> g = powers_of(d.spectrum, d.mean, material.alpha);
    const Symmetric<V> isochoric =
        isochoric_kirchhoff(d.B, d.B2, d.trace_of_square, d.spectrum, g, material.two_mu_over_alpha);
    const long element = nodes_[0] + k;
    const V old_jacobian = load<V>(fields_.jacobian + element),
            old_viscous = load<V>(fields_.viscous_pressure + element);
    const V closing = larger((old_jacobian - d.jacobian) * per_step_ * d.inverse_jacobian, zero);  // -tr D
    const V length = root3_ * load<V>(rows_.root3 + k);
    const V damping = length * (material.linear_viscosity + material.quadratic_viscosity * length * closing);
    V q = again_ ? old_viscous : damping * closing;
    const V pressure = kirchhoff_pressure(PressureLaw::log_quadratic, d.jacobian, material.bulk);
    Symmetric<V> tau = isochoric;
    solid_.add_further_stress(F, d, tau);
    const V whole = pressure - q * d.jacobian;
    Tensor<V> P = first_piola(plus(tau, whole), d);
    const Real per_x2 = per_x_ * per_x_, per_y2 = per_y_ * per_y_;
    const V per_z2 = per_z * per_z;
    const StepBound<V> bound = solid_.bound_of_step(d, isochoric, V(g.sum() * Real(1.0 / 3)), per_x2, per_y2, per_z2);
    const V drag = damping * d.jacobian * bound.over_stretch;
    const V inverse_step = solid_.inverse_step(bound, drag);

    // Erode, judged half a step ahead: impact/kernel/internal_forces.hpp.
    const V now = solid_.erosion_measure(d, g, plus(tau, pressure)),
            change = now - load<V>(fields_.erosion_measure + element);
    store(fields_.erosion_measure + element, now);
    const auto at_limit = beyond_own_limit(now, change, material.erosion_limit);
    auto gone = live & (at_limit | (d.unbounded_jacobian < material.smallest_jacobian) |
                        (inverse_step > material.largest_inverse_step));
    if (again_) gone = gone & ~gone;
    const V lost = solid_.per_mesh_volume(V(volume * Real(0.5) * (old_jacobian - d.jacobian)));
    if (__builtin_expect(any(gone), 0)) {
      const V why = select(at_limit, broadcast<V>(Real(-1)), broadcast<V>(Real(-2)));
      store(fields_.alive + element, select(gone, why, state));
      report_.doomed += static_cast<int>(lane_sum(select(gone, broadcast<V>(Real(1)), zero)));
      work_ += select(gone, lost * old_viscous, zero);
      live = live & ~gone;
    }
    q = select(live, q, zero);
    steepest_ = larger(steepest_, select(live, inverse_step, zero));
    tightest_ = smaller(tightest_, select(live, d.unbounded_jacobian, broadcast<V>(Real(1e30))));
    work_ += select(live, lost * (old_viscous + q), zero);
    store(fields_.jacobian + element, d.jacobian);
    store(fields_.viscous_pressure + element, q);

    solid_.refer_to_mesh(P);
    // Scatter.
    const V share = select(live, volume, zero);
    const HourglassStiffness<V> spring = hex::hourglass_stiffness(material.hourglass * share, per_x2, per_y2, per_z2);
    const V to_x = share * quarter_x, to_y = share * quarter_y, to_z = share * quarter_z;
    const auto amplitudes = [&](const Modes<V>& m, V along_x, V along_y, V along_z) {
      return Modes<V>{along_x * to_x,   along_y * to_y,   along_z * to_z,    m.xy * spring.xy,
                      m.xz * spring.xz, m.yz * spring.yz, m.xyz * spring.xyz};
    };
    scatter(0, k, corner_forces(amplitudes(x, P.xx, P.xy, P.xz)));
    scatter(1, k, corner_forces(amplitudes(y, P.yx, P.yy, P.yz)));
    scatter(2, k, corner_forces(amplitudes(z, P.zx, P.zy, P.zz)));
  }

  PERCAL_INLINE void scatter(int component, int k, const Corners8<V>& f) {
    V given[4];
    for (int c = 0; c < 4; ++c) {
      given[c] = f.upper[c] + shifted(f.lower[c], lower_[component][c]);
      lower_[component][c] = f.lower[c];
    }
    give(component, k, given);
  }

  // To the nodes (i, j), (i + 1, j), (i, j + 1), (i + 1, j + 1).
  PERCAL_INLINE void give(int component, int k, const V (&given)[4]) const {
    const Real* before = forces_.from_before[component];
    const V inner = before ? load<V>(before + k) + given[0] : given[0];
    Real* to_inner = forces_.inner[component] + k;
    store(to_inner, forces_.adds ? load<V>(to_inner) + inner : inner);
    Real* to_outer = forces_.outer[component] + k;
    store(to_outer, forces_.outer_adds ? load<V>(to_outer) + given[1] : given[1]);
    store(forces_.to_next[component] + k, given[2]);
    store(forces_.outer_next[component] + k, given[3]);
  }

  // Nodes from row k on to which only the rows before give something.
  PERCAL_INLINE void close_nodes(int k) {
    for (int component = 0; component < 3; ++component) {
      V given[4];
      for (int c = 0; c < 4; ++c) {
        given[c] = first_lane<V>(lower_[component][c][lanes - 1]);
        lower_[component][c] = V{};
      }
      give(component, k, given);
    }
  }

  Solid& solid_;
  const SolidFields<Real>& fields_;
  const std::array<long, 4> nodes_;
  const SlabForces<Real>& forces_;
  const RowHeights<Real> rows_;
  ColumnReport& report_;
  const Real base_, root3_, per_x_, per_y_;
  const bool again_;  // nothing has moved: what depends on rates is as it was
  const Real per_step_;
  V lower_[3][4] = {};  // what the rows before gave to their lower corners
  V work_{}, steepest_{}, tightest_ = broadcast<V>(Real(1e30));
};

template <class Real>
void internal_forces(const SolidFields<Real>& fields, const std::array<long, 4>& nodes, const SlabForces<Real>& forces,
                     Rows rows, const BoxColumn& column, const RowHeights<Real>& heights,
                     const MaterialConstants& material, double previous_step, ColumnReport& report) {
  UniformBrick<Real> solid(material);
  ColumnWalk(solid, fields, nodes, forces, column, heights, previous_step, report).over(rows);
}

template <class Real>
void internal_forces_layered(const SolidFields<Real>& fields, const std::array<long, 4>& nodes,
                             const SlabForces<Real>& forces, Rows rows, const BoxColumn& column,
                             const RowHeights<Real>& heights, const LayeredSolidView& view, double previous_step,
                             ColumnReport& report) {
  LayeredBrick<typename VectorOf<Real>::type> solid(view);
  ColumnWalk(solid, fields, nodes, forces, column, heights, previous_step, report).over(rows);
}

template <class Real>
void kick_and_drift(const SolidFields<Real>& fields, long first, Rows rows, std::array<bool, 3> held, double kick,
                    double drift) {
  using V = typename VectorOf<Real>::type;
  const Real dt = Real(drift);
  for (int component = 0; component < 3; ++component) {
    const Real by = held[component] ? Real(0) : Real(kick);
    Real *u = fields.u[component] + first, *v = fields.v[component] + first;
    const Real *f = fields.f[component] + first, *inverse_mass = fields.inverse_mass + first;
    for (int k = rows.begin; k < rows.end; k += Lane<V>::count) {
      const V now = load<V>(v + k) + (load<V>(f + k) * load<V>(inverse_mass + k)) * by;
      store(v + k, now);
      store(u + k, load<V>(u + k) + now * dt);
    }
  }
}

// Calls inside(x, y, z) with the position of each group of nodes from the centre, and lists the rows for which it says yes.
template <class Real, class Inside>
PERCAL_INLINE int list_nodes(const SolidFields<const Real>& fields, const ColumnNodes& nodes,
                             const std::array<double, 3>& centre, int* found, Inside inside) {
  using V = typename VectorOf<Real>::type;
  constexpr int lanes = Lane<V>::count;
  const Real* below = static_cast<const Real*>(nodes.below);
  int count = 0;
  for (int k = nodes.rows.begin; k < nodes.rows.end; k += lanes) {
    const V x = load<V>(fields.u[0] + nodes.first + k) + Real(nodes.x - centre[0]);
    const V y = load<V>(fields.u[1] + nodes.first + k) + Real(nodes.y - centre[1]);
    const V z = load<V>(fields.u[2] + nodes.first + k) + (load<V>(below + k) + Real(nodes.depth[k] - centre[2]));
    const auto is_in = inside(x, y, z) & (load<V>(fields.inverse_mass + nodes.first + k) > Real(0));
    if (!any(is_in)) continue;
    for (int l = 0; l < lanes; ++l)
      if (is_in[l]) found[count++] = k + l;
  }
  return count;
}

template <class Real>
int nodes_in_sphere(const SolidFields<const Real>& fields, const ColumnNodes& nodes,
                    const std::array<double, 3>& centre, int* found) {
  using V = typename VectorOf<Real>::type;
  return list_nodes(fields, nodes, centre, found, [](V x, V y, V z) { return x * x + y * y + z * z < Real(1); });
}

template <class Real>
int nodes_in_polyhedron(const SolidFields<const Real>& fields, const ColumnNodes& nodes, const PolyhedronFace* faces,
                        int face_count, double reach, const std::array<double, 3>& centre, int* found) {
  using V = typename VectorOf<Real>::type;
  constexpr double rounding = 1 + 1e-5;
  const Real farthest = Real(reach * reach * rounding);
  return list_nodes(fields, nodes, centre, found, [&](V x, V y, V z) {
    const auto near = x * x + y * y + z * z < farthest;
    if (!any(near)) return near;
    V least = broadcast<V>(Real(1e30));
    for (int k = 0; k < face_count; ++k) {
      const auto& n = faces[k].normal;
      least = smaller(least, Real(faces[k].offset) - (x * Real(n[0]) + y * Real(n[1]) + z * Real(n[2])));
    }
    return least > Real(0);
  });
}

template <class Real>
StoredEnergy stored_energy(const SolidFields<const Real>& fields, const std::array<long, 4>& nodes, int rows,
                           const BoxColumn& column, const RowHeights<Real>& heights, const LayeredSolidView& view) {
  using V = DoubleLanes::Vector;
  const double per_x = 1 / column.width_x, per_y = 1 / column.width_y, base = column.width_x * column.width_y;
  LayeredBrick<V> solid(view);
  V elastic{}, hourglass{};
  for (int k = 0; k < rows; k += DoubleLanes::count) {
    const auto live = in_double(fields.alive + nodes[0] + k) > 0.0;
    if (!any(live)) continue;
    const LayeredConstants<V>& material = solid.at(k);
    const auto modes = [&](const Real* u) {
      Corners8<V> corners;
      for (int c = 0; c < 4; ++c) {
        corners.upper[c] = in_double(u + nodes[c] + k);
        corners.lower[c] = in_double(u + nodes[c] + k + 1);
      }
      return modes_of(corners);
    };
    const Modes<V> x = modes(fields.u[0]), y = modes(fields.u[1]), z = modes(fields.u[2]);
    const V height = in_double(heights.height + k), per_z = 1.0 / height, volume = base * height;
    // Of a gradient over the mesh.
    const auto energy_of = [&](Tensor<V> F) {
      solid.add_initial_stretch(F);
      const Deformation<V> d = deformation_of(F);
      Symmetric<V> tau{};
      solid.add_further_stress(F, d, tau);
      return solid.per_mesh_volume(solid.energy(d, powers_of(d.spectrum, d.mean, material.alpha)));
    };
    V energy = energy_of(hex::gradient_of(x, y, z, 0.25 * per_x, 0.25 * per_y, 0.25 * per_z));
    if (view.is_stretched) energy -= energy_of(hex::gradient_of(Modes<V>{}, Modes<V>{}, Modes<V>{}, 0, 0, V{}));
    const HourglassStiffness<V> spring =
        hex::hourglass_stiffness(V(material.hourglass * volume), per_x * per_x, per_y * per_y, V(per_z * per_z));
    const auto sprung = [&](const Modes<V>& m) {
      return m.xy * m.xy * spring.xy + m.xz * m.xz * spring.xz + m.yz * m.yz * spring.yz + m.xyz * m.xyz * spring.xyz;
    };
    elastic += select(live, energy * volume, V{});
    hourglass += select(live, 0.5 * (sprung(x) + sprung(y) + sprung(z)), V{});
  }
  return {lane_sum(elastic), lane_sum(hourglass)};
}

}  // namespace percal::PERCAL_LEVEL::hex
