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

template <class Real>
PERCAL_INLINE Real bounded_limit(double limit) {
  return Real(limit < no_erosion ? limit : largest_number);
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
      .erosion_limit = bounded_limit<Real>(m.erosion_stretch * m.erosion_stretch),
      .smallest_jacobian = Real(m.smallest_jacobian),
      .largest_inverse_step = Real(m.largest_inverse_step < largest_number ? m.largest_inverse_step : largest_number)};
}

// Of an element's sides, as the stable step takes them: docs/theory/impact.md (14).
template <class Real>
struct InverseSides {
  Real width2, height2, hoop2;
};

// The limit of the element itself: it goes where the measure exceeds that half a step ahead. docs/theory/impact.md (21).
template <class V, class C>
PERCAL_INLINE auto beyond_own_limit(V now, V change, C limit) {
  return now + RealOf<V>(0.5) * change > limit;
}

// The limit of an average: elements beyond it are marked as candidates, with what they will have come to at the next look and half
// a step, and those go that have been condemned since the last one. docs/theory/impact.md (23).
template <class Real>
struct AveragedLimit {
  Real *foreseen_measure, *alive;  // of the column

  template <class V, class C>
  PERCAL_INLINE auto condemned_ones(int j, V state, V now, V change, C limit, bool again, ColumnReport& report) const {
    const auto live = state > Real(0);
    if (again) return live & ~live;  // a second look at one moment decides nothing
    const V foreseen = now + Real(1.5) * change;
    store(foreseen_measure + j, foreseen);
    const auto gone = live & (state < Real(candidate)), beyond = live & ~gone & (foreseen > limit);
    if (__builtin_expect(any(beyond), 0)) {
      store(alive + j, select(beyond, broadcast<V>(Real(candidate)), state));
      if (report.candidates.empty()) report.candidates.begin = j;
      report.candidates.end = j + Lane<V>::count;
    }
    return gone;
  }
};

template <class Real>
PERCAL_INLINE AveragedLimit<Real> averaged_limit(const FieldsView<Real>& fields, int column) {
  const long first = static_cast<long>(column) * fields.stride;
  return {fields.foreseen_measure + first, fields.alive + first};
}

// In r and z.
template <class V>
struct CornerForce {
  V r, z;
};

template <class Real>
class UniformSolid {
 public:
  static constexpr bool in_pairs = true;  // groups of rows may be two vectors side by side

  UniformSolid(const MaterialConstants& material, const ColumnShape& shape)
      : constants_(solid_constants<Real>(material, shape)) {}

  // Rows j to j + lanes come next.
  PERCAL_INLINE const SolidConstants<Real>& at(int) const { return constants_; }
  // From the gradient over the mesh to that over the unstretched solid, and back from its first Piola stress and from an energy per
  // volume of it: the plain solid has no initial stretch.
  template <class V>
  PERCAL_INLINE void add_initial_stretch(Gradient<V>&) const {}
  template <class V>
  PERCAL_INLINE void refer_to_mesh(Piola<V>&) const {}
  template <class V>
  PERCAL_INLINE V per_mesh_volume(V energy) const { return energy; }
  // From the displacements of the mode.
  template <class V>
  PERCAL_INLINE CornerForce<V> hourglass_force(int, V mode_r, V mode_z) const {
    return {mode_r * constants_.hourglass, mode_z * constants_.hourglass};
  }
  // The volumetric part of each principal Kirchhoff stress, bulk viscosity q included.
  template <class V>
  PERCAL_INLINE V volumetric_stress(const Stretches<V>& s, V q) const {
    return kirchhoff_pressure(PressureLaw::log_quadratic, s.jacobian, constants_.bulk) - q * s.jacobian;
  }
  template <class V>
  PERCAL_INLINE void add_further_stress(int, const Gradient<V>&, const Stretches<V>&, const PrincipalStress<V>&,
                                        Piola<V>&) const {}
  template <class V>
  PERCAL_INLINE StepBound<V> bound_of_step(const Stretches<V>& s, const IsochoricPowers<V>& g,
                                           const PrincipalStress<V>& t, const InverseSides<Real>& per) const {
    return step_bound(s, g, t, constants_.mu, constants_.bulk, per.width2, per.height2, per.hoop2);
  }
  // 1/dt of the element, `drag` by viscosity.
  template <class V>
  PERCAL_INLINE V inverse_step(const StepBound<V>& bound, V drag) const {
    return square_root(larger(bound.stiffness, broadcast<V>(Real(0))) + drag * drag) + drag;
  }
  // The largest squared stretch.
  template <class V>
  PERCAL_INLINE V erosion_measure(const Gradient<V>& F, const Stretches<V>& s, const IsochoricPowers<V>&,
                                  const Piola<V>&, V) const {
    return larger(s.first2, F.hoop * F.hoop);
  }
  // Those that go for having reached the limit, of a measure that is `now` and has grown by `change` since the last look; at
  // one that looks again at what has not moved, both are as they were.
  template <class V>
  PERCAL_INLINE auto at_limit(int, V, V now, V change, bool, ColumnReport&) const {
    return beyond_own_limit(now, change, constants_.erosion_limit);
  }
  // The group is done: `live` elements go on, `gone` ones were taken out by this look.
  template <class Mask>
  PERCAL_INLINE void close_group(int, Mask, Mask) const {}
  void report(double, ColumnReport&) const {}

 protected:
  SolidConstants<Real> constants_;
};

// The plain solid with erosion judged by an average of the energy: the measure is W of docs/theory/impact.md (2).
template <class Real>
class AveragedSolid : public UniformSolid<Real> {
 public:
  AveragedSolid(const MaterialConstants& material, const ColumnShape& shape, const FieldsView<Real>& fields, int column)
      : UniformSolid<Real>(material, shape),
        energy_scale_(Real(2 * material.mu / (material.alpha * material.alpha))),
        limit_(averaged_limit(fields, column)) {
    this->constants_.erosion_limit = bounded_limit<Real>(material.erosion_limit);
  }

  template <class V>
  PERCAL_INLINE V erosion_measure(const Gradient<V>&, const Stretches<V>& s, const IsochoricPowers<V>& g,
                                  const Piola<V>&, V) const {
    return strain_energy(PressureLaw::log_quadratic, s, g, energy_scale_, this->constants_.bulk);
  }
  template <class V>
  PERCAL_INLINE auto at_limit(int j, V state, V now, V change, bool again, ColumnReport& report) const {
    return limit_.condemned_ones(j, state, now, change, this->constants_.erosion_limit, again, report);
  }

 private:
  const Real energy_scale_;
  const AveragedLimit<Real> limit_;
};

}  // namespace percal::PERCAL_LEVEL
