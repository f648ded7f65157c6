// What a column of bricks is made of: one layer of the plain solid, whose constants are numbers, or anything else that a block may be,
// whose constants go row by row. Both answer to the same verbs, in the order in which the walk asks (forces_and_motion.hpp).
#pragma once
#include "percal/impact/kernel/general_solid.hpp"
#include "percal/solid/kernel/brick_fibres.hpp"
#include "percal/solid/kernel/kernel.hpp"

namespace percal::PERCAL_LEVEL::hex {

template <class C>
struct BrickConstants {
  C mu, bulk, alpha, two_mu_over_alpha;
  C hourglass;  // c_hg mu
  C linear_viscosity, quadratic_viscosity;
  C erosion_limit;  // of what erosion_measure() returns
  C smallest_jacobian, largest_inverse_step;
};

template <class Real>
PERCAL_INLINE BrickConstants<Real> brick_constants(const MaterialConstants& m) {
  return {
      .mu = Real(m.mu),
      .bulk = Real(m.bulk),
      .alpha = Real(m.alpha),
      .two_mu_over_alpha = Real(2 * m.mu / m.alpha),
      .hourglass = Real(m.hourglass * m.mu),
      .linear_viscosity = Real(m.linear_viscosity),
      .quadratic_viscosity = Real(m.quadratic_viscosity),
      .erosion_limit = bounded_limit<Real>(m.erosion_stretch * m.erosion_stretch),
      .smallest_jacobian = Real(m.smallest_jacobian),
      .largest_inverse_step = Real(m.largest_inverse_step < largest_number ? m.largest_inverse_step : largest_number)};
}

template <class Real>
class UniformBrick {
 public:
  explicit UniformBrick(const MaterialConstants& material) : constants_(brick_constants<Real>(material)) {}

  // Rows k to k + lanes come next.
  PERCAL_INLINE const BrickConstants<Real>& at(int) const { return constants_; }
  template <class V>
  PERCAL_INLINE void add_initial_stretch(Tensor<V>&) const {}
  template <class V>
  PERCAL_INLINE void refer_to_mesh(Tensor<V>&) const {}
  template <class V>
  PERCAL_INLINE V per_mesh_volume(V energy) const {
    return energy;
  }
  template <class V>
  PERCAL_INLINE void add_further_stress(const Tensor<V>&, const Deformation<V>&, Symmetric<V>&) const {}
  template <class V, class S>
  PERCAL_INLINE StepBound<V> bound_of_step(const Deformation<V>& d, const Symmetric<V>& isochoric, V g_mean, S per_x2,
                                           S per_y2, V per_z2) const {
    const V volumetric = volumetric_stiffness(PressureLaw::log_quadratic, d.jacobian, constants_.bulk);
    return step_bound(d, isochoric, volumetric, g_mean, constants_.mu, constants_.alpha, per_x2, per_y2, per_z2);
  }
  template <class V>
  PERCAL_INLINE V inverse_step(const StepBound<V>& bound, V drag) const {
    return square_root(larger(bound.stiffness, V{}) + drag * drag) + drag;
  }
  // The largest squared stretch. tau is without bulk viscosity.
  template <class V>
  PERCAL_INLINE V erosion_measure(const Deformation<V>& d, const Powers<V>&, const Symmetric<V>&) const {
    return d.spectrum.largest;
  }

