#include "percal/impact/target/initial_stretch.hpp"

#include <algorithm>
#include <cmath>

#include "percal/impact/kernel/relaxing_stress.hpp"
#include "percal/impact/target/contents.hpp"

namespace percal {
namespace {

// Of the face's stress; between them is every solid's root.
constexpr double least_log_thickness = -4, most_log_thickness = 4;

template <class Real>
void set(const TensorField<Real>& field, long n, const scalar::Symmetric<double>& a) {
  field.rr[n] = static_cast<Real>(a.rr);
  field.rz[n] = static_cast<Real>(a.rz);
  field.zz[n] = static_cast<Real>(a.zz);
  field.hoop[n] = static_cast<Real>(a.hoop);
}

}  // namespace

scalar::Gradient<double> gradient_of(const InitialStretch& initial) {
  return {initial.r, 0, 0, initial.z, initial.hoop};
}

// By halves in ln of the thickness, to the last bit: the face's stress rises with it.
InitialStretch initial_stretch(double in_plane, Geometry geometry, const ElasticSolid& lasting) {
  if (in_plane == 1) return {};
  InitialStretch initial{.r = in_plane, .z = 1, .hoop = geometry == Geometry::plane_strain ? 1 : in_plane};
  double low = least_log_thickness, high = most_log_thickness;
  for (double middle = 0; middle != low && middle != high; middle = 0.5 * (low + high)) {
    initial.z = std::exp(middle);
    (lasting.first_piola(gradient_of(initial)).zz < 0 ? low : high) = middle;
  }
  return initial;
}

template <class Real>
bool take_initial_state(Block<Real>& block, const TargetSolid& solid) {
  const auto& view = block.view();
  bool whole = true;
  for (int j = 0; j < block.mesh().rows; ++j) {
    const MaterialConstants& material = solid.of_row(j);
    const double measure = erosion_measure(block, solid, 0, j);
    whole &= measure < solid.limit_of(material);
    const auto F = gradient_of(material.initial);
    const auto s = scalar::stretches(F);
    const auto t =
        scalar::isochoric_stress(scalar::isochoric_powers(F, s, material.alpha), 2 * material.mu / material.alpha);
    for (int i = 0; i < block.mesh().columns(); ++i) {
      const long n = block.at(i, j);
      view.jacobian[n] = static_cast<Real>(material.initial.jacobian());
      view.erosion_measure[n] = static_cast<Real>(measure);
      if (view.foreseen_measure) view.foreseen_measure[n] = static_cast<Real>(measure);
      if (block.relaxing_terms() == 0) continue;
      set(block.relaxation().isochoric, n, scalar::second_piola(s, t));
      set(block.relaxation().strain, n, scalar::squared_stretch_less_one(F));
    }
  }
  return whole;
}

template bool take_initial_state(Block<float>&, const TargetSolid&);
template bool take_initial_state(Block<double>&, const TargetSolid&);

}  // namespace percal
