// Fibres in the plane of a layer, all directions of it alike, with some dispersion out of it (T. C. Gasser, R. W. Ogden and G. A.
// Holzapfel, J. R. Soc. Interface 3, 2006, 15). docs/theory/target.md (18) to (20).
#pragma once
#include "percal/impact/kernel/relaxing_stress.hpp"

namespace percal::PERCAL_LEVEL {

// exp(k2 E^2) grows no further from here on: far beyond what a fibre bears, and within the range of single precision.
inline constexpr double largest_fibre_exponent = 40;

// Of a solid per undeformed volume.
template <class V>
struct FibreResponse {
  Piola<V> stress;  // first Piola
  V energy;
  V stiffness;      // bounds what each direction's modulus gains: StepBound::stiffness over over_stretch
};

template <class V>
PERCAL_INLINE V exponential(V x) {
  return exp2_of(x * RealOf<V>(1.44269504088896340736));
}
PERCAL_INLINE double exponential(double x) { return __builtin_exp(x); }
PERCAL_INLINE double zero_unless(bool holds, double x) { return holds ? x : 0; }
template <class V, class Mask>
PERCAL_INLINE V zero_unless(Mask holds, V x) {
  return select(holds, x, V{});
}

template <class V, class C>
PERCAL_INLINE FibreResponse<V> fibre_response(const Gradient<V>& F, const Stretches<V>& s, C k1, C k2, C kappa) {
  using Real = RealOf<V>;
  const C through = Real(1) - Real(2) * kappa;  // share of z
  const V isochoric = exponential(natural_log(s.jacobian) * Real(-2.0 / 3));
  const V mean = (kappa * (F.rr * F.rr + F.zr * F.zr + F.hoop * F.hoop) + through * (F.rz * F.rz + F.zz * F.zz)) *
                 Real(1.0 / 3);  // of H:C
  const V strain = isochoric * (Real(3) * mean) - Real(1);
  const auto taut = strain > Real(0);
  const V exponent = smaller(k2 * strain * strain, broadcast<V>(Real(largest_fibre_exponent)));
  const V grown = exponential(exponent);
  const V slope = zero_unless(taut, k1 * strain * grown);                                  // dW/dE
  const V curvature = zero_unless(taut, k1 * (Real(1) + Real(2) * exponent) * grown);      // d2W/dE2
  // dE/dF = 2 J^(-2/3) (F H - (H:C/3) F^-T).
  const V per_area = s.inverse_jacobian * F.hoop * mean;
  const V two = Real(2) * isochoric;
  const Piola<V> change{two * (kappa * F.rr - per_area * F.zz), two * (through * F.rz + per_area * F.zr),
                        two * (kappa * F.zr + per_area * F.rz), two * (through * F.zz - per_area * F.rr),
                        two * (kappa * F.hoop - mean * s.inverse_hoop)};
  const Symmetric<V> pushed_change = kirchhoff(F, change);
  return {{slope * change.rr, slope * change.rz, slope * change.zr, slope * change.zz, slope * change.hoop},
          zero_unless(taut, k1 * (Real(0.5) / k2) * (grown - Real(1))),
          curvature * contracted(pushed_change, pushed_change) + Real(2) * slope * (strain + Real(1))};
}

}  // namespace percal::PERCAL_LEVEL
