// Forces of one column of elements, a group of lanes at a time. Compiled once for each instruction level
// (kernel_level.cpp).
#pragma once
#include "percal/impact/kernel/general_solid.hpp"
#include "percal/impact/kernel/uniform_solid.hpp"

namespace percal::PERCAL_LEVEL {

template <class V>
PERCAL_INLINE V first_lane(RealOf<V> x) {
  V v{};
  v[0] = x;
  return v;
}

// Corners: inner upper (node i, j), outer upper (i+1, j), outer lower (i+1, j+1), inner lower (i, j+1). What the solid
// is made of answers through `solid`: UniformSolid, AveragedSolid or GeneralSolid.
template <class Real, class Solid>
PERCAL_INLINE void forces_of_column(Solid& solid, const FieldsView<Real>& fields, const ColumnForces<Real>& forces,
                                    int column, Rows rows, const ColumnShape& shape, double previous_step,
                                    const StiffnessWatch& watch, ColumnReport& report) {
  using V = typename VectorOf<Real>::type;
  constexpr int lanes = Lane<V>::count;
  const long inner = static_cast<long>(column) * fields.stride, outer = inner + fields.stride;
  const Real *ur0 = fields.u_r + inner, *ur1 = fields.u_r + outer, *uz0 = fields.u_z + inner, *uz1 = fields.u_z + outer;
  Real *fr0 = forces.inner_r, *fr1 = forces.outer_r, *fz0 = forces.inner_z, *fz1 = forces.outer_z;
  Real *jacobian = fields.jacobian + inner, *viscous = fields.viscous_pressure + inner,
       *measure = fields.erosion_measure + inner, *alive = fields.alive + inner;
  const bool first = forces.first;

  const double area = shape.width * shape.height, volume = shape.thickness * area;
  const Real half_per_width = Real(0.5 / shape.width), half_per_height = Real(0.5 / shape.height);
  const Real quarter_per_radius = Real(0.25 * shape.per_radius);
  const Real to_r = Real(volume * 0.5 / shape.width), to_z = Real(volume * 0.5 / shape.height),
             to_hoop = Real(shape.per_radius > 0 ? 0.25 * area : 0);
  const InverseSides<Real> per{
      .width2 = Real(1 / (shape.width * shape.width)),
      .height2 = Real(1 / (shape.height * shape.height)),
      .hoop2 = Real((shape.at_axis ? axis_hoop_share : 1) * shape.per_radius * shape.per_radius / 4)};
  const Real length = Real(__builtin_sqrt(area));
  const bool again = !(previous_step > 0);  // nothing has moved: what depends on rates is as it was
  const Real per_step = again ? Real(0) : Real(1 / previous_step);
  const Real watched = Real(watch.inverse_step < largest_number ? watch.inverse_step : largest_number);

  const V zero{};
  // What the rows before gave to their lower corners.
  V lower_r0 = zero, lower_z0 = zero, lower_r1 = zero, lower_z1 = zero;
  V work = zero, steepest = zero, tightest = broadcast<V>(Real(1e30));

  for (int j = rows.begin; j < rows.end; j += lanes) {
    const V state = load<V>(alive + j);
    auto live = state > Real(0);
    if (!any(live)) {
      const V last_r0 = first_lane<V>(lower_r0[lanes - 1]), last_z0 = first_lane<V>(lower_z0[lanes - 1]);
      store(fr0 + j, first ? last_r0 : load<V>(fr0 + j) + last_r0);
      store(fz0 + j, first ? last_z0 : load<V>(fz0 + j) + last_z0);
      store(fr1 + j, first_lane<V>(lower_r1[lanes - 1]));
      store(fz1 + j, first_lane<V>(lower_z1[lanes - 1]));
      lower_r0 = lower_z0 = lower_r1 = lower_z1 = zero;
      continue;
    }
    const auto& material = solid.at(j);
    // Gather. Sums and differences over the diagonals give gradient and hourglass mode with few operations.
    const V ra = load<V>(ur0 + j), rb = load<V>(ur1 + j), rc = load<V>(ur1 + j + 1), rd = load<V>(ur0 + j + 1);
    const V za = load<V>(uz0 + j), zb = load<V>(uz1 + j), zc = load<V>(uz1 + j + 1), zd = load<V>(uz0 + j + 1);
    const V r_ac = rc - ra, r_bd = rb - rd, z_ac = zc - za, z_bd = zb - zd;
    Gradient<V> F;
    F.rr = (r_ac + r_bd) * half_per_width + Real(1);
    F.rz = (r_ac - r_bd) * half_per_height;
    F.zr = (z_ac + z_bd) * half_per_width;
    F.zz = (z_ac - z_bd) * half_per_height + Real(1);
    F.hoop = larger(((ra + rc) + (rb + rd)) * quarter_per_radius + Real(1), broadcast<V>(Real(1e-3)));
    solid.add_initial_stretch(F);
    const auto hourglass = solid.hourglass_force(j, (ra - rb) + (rc - rd), (za - zb) + (zc - zd));

    // Compute.
    const Stretches<V> s = stretches(F);
    const IsochoricPowers<V> g = isochoric_powers(F, s, material.alpha);
    const PrincipalStress<V> t = isochoric_stress(g, material.two_mu_over_alpha);
    const V old_jacobian = load<V>(jacobian + j), old_viscous = load<V>(viscous + j);
    const V closing = larger((old_jacobian - s.jacobian) * per_step * s.inverse_jacobian, zero);  // -tr D
    const V current_length = length * square_root(s.in_plane_jacobian);
    const V damping =
        current_length * (material.linear_viscosity + material.quadratic_viscosity * current_length * closing);
    V q = again ? old_viscous : damping * closing;
    Piola<V> P = first_piola(F, s, t, solid.volumetric_stress(s, q));
    solid.add_further_stress(j, F, s, t, P);

    const StepBound<V> bound = solid.bound_of_step(s, g, t, per);
    const V inverse_step = solid.inverse_step(bound, damping * s.jacobian * bound.over_stretch);

    // Erode. What decides is judged half a step ahead, so that on average an element goes neither early nor late.
    const V now = solid.erosion_measure(F, s, g, P, q), change = now - load<V>(measure + j);
    store(measure + j, now);
    const auto at_limit = solid.at_limit(j, state, now, change, again, report);
    auto gone = live & (at_limit | (s.unbounded_jacobian < material.smallest_jacobian) |
                        (inverse_step > material.largest_inverse_step));
    if (again) gone = gone & ~gone;  // who was judged is not judged again: nobody would take it out
    if (__builtin_expect(any(gone), 0)) {
      for (int l = 0; l < lanes; ++l)
        if (gone[l]) {
          alive[j + l] = at_limit[l] ? Real(-1) : Real(-2);
          ++report.doomed;
        }
      work += solid.per_mesh_volume(select(gone, Real(0.5) * old_viscous * (old_jacobian - s.jacobian), zero));
      live = live & ~gone;
    }
    solid.close_group(j, live, gone);
    q = select(live, q, zero);
    const V steep = select(live, inverse_step, zero);
    if (__builtin_expect(any(steep > watched), 0)) watch.flags[j / lanes] = 1;
    steepest = larger(steepest, steep);
    tightest = smaller(tightest, select(live, s.unbounded_jacobian, tightest));
    work += solid.per_mesh_volume(select(live, Real(0.5) * (old_viscous + q) * (old_jacobian - s.jacobian), zero));
    store(jacobian + j, s.jacobian);
    store(viscous + j, q);

    solid.refer_to_mesh(P);
    // Scatter. The hourglass force comes last everywhere, so that a mirrored scene has mirrored bits.
    const V rr = P.rr * to_r, rz = P.rz * to_z, zr = P.zr * to_r, zz = P.zz * to_z, hoop = P.hoop * to_hoop;
    const V sum_r = rr + rz, difference_r = rr - rz, sum_z = zr + zz, difference_z = zr - zz;
    const V upper_r0 = select(live, sum_r - hoop - hourglass.r, zero),
            upper_r1 = select(live, hourglass.r - (difference_r + hoop), zero);
    const V below_r1 = select(live, -sum_r - hoop - hourglass.r, zero),
            below_r0 = select(live, difference_r - hoop + hourglass.r, zero);
    const V upper_z0 = select(live, sum_z - hourglass.z, zero),
            upper_z1 = select(live, hourglass.z - difference_z, zero);
    const V below_z1 = select(live, -sum_z - hourglass.z, zero),
            below_z0 = select(live, difference_z + hourglass.z, zero);
    const V inner_r = upper_r0 + shifted(below_r0, lower_r0), inner_z = upper_z0 + shifted(below_z0, lower_z0);
    store(fr0 + j, first ? inner_r : load<V>(fr0 + j) + inner_r);
    store(fz0 + j, first ? inner_z : load<V>(fz0 + j) + inner_z);
    store(fr1 + j, upper_r1 + shifted(below_r1, lower_r1));
    store(fz1 + j, upper_z1 + shifted(below_z1, lower_z1));
    lower_r0 = below_r0;
    lower_z0 = below_z0;
    lower_r1 = below_r1;
    lower_z1 = below_z1;
  }
  const V last_r0 = first_lane<V>(lower_r0[lanes - 1]), last_z0 = first_lane<V>(lower_z0[lanes - 1]);
  store(fr0 + rows.end, first ? last_r0 : load<V>(fr0 + rows.end) + last_r0);
  store(fz0 + rows.end, first ? last_z0 : load<V>(fz0 + rows.end) + last_z0);
  store(fr1 + rows.end, first_lane<V>(lower_r1[lanes - 1]));
  store(fz1 + rows.end, first_lane<V>(lower_z1[lanes - 1]));

  report.viscous_work += volume * lane_sum(work);
  solid.report(volume, report);
  const double inverse_step = static_cast<double>(lane_largest(steepest)),
               least = static_cast<double>(lane_smallest(tightest));
  if (inverse_step > report.largest_inverse_step) report.largest_inverse_step = inverse_step;
  if (least < report.smallest_jacobian) report.smallest_jacobian = least;
}

template <class Real>
void internal_forces(const FieldsView<Real>& fields, const ColumnForces<Real>& forces, int column, Rows rows,
                     const ColumnShape& shape, const MaterialConstants& material, double previous_step,
                     const StiffnessWatch& watch, ColumnReport& report) {
  UniformSolid<Real> solid(material, shape);
  forces_of_column(solid, fields, forces, column, rows, shape, previous_step, watch, report);
}

template <class Real>
void internal_forces_averaged(const FieldsView<Real>& fields, const ColumnForces<Real>& forces, int column, Rows rows,
                              const ColumnShape& shape, const MaterialConstants& material, double previous_step,
                              const StiffnessWatch& watch, ColumnReport& report) {
  AveragedSolid<Real> solid(material, shape, fields, column);
  forces_of_column(solid, fields, forces, column, rows, shape, previous_step, watch, report);
}

template <class Real>
void internal_forces_general(const FieldsView<Real>& fields, const ColumnForces<Real>& forces, int column, Rows rows,
                             const ColumnShape& shape, const GeneralSolidView<Real>& view, double previous_step,
                             const StiffnessWatch& watch, ColumnReport& report) {
  GeneralSolid<Real> solid(fields, view, shape, column, previous_step);
  forces_of_column(solid, fields, forces, column, rows, shape, previous_step, watch, report);
}

}  // namespace percal::PERCAL_LEVEL
