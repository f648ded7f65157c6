// One-point axisymmetric quad of the compressible one-term Ogden solid, written once over V = a scalar or lanes.
//   W = (2 mu/alpha^2) (sum lambda_bar_i^alpha - 3) + U(J),  lambda_bar_i = J^(-1/3) lambda_i
// Constants C are numbers, or lanes where they differ from row to row. Equations: docs/theory/impact.md; of other U than
// K/4 (J^2 - 1 - 2 ln J): docs/theory/target.md (4).
#pragma once
#include "percal/impact/kernel/kernel.hpp"
#include "percal/math/lanes.hpp"

namespace percal::PERCAL_LEVEL {

// Deformation gradient at the element's centre: the in-plane part and the hoop stretch.
template <class V>
struct Gradient {
  V rr, rz, zr, zz, hoop;
};

// A displacement at an element's corners: inner upper, outer upper, outer lower, inner lower.
template <class V>
struct Corners {
  V a, b, c, d;
  PERCAL_INLINE V along_width() const { return (c - a) + (b - d); }   // twice what it changes across the element
  PERCAL_INLINE V along_height() const { return (c - a) - (b - d); }
  PERCAL_INLINE V sum() const { return (a + c) + (b + d); }
  PERCAL_INLINE V hourglass() const { return (a - b) + (c - d); }
};

// Sums and differences over the diagonals give the gradient with few operations.
template <class V>
PERCAL_INLINE Gradient<V> gradient_of(const Corners<V>& r, const Corners<V>& z, RealOf<V> half_per_width,
                                      RealOf<V> half_per_height, RealOf<V> quarter_per_radius) {
  using Real = RealOf<V>;
  Gradient<V> F;
  F.rr = r.along_width() * half_per_width + Real(1);
  F.rz = r.along_height() * half_per_height;
  F.zr = z.along_width() * half_per_width;
  F.zz = z.along_height() * half_per_height + Real(1);
  F.hoop = larger(r.sum() * quarter_per_radius + Real(1), broadcast<V>(Real(1e-3)));
  return F;
}

// Principal stretches and what follows from them. In-plane: C = mean 1 + [half_difference, shear; shear, -half_difference].
template <class V>
struct Stretches {
  V first2, second2;                // squared in-plane principal stretches, first2 >= second2
  V half_difference, shear, split;  // split = (first2 - second2)/2
  V in_plane_jacobian, jacobian;    // bounded below by 1e-3
  V unbounded_jacobian;
  V inverse_first2, inverse_second2, inverse_hoop, inverse_split, inverse_jacobian;
};

template <class V>
PERCAL_INLINE Stretches<V> stretches(const Gradient<V>& F) {
  using Real = RealOf<V>;
  const V smallest = broadcast<V>(Real(1e-3));
  Stretches<V> s;
  const V c11 = F.rr * F.rr + F.zr * F.zr, c22 = F.rz * F.rz + F.zz * F.zz;
  const V det = F.rr * F.zz - F.rz * F.zr;
  s.in_plane_jacobian = larger(det, smallest);
  s.jacobian = s.in_plane_jacobian * F.hoop;
  s.unbounded_jacobian = det * F.hoop;
  s.shear = F.rr * F.rz + F.zr * F.zz;
  s.half_difference = Real(0.5) * (c11 - c22);
  s.split = square_root(s.half_difference * s.half_difference + s.shear * s.shear + Real(1e-12));
  s.first2 = Real(0.5) * (c11 + c22) + s.split;
  // One division gives all the reciprocals; second2 = det^2 / first2 keeps their product exact.
  const V a = s.first2 * s.in_plane_jacobian, b = F.hoop * s.split;
  const V r = Real(1) / (a * b);
  const V inverse_a = r * b, inverse_b = r * a;
  s.inverse_first2 = inverse_a * s.in_plane_jacobian;
  const V inverse_in_plane = inverse_a * s.first2;
  s.inverse_hoop = inverse_b * s.split;
  s.inverse_split = inverse_b * F.hoop;
  s.second2 = s.in_plane_jacobian * s.in_plane_jacobian * s.inverse_first2;
  s.inverse_second2 = s.first2 * inverse_in_plane * inverse_in_plane;
  s.inverse_jacobian = inverse_in_plane * s.inverse_hoop;
  return s;
}

// g_i = lambda_bar_i^alpha.
template <class V>
struct IsochoricPowers {
  V first, second, hoop;
};

// Two logarithms and two exponentials: with s = J_in-plane, ln lambda_bar_1 = ln(first2 / (second2 hoop^2))/6 + ..., and the three
// isochoric powers multiply to 1.
template <class V, class C>
PERCAL_INLINE IsochoricPowers<V> isochoric_powers(const Gradient<V>& F, const Stretches<V>& s, C alpha) {
  using Real = RealOf<V>;
  IsochoricPowers<V> g;
  const V first = s.first2 * s.first2 * s.inverse_second2 * s.inverse_hoop * s.inverse_hoop;  // lambda_bar_1^6
  const V hoop = F.hoop * F.hoop * s.inverse_jacobian * F.hoop;                               // lambda_bar_3^3
  g.first = exp2_of(alpha * Real(1.0 / 6) * log2_of(first));
  g.hoop = exp2_of(alpha * Real(1.0 / 3) * log2_of(hoop));
  g.second = Real(1) / (g.first * g.hoop);
  return g;
}

// Energy of the isochoric part per undeformed volume; energy_scale = 2 mu/alpha^2.
template <class V, class C>
PERCAL_INLINE V isochoric_energy(const IsochoricPowers<V>& g, C energy_scale) {
  return energy_scale * (g.first + g.second + g.hoop - RealOf<V>(3));
}

// Principal Kirchhoff stresses lambda_i dW/dlambda_i of the isochoric part: (2 mu/alpha) (g_i - mean g).
template <class V>
struct PrincipalStress {
  V first, second, hoop;
};
template <class V, class C>
PERCAL_INLINE PrincipalStress<V> isochoric_stress(const IsochoricPowers<V>& g, C two_mu_over_alpha) {
  const V mean = (g.first + g.second + g.hoop) * RealOf<V>(1.0 / 3);
  return {two_mu_over_alpha * (g.first - mean), two_mu_over_alpha * (g.second - mean),
          two_mu_over_alpha * (g.hoop - mean)};
}

// Volumetric energies, each with U'' = K at J = 1: what they give to stress, to the stable step and to W.
template <class V>
PERCAL_INLINE V natural_log(V x) {
  return log2_of(x) * RealOf<V>(0.69314718055994530942);
}

PERCAL_INLINE double natural_log(double x) { return __builtin_log(x); }

// J U'(J): what the law adds to each principal Kirchhoff stress.
template <class V, class C>
PERCAL_INLINE V kirchhoff_pressure(PressureLaw law, V J, C bulk) {
  using Real = RealOf<V>;
  switch (law) {
    case PressureLaw::quadratic: return bulk * (J * J - J);
    case PressureLaw::logarithmic: return bulk * natural_log(J);
    case PressureLaw::log_quadratic: break;
  }
  return (Real(0.5) * bulk) * (J * J - Real(1));
}

// J^2 U''(J).
template <class V, class C>
PERCAL_INLINE V volumetric_stiffness(PressureLaw law, V J, C bulk) {
  using Real = RealOf<V>;
  switch (law) {
    case PressureLaw::quadratic: return bulk * J * J;
    case PressureLaw::logarithmic: return bulk * (Real(1) - natural_log(J));
    case PressureLaw::log_quadratic: break;
  }
  return (Real(0.5) * bulk) * (J * J + Real(1));
}

template <class V, class C>
PERCAL_INLINE V volumetric_energy(PressureLaw law, V J, C bulk) {
  using Real = RealOf<V>;
  switch (law) {
    case PressureLaw::quadratic: return (Real(0.5) * bulk) * (J - Real(1)) * (J - Real(1));
    case PressureLaw::logarithmic: {
      const V log_J = natural_log(J);
      return (Real(0.5) * bulk) * log_J * log_J;
    }
    case PressureLaw::log_quadratic: break;
  }
  return (Real(0.25) * bulk) * (J * J - Real(1) - Real(2) * natural_log(J));
}

// Both parts of W; energy_scale as above.
template <class V, class C>
PERCAL_INLINE V strain_energy(PressureLaw law, const Stretches<V>& s, const IsochoricPowers<V>& g, C energy_scale, C bulk) {
  return isochoric_energy(g, energy_scale) + volumetric_energy(law, s.jacobian, bulk);
}

// First Piola stress from the principal Kirchhoff stresses t_i and a Kirchhoff pressure-like part added to each:
// P = F S with the in-plane S = mean 1 + (S_1 - S_2)/(2 split) [half_difference, shear; shear, -half_difference].
template <class V>
struct Piola {
  V rr, rz, zr, zz, hoop;
};
template <class V>
PERCAL_INLINE Piola<V> operator+(const Piola<V>& a, const Piola<V>& b) {
  return {a.rr + b.rr, a.rz + b.rz, a.zr + b.zr, a.zz + b.zz, a.hoop + b.hoop};
}
template <class V>
PERCAL_INLINE Piola<V> first_piola(const Gradient<V>& F, const Stretches<V>& s, const PrincipalStress<V>& t,
                                   V volumetric) {
  using Real = RealOf<V>;
  const V S1 = (t.first + volumetric) * s.inverse_first2, S2 = (t.second + volumetric) * s.inverse_second2;
  const V mean = Real(0.5) * (S1 + S2), part = Real(0.5) * (S1 - S2) * s.inverse_split;
  const V S11 = mean + part * s.half_difference, S22 = mean - part * s.half_difference, S12 = part * s.shear;
  return {F.rr * S11 + F.rz * S12, F.rr * S12 + F.rz * S22, F.zr * S11 + F.zz * S12, F.zr * S12 + F.zz * S22,
          (t.hoop + volumetric) * s.inverse_hoop};
}

// W and P of one element in plain numbers, for whoever looks at single ones: ledger, frames, an elastic particle.
struct ElasticConstants {
  double mu, bulk, alpha;
  PressureLaw law = PressureLaw::log_quadratic;
};
PERCAL_INLINE double strain_energy(const ElasticConstants& c, const Stretches<double>& s,
                                   const IsochoricPowers<double>& g) {
  return strain_energy(c.law, s, g, 2 * c.mu / (c.alpha * c.alpha), c.bulk);
}
// With a further pressure-like Kirchhoff stress: what viscosity adds.
PERCAL_INLINE Piola<double> elastic_piola(const ElasticConstants& c, const Gradient<double>& F,
                                          const Stretches<double>& s, const IsochoricPowers<double>& g,
                                          double further = 0) {
  return first_piola(F, s, isochoric_stress(g, 2 * c.mu / c.alpha),
                     kirchhoff_pressure(c.law, s.jacobian, c.bulk) + further);
}

// The share of its own hoop term w_3 = 1/(4 R^2) that the axis column's step takes: its outer corners lie on nodes with four times
// the mass that it gives them. Held by tests/impact against eigenvalues of the column with its neighbour.
inline constexpr double axis_hoop_share = 0.25;

// What decides the stable step of an element (docs/theory/impact.md, "Stable step").
// stiffness = 1/dt^2 of the undamped element, over_stretch = sum of w_i / lambda_i^2, the share that viscosity acts through.
template <class V>
struct StepBound {
  V stiffness, over_stretch;
};
// volumetric = J^2 U''(J), U being the volumetric energy.
template <class V, class C, class Side>
PERCAL_INLINE StepBound<V> step_bound_with(V volumetric, const Stretches<V>& s, const IsochoricPowers<V>& g,
                                           const PrincipalStress<V>& t, C mu, Side per_width2, Side per_height2,
                                           Side per_hoop2) {
  using Real = RealOf<V>;
  const V common = volumetric + (mu * Real(2.0 / 9)) * (g.first + g.second + g.hoop);
  const C three = mu * Real(2.0 / 3);
  const V along = Real(0.5) * s.half_difference * s.inverse_split;  // (n_1r^2 - n_1z^2)/2
  const V w1 = ((Real(0.5) + along) * per_width2 + (Real(0.5) - along) * per_height2) * s.inverse_first2;
  const V w2 = ((Real(0.5) - along) * per_width2 + (Real(0.5) + along) * per_height2) * s.inverse_second2;
  const V w3 = per_hoop2 * s.inverse_hoop * s.inverse_hoop;
  return {(common + three * g.first - t.first) * w1 + (common + three * g.second - t.second) * w2 +
              (common + three * g.hoop - t.hoop) * w3,
          w1 + w2 + w3};
}

// The same with U = K/4 (J^2 - 1 - 2 ln J).
template <class V>
PERCAL_INLINE StepBound<V> step_bound(const Stretches<V>& s, const IsochoricPowers<V>& g, const PrincipalStress<V>& t,
                                      RealOf<V> mu, RealOf<V> bulk, RealOf<V> per_width2, RealOf<V> per_height2,
                                      RealOf<V> per_hoop2) {
  return step_bound_with(volumetric_stiffness(PressureLaw::log_quadratic, s.jacobian, bulk), s, g, t, mu, per_width2,
                         per_height2, per_hoop2);
}

}  // namespace percal::PERCAL_LEVEL
