// One-point brick of the compressible one-term Ogden solid (impact/kernel/element.hpp has the energy), over V = a scalar or lanes.
//   docs/theory/solid.md (2) to (10)
#pragma once
#include "percal/impact/kernel/element.hpp"
#include "percal/solid/kernel/principal.hpp"

namespace percal::PERCAL_LEVEL::hex {

// Sums of one component over the corners of a brick, each corner with the product of its signs in these directions (-1 at the
// smaller coordinate). x, y and z are four times what it changes across the brick; the others are the hourglass patterns, which
// a linear field does not have.     docs/theory/solid.md (2)
template <class V>
struct Modes {
  V x, y, z;
  V xy, xz, yz, xyz;
};

// Corners of one component: upper and lower (greater z) of the columns (i, j), (i + 1, j), (i, j + 1), (i + 1, j + 1).
template <class V>
struct Corners8 {
  V upper[4], lower[4];
};

template <class V>
PERCAL_INLINE Modes<V> modes_of(const Corners8<V>& u) {
  const V s0 = u.upper[0] + u.lower[0], s1 = u.upper[1] + u.lower[1], s2 = u.upper[2] + u.lower[2],
          s3 = u.upper[3] + u.lower[3];
  const V d0 = u.lower[0] - u.upper[0], d1 = u.lower[1] - u.upper[1], d2 = u.lower[2] - u.upper[2],
          d3 = u.lower[3] - u.upper[3];
  const V near_x = s1 - s0, far_x = s3 - s2, near_dx = d1 - d0, far_dx = d3 - d2;
  const V near = d0 + d1, far = d2 + d3;
  return {near_x + far_x, (s2 + s3) - (s0 + s1), near + far, far_x - near_x, near_dx + far_dx,
          far - near,     far_dx - near_dx};
}

// A force on every corner from one amplitude for each mode: minus their sum, with the corner's signs.
template <class V>
PERCAL_INLINE Corners8<V> corner_forces(const Modes<V>& m) {
  const V sum = m.x + m.y, difference = m.x - m.y;
  const V flat[4] = {m.xy - sum, difference - m.xy, -difference - m.xy, sum + m.xy};  // the part without z
  const V along = m.xz + m.yz, across = m.xz - m.yz, both = m.z + m.xyz, apart = m.z - m.xyz;
  const V steep[4] = {both - along, apart + across, apart - across, both + along};
  Corners8<V> f;
  for (int c = 0; c < 4; ++c) {
    f.upper[c] = steep[c] - flat[c];
    f.lower[c] = -(flat[c] + steep[c]);
  }
  return f;
}

// Deformation gradient, or first Piola stress: rows are components, columns directions of the undeformed solid.
template <class V>
struct Tensor {
  V xx, xy, xz, yx, yy, yz, zx, zy, zz;
};

template <class V>
PERCAL_INLINE Tensor<V> cofactors(const Tensor<V>& F) {
  return {F.yy * F.zz - F.yz * F.zy, F.yz * F.zx - F.yx * F.zz, F.yx * F.zy - F.yy * F.zx,
          F.xz * F.zy - F.xy * F.zz, F.xx * F.zz - F.xz * F.zx, F.xy * F.zx - F.xx * F.zy,
          F.xy * F.yz - F.xz * F.yy, F.xz * F.yx - F.xx * F.yz, F.xx * F.yy - F.xy * F.yx};
}

// b = F F^T
template <class V>
PERCAL_INLINE Symmetric<V> left_cauchy_green(const Tensor<V>& F) {
  return {F.xx * F.xx + F.xy * F.xy + F.xz * F.xz, F.yx * F.yx + F.yy * F.yy + F.yz * F.yz,
          F.zx * F.zx + F.zy * F.zy + F.zz * F.zz, F.xx * F.yx + F.xy * F.yy + F.xz * F.yz,
          F.xx * F.zx + F.xy * F.zy + F.xz * F.zz, F.yx * F.zx + F.yy * F.zy + F.yz * F.zz};
}

// What of a deformation gradient stress, step and energy need.
template <class V>
struct Deformation {
  Tensor<V> cofactor;
  V jacobian;  // bounded below by 1e-3
  V unbounded_jacobian, inverse_jacobian;
  V mean;              // of the squared stretches
  Symmetric<V> B, B2;  // b - mean 1, and its square
  V trace_of_square;
  Spectrum<V> spectrum;
};

template <class V>
PERCAL_INLINE Deformation<V> deformation_of(const Tensor<V>& F) {
  using Real = RealOf<V>;
  Deformation<V> d;
  d.cofactor = cofactors(F);
  d.unbounded_jacobian = F.xx * d.cofactor.xx + F.xy * d.cofactor.xy + F.xz * d.cofactor.xz;
  d.jacobian = larger(d.unbounded_jacobian, broadcast<V>(Real(1e-3)));
  const Symmetric<V> b = left_cauchy_green(F);
  d.mean = trace(b) * Real(1.0 / 3);
  d.B = less(b, d.mean);
  d.B2 = square(d.B);
  d.trace_of_square = trace(d.B2);
  const V p = larger(square_root(d.trace_of_square * Real(1.0 / 6)), apart<Real> * d.mean);
  const V reciprocal = Real(1) / (p * d.jacobian);
  d.inverse_jacobian = reciprocal * p;
  d.spectrum = spectrum_of(d.B, p, reciprocal * d.jacobian, d.mean);
  return d;
}

// tau F^-T
template <class V>
PERCAL_INLINE Tensor<V> first_piola(const Symmetric<V>& tau, const Deformation<V>& d) {
  const V i = d.inverse_jacobian;
  const V xx = tau.xx * i, yy = tau.yy * i, zz = tau.zz * i, xy = tau.xy * i, xz = tau.xz * i, yz = tau.yz * i;
  const Tensor<V>& C = d.cofactor;
  return {xx * C.xx + xy * C.yx + xz * C.zx, xx * C.xy + xy * C.yy + xz * C.zy, xx * C.xz + xy * C.yz + xz * C.zz,
          xy * C.xx + yy * C.yx + yz * C.zx, xy * C.xy + yy * C.yy + yz * C.zy, xy * C.xz + yy * C.yz + yz * C.zz,
          xz * C.xx + yz * C.yx + zz * C.zx, xz * C.xy + yz * C.yy + zz * C.zy, xz * C.xz + yz * C.yz + zz * C.zz};
}

// 1/dt^2 of the undamped element, and tr Q, the share that viscosity acts through; Q = F^-T diag(1/h^2) F^-1. volumetric is J^2 U'',
// g_mean the mean of the powers.     docs/theory/solid.md (9)
template <class V, class C, class S>
PERCAL_INLINE StepBound<V> step_bound(const Deformation<V>& d, const Symmetric<V>& isochoric, V volumetric, V g_mean,
                                      C mu, C alpha, S per_x2, S per_y2, V per_z2) {
  using Real = RealOf<V>;
  const Tensor<V>& c = d.cofactor;
  const auto weighted = [&](V ax, V ay, V az, V bx, V by, V bz) {
    return ax * bx * per_x2 + ay * by * per_y2 + az * bz * per_z2;
  };
  const Symmetric<V> Q{weighted(c.xx, c.xy, c.xz, c.xx, c.xy, c.xz), weighted(c.yx, c.yy, c.yz, c.yx, c.yy, c.yz),
                       weighted(c.zx, c.zy, c.zz, c.zx, c.zy, c.zz), weighted(c.xx, c.xy, c.xz, c.yx, c.yy, c.yz),
                       weighted(c.xx, c.xy, c.xz, c.zx, c.zy, c.zz), weighted(c.yx, c.yy, c.yz, c.zx, c.zy, c.zz)};
  const V along = isochoric.xx * Q.xx + isochoric.yy * Q.yy + isochoric.zz * Q.zz +
                  Real(2) * (isochoric.xy * Q.xy + isochoric.xz * Q.xz + isochoric.yz * Q.yz);
  const V trace_Q = trace(Q), inverse2 = d.inverse_jacobian * d.inverse_jacobian;
  const V common = volumetric + (Real(4.0 / 3) * mu) * g_mean;
  return {(common * trace_Q + (alpha * Real(1.0 / 3) - Real(1)) * along) * inverse2, trace_Q * inverse2};
}

// Stiffness of the four hourglass patterns of a brick of this volume, over c_hg mu: docs/theory/solid.md (10).
template <class V>
struct HourglassStiffness {
  V xy, xz, yz, xyz;
};
template <class V, class S>
PERCAL_INLINE HourglassStiffness<V> hourglass_stiffness(V scale, S per_x2, S per_y2, V per_z2) {
  using Real = RealOf<V>;
  const V k = scale * Real(1.0 / 48);
  return {k * (per_x2 + per_y2), k * (per_x2 + per_z2), k * (per_y2 + per_z2),
          k * Real(1.0 / 3) * (per_x2 + per_y2 + per_z2)};
}

}  // namespace percal::PERCAL_LEVEL::hex
