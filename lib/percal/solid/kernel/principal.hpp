// The isochoric stress of the Ogden solid in three dimensions without an eigenvector, over V = a scalar or lanes.
//   docs/theory/solid.md (4) to (8)
#pragma once
#include "percal/math/lanes.hpp"

namespace percal::PERCAL_LEVEL::hex {

template <class V>
struct Symmetric {
  V xx, yy, zz, xy, xz, yz;
};
template <class V>
PERCAL_INLINE V trace(const Symmetric<V>& a) {
  return a.xx + a.yy + a.zz;
}
template <class V>
PERCAL_INLINE V determinant(const Symmetric<V>& a) {
  return a.xx * (a.yy * a.zz - a.yz * a.yz) - a.xy * (a.xy * a.zz - a.yz * a.xz) + a.xz * (a.xy * a.yz - a.yy * a.xz);
}
template <class V>
PERCAL_INLINE Symmetric<V> square(const Symmetric<V>& a) {
  const V xy2 = a.xy * a.xy, xz2 = a.xz * a.xz, yz2 = a.yz * a.yz;
  return {a.xx * a.xx + xy2 + xz2,
          a.yy * a.yy + xy2 + yz2,
          a.zz * a.zz + xz2 + yz2,
          a.xy * (a.xx + a.yy) + a.xz * a.yz,
          a.xz * (a.xx + a.zz) + a.xy * a.yz,
          a.yz * (a.yy + a.zz) + a.xy * a.xz};
}
// a - t 1
template <class V>
PERCAL_INLINE Symmetric<V> less(const Symmetric<V>& a, V t) {
  return {a.xx - t, a.yy - t, a.zz - t, a.xy, a.xz, a.yz};
}

// a + t 1
template <class V>
PERCAL_INLINE Symmetric<V> plus(const Symmetric<V>& a, V t) {
  return {a.xx + t, a.yy + t, a.zz + t, a.xy, a.xz, a.yz};
}

template <class V>
PERCAL_INLINE V magnitude(V x) {
  return larger(x, -x);
}

// Eigenvalues nearer to each other than this, over their mean, are taken apart: the quadratic through them then hardly changes,
// and its coefficients stay numbers.     docs/theory/solid.md (6)
template <class Real>
inline constexpr Real apart = Real(1e-4);
template <>
inline constexpr double apart<double> = 1e-7;

// y in [sqrt(3)/2, 1] with 4 y^3 - 3 y = r, 0 <= r <= 1: the cosine of a third of the angle whose cosine is r. Newton's steps with a
// slope known to 6e-4, from a cubic good to 4e-5: 2e-8 after one, rounding after four.
template <class V>
PERCAL_INLINE V cosine_of_third(V r) {
  using Real = RealOf<V>;
  constexpr int steps = sizeof(Real) == sizeof(float) ? 1 : 4;
  V y = Real(0.8660618516) + r * (Real(0.1654043364) + r * (Real(-0.0408812290) + r * Real(0.0094436169)));
  const V per_slope =
      Real(0.1665727559) + r * (Real(-0.0928920883) + r * (Real(0.0541535572) - r * Real(0.0167917898)));
  for (int k = 0; k < steps; ++k) y = y - (y * (Real(4) * y * y - Real(3)) - r) * per_slope;
  return y;
}

// Eigenvalues of b = mean 1 + B, as they lie from the mean: one apart from the two others, and these. Taken apart where they are near.
template <class V>
struct Spectrum {
  V alone, upper, lower;
  V largest;  // of b itself, not taken apart
};

// From B and its square; p >= apart mean is sqrt(tr B^2/6). docs/theory/solid.md (5).
template <class V>
PERCAL_INLINE Spectrum<V> spectrum_of(const Symmetric<V>& B, V p, V per_p, V mean) {
  using Real = RealOf<V>;
  const V r = Real(0.5) * determinant(B) * per_p * per_p * per_p;
  const auto below = r < Real(0);
  const V y = cosine_of_third(smaller(magnitude(r), broadcast<V>(Real(1))));
  const V py = p * y, middle = select(below, py, -py);
  const V split = Real(1.7320508075688772) * p * square_root(larger(Real(1) - y * y, broadcast<V>(Real(0))));
  const V kept_apart = larger(split, apart<Real> * mean);
  return {.alone = Real(-2) * middle,
          .upper = middle + kept_apart,
          .lower = middle - kept_apart,
          .largest = mean + select(below, middle + split, py + py)};
}

// lambda_bar^alpha of the three, and what their quadratic in B needs: divided differences of first and second order.
template <class V>
struct Powers {
  V alone, upper, lower;
  V first, second;
  PERCAL_INLINE V sum() const { return alone + upper + lower; }
};

// They multiply to 1, so two logarithms will do: lambda_bar_i^6 = b_i^3 / (b_1 b_2 b_3). One division gives the reciprocals of that
// product and of the three differences.     docs/theory/solid.md (7), (8)
template <class V, class C>
PERCAL_INLINE Powers<V> powers_of(const Spectrum<V>& s, V mean, C alpha) {
  using Real = RealOf<V>;
  const V smallest = broadcast<V>(Real(1e-5));
  const V a = larger(mean + s.alone, smallest), u = larger(mean + s.upper, smallest),
          l = larger(mean + s.lower, smallest);
  const V au = s.alone - s.upper, al = s.alone - s.lower, ul = s.upper - s.lower;
  const V product = a * u * l, differences = au * al * ul;
  const V reciprocal = Real(1) / (product * differences);
  const V per_product = reciprocal * differences, per_differences = reciprocal * product;
  const C sixth = alpha * Real(1.0 / 6);
  Powers<V> g;
  g.alone = exp2_of(sixth * log2_of(a * a * a * per_product));
  g.upper = exp2_of(sixth * log2_of(u * u * u * per_product));
  g.lower = Real(1) / (g.alone * g.upper);
  g.first = (g.alone - g.upper) * (per_differences * al * ul);
  g.second = (g.first - (g.upper - g.lower) * (per_differences * au * al)) * (per_differences * au * ul);
  return g;
}

// Kirchhoff's: (2 mu/alpha) dev g(b), the quadratic in B through the three eigenvalues.     docs/theory/solid.md (7)
template <class V, class C>
PERCAL_INLINE Symmetric<V> isochoric_kirchhoff(const Symmetric<V>& B, const Symmetric<V>& B2, V trace_of_square,
                                               const Spectrum<V>& s, const Powers<V>& g, C two_mu_over_alpha) {
  using Real = RealOf<V>;
  const V by_square = two_mu_over_alpha * g.second,
          by_B = two_mu_over_alpha * (g.first - g.second * (s.alone + s.upper));
  const V third = trace_of_square * Real(1.0 / 3);
  return {by_square * (B2.xx - third) + by_B * B.xx, by_square * (B2.yy - third) + by_B * B.yy,
          by_square * (B2.zz - third) + by_B * B.zz, by_square * B2.xy + by_B * B.xy,
          by_square * B2.xz + by_B * B.xz,           by_square * B2.yz + by_B * B.yz};
}

}  // namespace percal::PERCAL_LEVEL::hex
