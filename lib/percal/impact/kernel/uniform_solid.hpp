// The plain solid: one layer of the compressible Ogden solid, elastic, with hourglass springs, eroding by strain or not
// at all. Its constants are numbers that the compiler keeps in registers, and its verbs are the formulas of
// element.hpp. What else a target can be is general_solid.hpp. Both answer to the same verbs, in the order in which
// internal_forces.hpp asks.
#pragma once
#include "percal/impact/kernel/element.hpp"
#include "percal/impact/kernel/kernel.hpp"

namespace percal::PERCAL_LEVEL {

template <class Real>
struct VectorOf;
template <>
struct VectorOf<float> {
  using type = FloatLanes::Vector;
};
template <>
struct VectorOf<double> {
  using type = DoubleLanes::Vector;
};

inline constexpr double largest_number = 1e30;  // stands for infinity in single precision

// Constants of the rows at hand: numbers, or lanes where rows differ.
template <class C>
struct SolidConstants {
  C mu, bulk, alpha, two_mu_over_alpha;
  C hourglass;  // force on a corner over the mode's displacement
  C linear_viscosity, quadratic_viscosity;
  C erosion_limit;  // of what erosion_measure() returns
  C smallest_jacobian, largest_inverse_step;
};

PERCAL_INLINE double hourglass_stiffness(const MaterialConstants& m, const ColumnShape& shape) {
  return m.hourglass * m.mu / 12 * (shape.height / shape.width + shape.width / shape.height) * shape.thickness;
}

// With the hourglass spring and erosion by stretch.
template <class Real>
PERCAL_INLINE SolidConstants<Real> solid_constants(const MaterialConstants& m, const ColumnShape& shape) {
  return {
      .mu = Real(m.mu),
      .bulk = Real(m.bulk),
      .alpha = Real(m.alpha),
      .two_mu_over_alpha = Real(2 * m.mu / m.alpha),
      .hourglass = Real(hourglass_stiffness(m, shape)),
      .linear_viscosity = Real(m.linear_viscosity),
      .quadratic_viscosity = Real(m.quadratic_viscosity),
      .erosion_limit = Real(m.erosion_stretch < no_erosion ? m.erosion_stretch * m.erosion_stretch : largest_number),
      .smallest_jacobian = Real(m.smallest_jacobian),
      .largest_inverse_step = Real(m.largest_inverse_step < largest_number ? m.largest_inverse_step : largest_number)};
}

// Of an element's sides, as the stable step takes them: docs/theory/impact.md (14).
template <class Real>
struct InverseSides {
  Real width2, height2, hoop2;
};

// In r and z.
template <class V>
struct CornerForce {
  V r, z;
};

template <class Real>
class UniformSolid {
 public:
  using V = typename VectorOf<Real>::type;

  UniformSolid(const MaterialConstants& material, const ColumnShape& shape)
      : constants_(solid_constants<Real>(material, shape)) {}

  // Rows j to j + lanes come next.
  PERCAL_INLINE const SolidConstants<Real>& at(int) const { return constants_; }
  // From the displacements of the mode.
  PERCAL_INLINE CornerForce<V> hourglass_force(int, V mode_r, V mode_z) const {
    return {mode_r * constants_.hourglass, mode_z * constants_.hourglass};
  }
  // The volumetric part of each principal Kirchhoff stress, bulk viscosity q included.
  PERCAL_INLINE V volumetric_stress(const Stretches<V>& s, V q) const {
    return kirchhoff_pressure(PressureLaw::log_quadratic, s.jacobian, constants_.bulk) - q * s.jacobian;
  }
  PERCAL_INLINE void relax(int, const Gradient<V>&, const Stretches<V>&, const PrincipalStress<V>&, Piola<V>&) const {}
  PERCAL_INLINE StepBound<V> bound_of_step(const Stretches<V>& s, const IsochoricPowers<V>& g,
                                           const PrincipalStress<V>& t, const InverseSides<Real>& per) const {
    return step_bound(s, g, t, constants_.mu, constants_.bulk, per.width2, per.height2, per.hoop2);
  }
  // 1/dt of the element, `drag` by viscosity.
  PERCAL_INLINE V inverse_step(const StepBound<V>& bound, V drag) const {
    return square_root(larger(bound.stiffness, V{}) + drag * drag) + drag;
  }
  // The largest squared stretch.
  PERCAL_INLINE V erosion_measure(const Gradient<V>& F, const Stretches<V>& s, const IsochoricPowers<V>&,
                                  const Piola<V>&, V) const {
    return larger(s.first2, F.hoop * F.hoop);
  }
  // The group is done: `live` elements go on, `gone` ones were taken out by this look.
  template <class Mask>
  PERCAL_INLINE void close_group(int, Mask, Mask) const {}
  void report(double, ColumnReport&) const {}

 private:
  SolidConstants<Real> constants_;
};

}  // namespace percal::PERCAL_LEVEL
