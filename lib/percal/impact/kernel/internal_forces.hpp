// Forces of one column of elements, a group of lanes at a time. Compiled once for each instruction level
// (kernel_level.cpp).
#pragma once
#include "percal/impact/kernel/general_solid.hpp"
#include "percal/impact/kernel/pair.hpp"
#include "percal/impact/kernel/uniform_solid.hpp"

namespace percal::PERCAL_LEVEL {

// The walk down one column of elements. Corners: inner upper (node i, j), outer upper (i+1, j), outer lower (i+1, j+1), inner lower
// (i, j+1). What the solid is made of answers through `solid`: UniformSolid, AveragedSolid or GeneralSolid.
template <class Real, class Solid>
class ColumnWalk {
  using Vector = typename VectorOf<Real>::type;
  static constexpr int lanes = Lane<Vector>::count;

 public:
  PERCAL_INLINE ColumnWalk(Solid& solid, const FieldsView<Real>& fields, const ColumnForces<Real>& forces, int column,
                           const ColumnShape& shape, double previous_step, const StiffnessWatch& watch,
                           ColumnReport& report)
      : solid_(solid),
        watch_(watch),
        report_(report),
        fr0_(forces.inner_r),
        fz0_(forces.inner_z),
        fr1_(forces.outer_r),
        fz1_(forces.outer_z),
        first_(forces.first),
        per_width_(1 / shape.width),
        per_height_(1 / shape.height),
        volume_(shape.thickness * shape.width * shape.height),
        half_per_width_(Real(0.5 * per_width_)),
        half_per_height_(Real(0.5 * per_height_)),
        quarter_per_radius_(Real(0.25 * shape.per_radius)),
        to_r_(Real(volume_ * 0.5 * per_width_)),
        to_z_(Real(volume_ * 0.5 * per_height_)),
        to_hoop_(Real(shape.per_radius > 0 ? 0.25 * shape.width * shape.height : 0)),
        length_(Real(__builtin_sqrt(shape.width * shape.height))),
        per_{.width2 = Real(per_width_ * per_width_),
             .height2 = Real(per_height_ * per_height_),
             .hoop2 = Real((shape.at_axis ? axis_hoop_share : 1) * shape.per_radius * shape.per_radius / 4)},
        again_(!(previous_step > 0)),
        per_step_(again_ ? Real(0) : Real(1 / previous_step)),
        watched_(Real(watch.inverse_step < largest_number ? watch.inverse_step : largest_number)) {
    const long inner = static_cast<long>(column) * fields.stride, outer = inner + fields.stride;
    ur0_ = fields.u_r + inner, ur1_ = fields.u_r + outer, uz0_ = fields.u_z + inner, uz1_ = fields.u_z + outer;
    jacobian_ = fields.jacobian + inner, viscous_ = fields.viscous_pressure + inner;
    measure_ = fields.erosion_measure + inner, alive_ = fields.alive + inner;
  }

  PERCAL_INLINE void over(Rows rows) {
    for (int j = rows.begin; j < rows.end;) {
      const bool lives = is_live(j);
      if constexpr (Solid::in_pairs)
        if (lives && j + 2 * lanes <= rows.end && is_live(j + lanes)) {
          take_group<Pair<Vector>>(j);
          report_.groups += 2;
          j += 2 * lanes;
          continue;
        }
      if (lives)
        take_group<Vector>(j);
      else
        close_nodes(j);
      report_.groups += lives;
      j += lanes;
    }
    close_nodes(rows.end);
    report_.viscous_work += volume_ * lane_sum(work_);
    solid_.report(volume_, report_);
    const double inverse_step = static_cast<double>(lane_largest(steepest_)),
                 least = static_cast<double>(lane_smallest(tightest_));
    if (inverse_step > report_.largest_inverse_step) report_.largest_inverse_step = inverse_step;
    if (least < report_.smallest_jacobian) report_.smallest_jacobian = least;
  }

 private:
  PERCAL_INLINE bool is_live(int j) const { return any(load<Vector>(alive_ + j) > Real(0)); }

