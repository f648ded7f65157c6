// A target that is more than one layer of the plain solid: layers, other volumetric laws, stress that relaxes, erosion
// by stress or energy, viscous hourglass control. The verbs are those of UniformSolid. docs/theory/target.md.
#pragma once
#include "percal/impact/kernel/fibres.hpp"
#include "percal/impact/kernel/relaxing_stress.hpp"
#include "percal/impact/kernel/uniform_solid.hpp"

namespace percal::PERCAL_LEVEL {

// Besides those of the plain solid.
template <class C>
struct GeneralConstants : SolidConstants<C> {
  C per_density;                // of the solid before it was stretched
  C energy_scale;               // 2 mu/alpha^2
  C hourglass_inverse_step;     // 1/dt that the viscosity of the hourglass mode needs
  C initial_r, initial_z, initial_hoop, per_initial_jacobian;
  C fibre_k1, fibre_k2, fibre_kappa;
  C per_squared_stretch_less_one, per_stress, per_energy;  // 1/limit of each measure where several decide
};

// take(of a, of b) for each of them.
template <class A, class B, class Take>
void each_constant(GeneralConstants<A>& a, const GeneralConstants<B>& b, Take take) {
  take(a.mu, b.mu);
  take(a.bulk, b.bulk);
  take(a.alpha, b.alpha);
  take(a.two_mu_over_alpha, b.two_mu_over_alpha);
  take(a.hourglass, b.hourglass);
  take(a.linear_viscosity, b.linear_viscosity);
  take(a.quadratic_viscosity, b.quadratic_viscosity);
  take(a.erosion_limit, b.erosion_limit);
  take(a.smallest_jacobian, b.smallest_jacobian);
  take(a.largest_inverse_step, b.largest_inverse_step);
  take(a.per_density, b.per_density);
  take(a.energy_scale, b.energy_scale);
  take(a.hourglass_inverse_step, b.hourglass_inverse_step);
  take(a.initial_r, b.initial_r);
  take(a.initial_z, b.initial_z);
  take(a.initial_hoop, b.initial_hoop);
  take(a.per_initial_jacobian, b.per_initial_jacobian);
  take(a.fibre_k1, b.fibre_k1);
  take(a.fibre_k2, b.fibre_k2);
  take(a.fibre_kappa, b.fibre_kappa);
  take(a.per_squared_stretch_less_one, b.per_squared_stretch_less_one);
  take(a.per_stress, b.per_stress);
  take(a.per_energy, b.per_energy);
}

// By what measures are multiplied to be shares of their limits: lambda^2 - 1, stress, energy. 0 where there is none.
struct SharesOfLimits {
  double stretch, stress, energy;
};
PERCAL_INLINE SharesOfLimits per_limits(const MaterialConstants& m) {
  const auto per = [](double limit) { return limit < no_erosion ? 1 / limit : 0; };
  return {per(m.erosion_stretch * m.erosion_stretch - 1), per(m.stress_limit), per(m.energy_limit)};
}

template <class Real>
PERCAL_INLINE GeneralConstants<Real> general_constants(const MaterialConstants& m, const ColumnShape& shape,
                                                       HourglassKind hourglass, ErosionKind erosion) {
  GeneralConstants<Real> c{};
  static_cast<SolidConstants<Real>&>(c) = solid_constants<Real>(m, shape);
  const double initial_jacobian = m.initial.jacobian();
  c.per_density = Real(1 / (m.density * initial_jacobian));
  c.energy_scale = Real(2 * m.mu / (m.alpha * m.alpha));
  c.initial_r = Real(m.initial.r);
  c.initial_z = Real(m.initial.z);
  c.initial_hoop = Real(m.initial.hoop);
  c.per_initial_jacobian = Real(1 / initial_jacobian);
  c.fibre_k1 = Real(m.fibres.k1);
  c.fibre_k2 = Real(m.fibres.k2);
  c.fibre_kappa = Real(m.fibres.kappa);
  if (hourglass == HourglassKind::viscosity) {
    const double impedance = __builtin_sqrt((m.bulk + 4.0 / 3 * m.mu) * m.density);
    const double length = __builtin_sqrt(shape.width * shape.height);
    c.hourglass = Real(0.25 * m.hourglass * impedance * length * shape.thickness);
    c.hourglass_inverse_step = Real(2 * m.hourglass * impedance / (m.density * length));
  }
  if (erosion != ErosionKind::stretch) c.erosion_limit = bounded_limit<Real>(m.erosion_limit);
  if (erosion == ErosionKind::several) {
    c.erosion_limit = Real(1);
    const SharesOfLimits per = per_limits(m);
    c.per_squared_stretch_less_one = Real(per.stretch);
    c.per_stress = Real(per.stress);
    c.per_energy = Real(per.energy);
  }
  return c;
}

template <class Real>
class GeneralSolid {
 public:
  using V = typename VectorOf<Real>::type;
  using Constants = GeneralConstants<V>;
  static constexpr int lanes = Lane<V>::count;
  static constexpr bool in_pairs = false;