 private:
  const BrickConstants<Real> constants_;
};

// The largest eigenvalue.
template <class V>
PERCAL_INLINE V largest_eigenvalue(const Symmetric<V>& a) {
  using Real = RealOf<V>;
  const V mean = trace(a) * Real(1.0 / 3);
  const Symmetric<V> B = less(a, mean);
  const V p = square_root(trace(square(B)) * Real(1.0 / 6)) + Real(1e-20);
  return spectrum_of(B, p, Real(1) / p, V{}).largest + mean;
}

// Layers, initial stretch, fibres, erosion by any limit. C: a number, or lanes where rows differ.
template <class C>
struct LayeredConstants : BrickConstants<C> {
  C per_density;   // of the solid before it was stretched
  C energy_scale;  // 2 mu/alpha^2
  C initial_x, initial_y, initial_z, per_initial_jacobian;
  FibreStructure<C> fibres;
  C per_squared_stretch_less_one, per_stress, per_energy;
};

template <class Real>
PERCAL_INLINE LayeredConstants<Real> layered_constants(const MaterialConstants& m, ErosionKind erosion) {
  LayeredConstants<Real> c{};
  static_cast<BrickConstants<Real>&>(c) = brick_constants<Real>(m);
  const double initial_jacobian = m.initial.jacobian();
  c.per_density = Real(1 / (m.density * initial_jacobian));
  c.energy_scale = Real(2 * m.mu / (m.alpha * m.alpha));
  c.initial_x = Real(m.initial.r);
  c.initial_y = Real(m.initial.hoop);
  c.initial_z = Real(m.initial.z);
  c.per_initial_jacobian = Real(1 / initial_jacobian);
  c.fibres = fibre_structure<Real>(m.fibres);
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

template <class A, class B, class Take>
void each_constant(LayeredConstants<A>& a, const LayeredConstants<B>& b, Take take) {
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
  take(a.initial_x, b.initial_x);
  take(a.initial_y, b.initial_y);
  take(a.initial_z, b.initial_z);
  take(a.per_initial_jacobian, b.per_initial_jacobian);
  take(a.fibres.k1, b.fibres.k1);
  take(a.fibres.k2, b.fibres.k2);
  take(a.fibres.xx, b.fibres.xx);
  take(a.fibres.yy, b.fibres.yy);
  take(a.fibres.zz, b.fibres.zz);
  take(a.fibres.xy, b.fibres.xy);
  take(a.per_squared_stretch_less_one, b.per_squared_stretch_less_one);
  take(a.per_stress, b.per_stress);
  take(a.per_energy, b.per_energy);
}

// V: lanes of the level, or of doubles where energies are summed.
template <class V>
class LayeredBrick {
  using Real = RealOf<V>;
  static constexpr int lanes = Lane<V>::count;

 public:
  explicit LayeredBrick(const LayeredSolidView& view) : view_(view) {}

  PERCAL_INLINE const LayeredConstants<V>& at(int k) {
    if (k >= valid_below_) take_constants(k);
    return constants_;
  }
  // docs/theory/target.md (16), (17).
  PERCAL_INLINE void add_initial_stretch(Tensor<V>& F) const {
    if (!view_.is_stretched) return;
    const V x = constants_.initial_x, y = constants_.initial_y, z = constants_.initial_z;
    F = {F.xx * x, F.xy * y, F.xz * z, F.yx * x, F.yy * y, F.yz * z, F.zx * x, F.zy * y, F.zz * z};
  }
  PERCAL_INLINE void refer_to_mesh(Tensor<V>& P) const {
    if (!view_.is_stretched) return;
    const V per = constants_.per_initial_jacobian;
    const V x = constants_.initial_x * per, y = constants_.initial_y * per, z = constants_.initial_z * per;
    P = {P.xx * x, P.xy * y, P.xz * z, P.yx * x, P.yy * y, P.yz * z, P.zx * x, P.zy * y, P.zz * z};
  }
  PERCAL_INLINE V per_mesh_volume(V energy) const {
    return view_.is_stretched ? energy * constants_.per_initial_jacobian : energy;
  }
  PERCAL_INLINE void add_further_stress(const Tensor<V>& F, const Deformation<V>& d, Symmetric<V>& tau) {
    if (!view_.has_fibres) return;
    const FibreStress<V> fibres = fibre_stress(F, d.jacobian, constants_.fibres);
    tau = {tau.xx + fibres.kirchhoff.xx, tau.yy + fibres.kirchhoff.yy, tau.zz + fibres.kirchhoff.zz,
           tau.xy + fibres.kirchhoff.xy, tau.xz + fibres.kirchhoff.xz, tau.yz + fibres.kirchhoff.yz};
    fibre_energy_ = fibres.energy;
    fibre_stiffness_ = fibres.stiffness;
  }
  // The unstretched brick has sides of its own.
  template <class S>
  PERCAL_INLINE StepBound<V> bound_of_step(const Deformation<V>& d, const Symmetric<V>& isochoric, V g_mean, S per_x2,
                                           S per_y2, V per_z2) const {
    const LayeredConstants<V>& c = constants_;
    const V volumetric = volumetric_stiffness(PressureLaw::log_quadratic, d.jacobian, c.bulk);
    StepBound<V> bound =
        step_bound(d, isochoric, volumetric, g_mean, c.mu, c.alpha, per_x2 * (c.initial_x * c.initial_x),
                   per_y2 * (c.initial_y * c.initial_y), per_z2 * (c.initial_z * c.initial_z));
    if (view_.has_fibres) bound.stiffness += fibre_stiffness_ * bound.over_stretch;
    return bound;
  }
  PERCAL_INLINE V inverse_step(const StepBound<V>& bound, V drag_times_density) const {
    const V drag = drag_times_density * constants_.per_density;
    return square_root(larger(bound.stiffness * constants_.per_density, V{}) + drag * drag) + drag;
  }
  PERCAL_INLINE V energy(const Deformation<V>& d, const Powers<V>& g) const {
    const V matrix = constants_.energy_scale * (g.sum() - Real(3)) +
                     volumetric_energy(PressureLaw::log_quadratic, d.jacobian, constants_.bulk);
    return view_.has_fibres ? matrix + fibre_energy_ : matrix;
  }
  // tau is without bulk viscosity.
  PERCAL_INLINE V erosion_measure(const Deformation<V>& d, const Powers<V>& g, const Symmetric<V>& tau) const {
    switch (view_.erosion_kind) {
      case ErosionKind::stress: return largest_eigenvalue(tau) * d.inverse_jacobian;
      case ErosionKind::averaged_energy:
      case ErosionKind::energy: return energy(d, g);
      case ErosionKind::several:  // the largest share of a limit
        return larger((d.spectrum.largest - Real(1)) * constants_.per_squared_stretch_less_one,
                      larger(largest_eigenvalue(tau) * d.inverse_jacobian * constants_.per_stress,
                             energy(d, g) * constants_.per_energy));
      case ErosionKind::stretch: break;
    }
    return d.spectrum.largest;
  }

 private:
  const SolidLayer& layer_of(int row) const {
    int k = 0;
    while (k + 1 < view_.layer_count && row >= view_.layers[k].end) ++k;
    return view_.layers[k];
  }
  // All lanes alike until the layer's last whole group; a group that holds the end of a layer takes each lane's own.
  void take_constants(int row) {
    const SolidLayer* known = nullptr;
    LayeredConstants<Real> own;
    for (int l = 0; l < lanes; ++l) {
      const SolidLayer& of_lane = layer_of(row + l);
      if (&of_lane != known) own = layered_constants<Real>(of_lane.material, view_.erosion_kind);
      known = &of_lane;
      each_constant(constants_, own, [l](V& all, Real one) { all[l] = one; });
    }
    const SolidLayer& layer = layer_of(row);
    const bool last = &layer == view_.layers + view_.layer_count - 1;
    valid_below_ = last ? 1 << 30 : (layer.end - lanes + 1 > row + 1 ? layer.end - lanes + 1 : row + 1);
  }

  const LayeredSolidView& view_;
  LayeredConstants<V> constants_;
  int valid_below_ = -1;
  V fibre_energy_{}, fibre_stiffness_{};  // of the group at hand
};

}  // namespace percal::PERCAL_LEVEL::hex