  // V: a vector, or two of them side by side.
  template <class V>
  PERCAL_INLINE void take_group(int j) {
    const V zero = broadcast<V>(Real(0));
    const V state = load<V>(alive_ + j);
    auto live = state > Real(0);
    const auto& material = solid_.at(j);
    // Gather.
    const Corners<V> r{load<V>(ur0_ + j), load<V>(ur1_ + j), load<V>(ur1_ + j + 1), load<V>(ur0_ + j + 1)};
    const Corners<V> z{load<V>(uz0_ + j), load<V>(uz1_ + j), load<V>(uz1_ + j + 1), load<V>(uz0_ + j + 1)};
    Gradient<V> F = gradient_of(r, z, half_per_width_, half_per_height_, quarter_per_radius_);
    solid_.add_initial_stretch(F);
    const auto hourglass = solid_.hourglass_force(j, r.hourglass(), z.hourglass());

    // Compute.
    const Stretches<V> s = stretches(F);
    const IsochoricPowers<V> g = isochoric_powers(F, s, material.alpha);
    const PrincipalStress<V> t = isochoric_stress(g, material.two_mu_over_alpha);
    const V old_jacobian = load<V>(jacobian_ + j), old_viscous = load<V>(viscous_ + j);
    const V closing = larger((old_jacobian - s.jacobian) * per_step_ * s.inverse_jacobian, zero);  // -tr D
    const V current_length = length_ * square_root(s.in_plane_jacobian);
    const V damping =
        current_length * (material.linear_viscosity + material.quadratic_viscosity * current_length * closing);
    V q = again_ ? old_viscous : damping * closing;
    Piola<V> P = first_piola(F, s, t, solid_.volumetric_stress(s, q));
    solid_.add_further_stress(j, F, s, t, P);

    const StepBound<V> bound = solid_.bound_of_step(s, g, t, per_);
    const V inverse_step = solid_.inverse_step(bound, damping * s.jacobian * bound.over_stretch);

    // Erode. What decides is judged half a step ahead, so that on average an element goes neither early nor late.
    const V now = solid_.erosion_measure(F, s, g, P, q), change = now - load<V>(measure_ + j);
    store(measure_ + j, now);
    const auto at_limit = solid_.at_limit(j, state, now, change, again_, report_);
    auto gone = live & (at_limit | (s.unbounded_jacobian < material.smallest_jacobian) |
                        (inverse_step > material.largest_inverse_step));
    if (again_) gone = gone & ~gone;  // who was judged is not judged again: nobody would take it out
    if (__builtin_expect(any(gone), 0)) {
      const V why = select(at_limit, broadcast<V>(Real(-1)), broadcast<V>(Real(-2)));
      store(alive_ + j, select(gone, why, load<V>(alive_ + j)));
      report_.doomed += static_cast<int>(lane_sum(select(gone, broadcast<V>(Real(1)), zero)));
      const V lost = select(gone, Real(0.5) * old_viscous * (old_jacobian - s.jacobian), zero);
      add(work_, solid_.per_mesh_volume(lost));
      live = live & ~gone;
    }
    solid_.close_group(j, live, gone);
    q = select(live, q, zero);
    const V steep = select(live, inverse_step, zero);
    flag(steep > watched_, j);
    steepest_ = largest(steepest_, steep);
    tightest_ = smallest(tightest_, select(live, s.unbounded_jacobian, broadcast<V>(Real(1e30))));
    const V lost = select(live, Real(0.5) * (old_viscous + q) * (old_jacobian - s.jacobian), zero);
    add(work_, solid_.per_mesh_volume(lost));
    store(jacobian_ + j, s.jacobian);
    store(viscous_ + j, q);

    solid_.refer_to_mesh(P);
    // Scatter. The hourglass force comes last everywhere, so that a mirrored scene has mirrored bits.
    const V rr = P.rr * to_r_, rz = P.rz * to_z_, zr = P.zr * to_r_, zz = P.zz * to_z_, hoop = P.hoop * to_hoop_;
    const V sum_r = rr + rz, difference_r = rr - rz, sum_z = zr + zz, difference_z = zr - zz;
    const V upper_r0 = select(live, sum_r - hoop - hourglass.r, zero),
            upper_r1 = select(live, hourglass.r - (difference_r + hoop), zero);
    const V below_r1 = select(live, -sum_r - hoop - hourglass.r, zero),
            below_r0 = select(live, difference_r - hoop + hourglass.r, zero);
    const V upper_z0 = select(live, sum_z - hourglass.z, zero),
            upper_z1 = select(live, hourglass.z - difference_z, zero);
    const V below_z1 = select(live, -sum_z - hourglass.z, zero),
            below_z0 = select(live, difference_z + hourglass.z, zero);
    give_inner(fr0_ + j, upper_r0 + shifted(below_r0, lower_r0_));
    give_inner(fz0_ + j, upper_z0 + shifted(below_z0, lower_z0_));
    store(fr1_ + j, upper_r1 + shifted(below_r1, lower_r1_));
    store(fz1_ + j, upper_z1 + shifted(below_z1, lower_z1_));
    lower_r0_ = last_vector(below_r0);
    lower_z0_ = last_vector(below_z0);
    lower_r1_ = last_vector(below_r1);
    lower_z1_ = last_vector(below_z1);
  }

