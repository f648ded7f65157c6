// Energies U(J) of a change of volume, each with U'' = K at J = 1: what they give to stress and to the stable step. C
// is a number or lanes. docs/theory/target.md (4).
#pragma once
#include "percal/impact/kernel.hpp"
#include "percal/impact/lanes.hpp"

namespace percal::PERCAL_LEVEL {

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

}  // namespace percal::PERCAL_LEVEL