  GeneralSolid(const FieldsView<Real>& fields, const GeneralSolidView<Real>& view, const ColumnShape& shape, int column,
               double previous_step)
      : view_(view),
        shape_(shape),
        inner_(static_cast<long>(column) * fields.stride),
        outer_(inner_ + fields.stride),
        v_r_(fields.v_r),
        v_z_(fields.v_z),
        previous_step_(Real(previous_step)),
        averaged_limit_(view.erosion_kind == ErosionKind::averaged_energy ? averaged_limit(fields, column)
                                                                          : AveragedLimit<Real>{}),
        relaxing_stress_(view.relaxation, column, inner_, view.time) {}

  PERCAL_INLINE const Constants& at(int j) {
    if (j >= valid_below_) take_constants(j);
    return constants_;
  }

  // docs/theory/target.md (16), (17).
  PERCAL_INLINE void add_initial_stretch(Gradient<V>& F) const {
    if (!view_.is_stretched) return;
    const Constants& c = constants_;
    F = {F.rr * c.initial_r, F.rz * c.initial_z, F.zr * c.initial_r, F.zz * c.initial_z, F.hoop * c.initial_hoop};
  }
  PERCAL_INLINE void refer_to_mesh(Piola<V>& P) const {
    if (!view_.is_stretched) return;
    const Constants& c = constants_;
    const V r = c.initial_r * c.per_initial_jacobian, z = c.initial_z * c.per_initial_jacobian;
    P = {P.rr * r, P.rz * z, P.zr * r, P.zz * z, P.hoop * (c.initial_hoop * c.per_initial_jacobian)};
  }
  PERCAL_INLINE V per_mesh_volume(V energy) const {
    return view_.is_stretched ? energy * constants_.per_initial_jacobian : energy;
  }

  PERCAL_INLINE CornerForce<V> hourglass_force(int j, V mode_r, V mode_z) {
    if (view_.hourglass_kind == HourglassKind::stiffness)
      return {mode_r * constants_.hourglass, mode_z * constants_.hourglass};
    const V r = mode_of(v_r_, j), z = mode_of(v_z_, j);
    Real *old_r = view_.hourglass.r + inner_ + j, *old_z = view_.hourglass.z + inner_ + j;
    const V half = Real(0.5) * previous_step_ * constants_.hourglass;
    hourglass_work_if_gone_ = half * (load<V>(old_r) * r + load<V>(old_z) * z);
    hourglass_work_ = hourglass_work_if_gone_ + half * (r * r + z * z);
    store(old_r, r);
    store(old_z, z);
    return {r * constants_.hourglass, z * constants_.hourglass};
  }

  PERCAL_INLINE V volumetric_stress(const Stretches<V>& s, V q) const {
    return kirchhoff_pressure(view_.pressure_law, s.jacobian, constants_.bulk) - q * s.jacobian;
  }

  // Of fibres, and what relaxation has changed.
  PERCAL_INLINE void add_further_stress(int j, const Gradient<V>& F, const Stretches<V>& s, const PrincipalStress<V>& t,
                                        Piola<V>& P) {
    if (view_.has_fibres) add_fibres(F, s, P);
    if (view_.relaxation.terms == 0) return;
    const auto change = relaxing_stress_.advance(j, F, second_piola(s, t));
    relaxing_work_ = per_mesh_volume(change.work);
    relaxing_work_if_gone_ = per_mesh_volume(change.work_if_gone);
    const Piola<V> more = pushed(F, change.stress);
    P = P + more;
    stiffer_ = larger(largest_principal(kirchhoff(F, more)), V{});
  }

  // Relaxation leaves the modulus of a fast change alone, but not the stress that the modulus of P has in it: target.md
  // (10).
  PERCAL_INLINE StepBound<V> bound_of_step(const Stretches<V>& s, const IsochoricPowers<V>& g,
                                           const PrincipalStress<V>& t, const InverseSides<Real>& per) const {
    const V volumetric = volumetric_stiffness(view_.pressure_law, s.jacobian, constants_.bulk);
    StepBound<V> bound = bound_between(volumetric, s, g, t, per);
    if (view_.relaxation.terms > 0) bound.stiffness += stiffer_ * bound.over_stretch;
    if (view_.has_fibres) bound.stiffness += fibre_stiffness_ * bound.over_stretch;
    return bound;
  }
  PERCAL_INLINE V inverse_step(const StepBound<V>& bound, V drag_times_density) const {
    const V drag = drag_times_density * constants_.per_density;
    const V inverse = square_root(larger(bound.stiffness * constants_.per_density, V{}) + drag * drag) + drag;
    return larger(inverse, constants_.hourglass_inverse_step);
  }

  PERCAL_INLINE V erosion_measure(const Gradient<V>& F, const Stretches<V>& s, const IsochoricPowers<V>& g,
                                  const Piola<V>& P, V q) const {
    switch (view_.erosion_kind) {
      case ErosionKind::stress: return tension(F, s, P, q);
      case ErosionKind::energy:
      case ErosionKind::averaged_energy: return energy(s, g);
      case ErosionKind::several:  // the largest share of a limit
        return larger((squared_stretch(F, s) - Real(1)) * constants_.per_squared_stretch_less_one,
                      larger(tension(F, s, P, q) * constants_.per_stress, energy(s, g) * constants_.per_energy));
      case ErosionKind::stretch: break;
    }
    return squared_stretch(F, s);
  }

