// Fibres of a block's layer: two families in its plane with dispersion (Gasser, Ogden and Holzapfel, J. R. Soc. Interface 3, 2006, 15), or
// all directions of the plane alike, as impact/kernel/fibres.hpp has them. docs/theory/solid.md (12), (13).
#pragma once
#include "percal/impact/kernel/fibres.hpp"
#include "percal/solid/kernel/hexahedron.hpp"

namespace percal::PERCAL_LEVEL::hex {

// Structure tensors of the two families: H with xy, and with -xy. One of diagonal H counts as two of half the modulus.
template <class C>
struct FibreStructure {
  C k1, k2;
  C xx, yy, zz, xy;
};
template <class Real>
PERCAL_INLINE FibreStructure<Real> fibre_structure(const FibreConstants& f) {
  if (!f.in_families)
    return {Real(0.5 * f.k1), Real(f.k2), Real(f.kappa), Real(f.kappa), Real(1 - 2 * f.kappa), Real(0)};
  const double along = __builtin_cos(f.angle), across = __builtin_sin(f.angle), share = 1 - 3 * f.kappa;
  return {Real(f.k1),
          Real(f.k2),
          Real(f.kappa + share * along * along),
          Real(f.kappa + share * across * across),
          Real(f.kappa),
          Real(share * along * across)};
}

template <class V>
struct FibreStress {
  Symmetric<V> kirchhoff;
  V energy;     // per undeformed volume
  V stiffness;  // bounds what each direction's modulus gains: StepBound::stiffness over over_stretch
};

// One family: W = k1/(2 k2) (exp(k2 E^2) - 1) where E = H:C - 1 of the isochoric C is positive.
template <class V, class C>
PERCAL_INLINE void add_family(const Tensor<V>& F, V isochoric, const FibreStructure<C>& h, C xy, FibreStress<V>& sum) {
  using Real = RealOf<V>;
  // K = J^(-2/3) F H F^T, column by column of F H.
  const V ax = F.xx * h.xx + F.xy * xy, bx = F.xx * xy + F.xy * h.yy, cx = F.xz * h.zz;
  const V ay = F.yx * h.xx + F.yy * xy, by = F.yx * xy + F.yy * h.yy, cy = F.yz * h.zz;
  const V az = F.zx * h.xx + F.zy * xy, bz = F.zx * xy + F.zy * h.yy, cz = F.zz * h.zz;
  const Symmetric<V> K{
      isochoric * (ax * F.xx + bx * F.xy + cx * F.xz), isochoric * (ay * F.yx + by * F.yy + cy * F.yz),
      isochoric * (az * F.zx + bz * F.zy + cz * F.zz), isochoric * (ax * F.yx + bx * F.yy + cx * F.yz),
      isochoric * (ax * F.zx + bx * F.zy + cx * F.zz), isochoric * (ay * F.zx + by * F.zy + cy * F.zz)};
  const V strain = trace(K) - Real(1);
  const auto taut = strain > Real(0);
  const V exponent = smaller(h.k2 * strain * strain, broadcast<V>(Real(largest_fibre_exponent)));
  const V grown = exponential(exponent);
  const V slope = zero_unless(taut, h.k1 * strain * grown);                              // dW/dE
  const V curvature = zero_unless(taut, h.k1 * (Real(1) + Real(2) * exponent) * grown);  // d2W/dE2
  const Symmetric<V> deviator = less(K, trace(K) * Real(1.0 / 3));
  const V two = Real(2) * slope;
  sum.kirchhoff = {sum.kirchhoff.xx + two * deviator.xx, sum.kirchhoff.yy + two * deviator.yy,
                   sum.kirchhoff.zz + two * deviator.zz, sum.kirchhoff.xy + two * deviator.xy,
                   sum.kirchhoff.xz + two * deviator.xz, sum.kirchhoff.yz + two * deviator.yz};
  sum.energy = sum.energy + zero_unless(taut, h.k1 * (Real(0.5) / h.k2) * (grown - Real(1)));
  sum.stiffness = sum.stiffness + Real(4) * curvature * trace(square(deviator)) + two * (strain + Real(1));
}

template <class V, class C>
PERCAL_INLINE FibreStress<V> fibre_stress(const Tensor<V>& F, V jacobian, const FibreStructure<C>& h) {
  using Real = RealOf<V>;
  const V isochoric = exponential(natural_log(jacobian) * Real(-2.0 / 3));
  FibreStress<V> sum{};
  add_family(F, isochoric, h, h.xy, sum);
  add_family(F, isochoric, h, -h.xy, sum);
  return sum;
}

}  // namespace percal::PERCAL_LEVEL::hex