  // Remembers the groups that have one of these.
  template <class M>
  PERCAL_INLINE void flag(M mask, int j) const {
    if (__builtin_expect(any(mask), 0)) watch_.flags[j / lanes] = 1;
  }
  template <class M>
  PERCAL_INLINE void flag(Pair<M> mask, int j) const {
    flag(mask.a, j);
    flag(mask.b, j + lanes);
  }

  template <class V>
  PERCAL_INLINE void give_inner(Real* force, V own) const {
    store(force, first_ ? own : load<V>(force) + own);
  }

  // Nodes from row j on to which only the rows before give something.
  PERCAL_INLINE void close_nodes(int j) {
    give_inner(fr0_ + j, first_lane<Vector>(lower_r0_[lanes - 1]));
    give_inner(fz0_ + j, first_lane<Vector>(lower_z0_[lanes - 1]));
    store(fr1_ + j, first_lane<Vector>(lower_r1_[lanes - 1]));
    store(fz1_ + j, first_lane<Vector>(lower_z1_[lanes - 1]));
    lower_r0_ = lower_z0_ = lower_r1_ = lower_z1_ = Vector{};
  }

  Solid& solid_;
  const StiffnessWatch& watch_;
  ColumnReport& report_;
  const Real *ur0_, *ur1_, *uz0_, *uz1_;
  Real *fr0_, *fz0_, *fr1_, *fz1_, *jacobian_, *viscous_, *measure_, *alive_;
  const bool first_;
  const double per_width_, per_height_, volume_;
  const Real half_per_width_, half_per_height_, quarter_per_radius_, to_r_, to_z_, to_hoop_, length_;
  const InverseSides<Real> per_;
  const bool again_;  // nothing has moved: what depends on rates is as it was
  const Real per_step_, watched_;
  // What the rows before gave to their lower corners.
  Vector lower_r0_{}, lower_z0_{}, lower_r1_{}, lower_z1_{};
  Vector work_{}, steepest_{}, tightest_ = broadcast<Vector>(Real(1e30));
};

template <class Real>
void internal_forces(const FieldsView<Real>& fields, const ColumnForces<Real>& forces, int column, Rows rows,
                     const ColumnShape& shape, const MaterialConstants& material, double previous_step,
                     const StiffnessWatch& watch, ColumnReport& report) {
  UniformSolid<Real> solid(material, shape);
  ColumnWalk(solid, fields, forces, column, shape, previous_step, watch, report).over(rows);
}

template <class Real>
void internal_forces_averaged(const FieldsView<Real>& fields, const ColumnForces<Real>& forces, int column, Rows rows,
                              const ColumnShape& shape, const MaterialConstants& material, double previous_step,
                              const StiffnessWatch& watch, ColumnReport& report) {
  AveragedSolid<Real> solid(material, shape, fields, column);
  ColumnWalk(solid, fields, forces, column, shape, previous_step, watch, report).over(rows);
}

template <class Real>
void internal_forces_general(const FieldsView<Real>& fields, const ColumnForces<Real>& forces, int column, Rows rows,
                             const ColumnShape& shape, const GeneralSolidView<Real>& view, double previous_step,
                             const StiffnessWatch& watch, ColumnReport& report) {
  GeneralSolid<Real> solid(fields, view, shape, column, previous_step);
  ColumnWalk(solid, fields, forces, column, shape, previous_step, watch, report).over(rows);
}

}  // namespace percal::PERCAL_LEVEL