  PERCAL_INLINE auto at_limit(int j, V state, V now, V change, bool again, ColumnReport& report) const {
    if (view_.erosion_kind != ErosionKind::averaged_energy)
      return beyond_own_limit(now, change, constants_.erosion_limit);
    return averaged_limit_.condemned_ones(j, state, now, change, constants_.erosion_limit, again, report);
  }

  template <class Mask>
  PERCAL_INLINE void close_group(int, Mask live, Mask gone) {
    const V zero{};
    if (view_.hourglass_kind == HourglassKind::viscosity)
      dissipated_ += select(live, hourglass_work_, select(gone, hourglass_work_if_gone_, zero));
    if (view_.relaxation.terms > 0)
      relaxed_ += select(live, relaxing_work_, select(gone, relaxing_work_if_gone_, zero));
  }
  void report(double volume, ColumnReport& report) const {
    report.viscous_work += lane_sum(dissipated_);
    report.relaxing_work += volume * lane_sum(relaxed_);
  }

 private:
  PERCAL_INLINE V squared_stretch(const Gradient<V>& F, const Stretches<V>& s) const {
    return larger(s.first2, F.hoop * F.hoop);
  }
  // Largest principal Cauchy stress, without the bulk viscosity that is in P.
  PERCAL_INLINE V tension(const Gradient<V>& F, const Stretches<V>& s, const Piola<V>& P, V q) const {
    return largest_principal(kirchhoff(F, P)) * s.inverse_jacobian + q;
  }
  PERCAL_INLINE V energy(const Stretches<V>& s, const IsochoricPowers<V>& g) const {
    const V matrix = strain_energy(view_.pressure_law, s, g, constants_.energy_scale, constants_.bulk);
    return view_.has_fibres ? matrix + fibre_energy_ : matrix;
  }
  PERCAL_INLINE void add_fibres(const Gradient<V>& F, const Stretches<V>& s, Piola<V>& P) {
    const auto fibres = fibre_response(F, s, constants_.fibre_k1, constants_.fibre_k2, constants_.fibre_kappa);
    P = P + fibres.stress;
    fibre_energy_ = fibres.energy;
    fibre_stiffness_ = fibres.stiffness;
  }
  // The unstretched element has sides of its own.
  PERCAL_INLINE StepBound<V> bound_between(V volumetric, const Stretches<V>& s, const IsochoricPowers<V>& g,
                                           const PrincipalStress<V>& t, const InverseSides<Real>& per) const {
    if (!view_.is_stretched)
      return step_bound_with(volumetric, s, g, t, constants_.mu, per.width2, per.height2, per.hoop2);
    const Constants& c = constants_;
    return step_bound_with(volumetric, s, g, t, c.mu, per.width2 * (c.initial_r * c.initial_r),
                           per.height2 * (c.initial_z * c.initial_z), per.hoop2 * (c.initial_hoop * c.initial_hoop));
  }
  const SolidLayer& layer_of(int row) const {
    int k = 0;
    while (k + 1 < view_.layer_count && row >= view_.layers[k].end) ++k;
    return view_.layers[k];
  }
  GeneralConstants<Real> of_layer(const SolidLayer& layer) const {
    return general_constants<Real>(layer.material, shape_, view_.hourglass_kind, view_.erosion_kind);
  }
  // All lanes alike until the layer's last whole group; a group that holds the end of a layer takes each lane's own.
  void take_constants(int j) {
    for (int l = 0; l < lanes; ++l) {
      const GeneralConstants<Real> own = of_layer(layer_of(j + l));
      each_constant(constants_, own, [l](V& all, Real one) { all[l] = one; });
    }
    const SolidLayer& layer = layer_of(j);
    const bool last = &layer == view_.layers + view_.layer_count - 1;
    valid_below_ = last ? 1 << 30 : (layer.end - lanes + 1 > j + 1 ? layer.end - lanes + 1 : j + 1);
  }
  PERCAL_INLINE V mode_of(const Real* nodal, int j) const {
    const Real *inner = nodal + inner_ + j, *outer = nodal + outer_ + j;
    return (load<V>(inner) - load<V>(outer)) + (load<V>(outer + 1) - load<V>(inner + 1));
  }

  const GeneralSolidView<Real>& view_;
  const ColumnShape& shape_;
  const long inner_, outer_;
  const Real *v_r_, *v_z_;
  const Real previous_step_;
  const AveragedLimit<Real> averaged_limit_;  // used where an average is taken
  RelaxingStress<Real> relaxing_stress_;
  Constants constants_;
  int valid_below_ = -1;
  // Of the group at hand.
  V hourglass_work_{}, hourglass_work_if_gone_{}, relaxing_work_{}, relaxing_work_if_gone_{}, stiffer_{};
  V fibre_energy_{}, fibre_stiffness_{};
  // Of the column.
  V dissipated_{}, relaxed_{};
};

}  // namespace percal::PERCAL_LEVEL
