#include "percal/solid/target/solid_of.hpp"

#include <algorithm>
#include <cmath>

#include "percal/solid/kernel/brick_solid.hpp"

namespace percal {
namespace {

using scalar::hex::Deformation;
using scalar::hex::Symmetric;
using scalar::hex::Tensor;

// Of the face's stress; between them is every solid's root.
constexpr double least_log_thickness = -4, most_log_thickness = 4;

// The thickness that leaves the face free of stress, by halves in its logarithm to the last bit: the face's stress rises with it.
InitialStretch initial_stretch(double along, double across, const MaterialConstants& material) {
  if (along == 1 && across == 1) return {};
  InitialStretch initial{.r = along, .z = 1, .hoop = across};
  double low = least_log_thickness, high = most_log_thickness;
  for (double middle = 0; middle != low && middle != high; middle = 0.5 * (low + high)) {
    initial.z = std::exp(middle);
    (first_piola(material, gradient_of_stretch(initial)).zz < 0 ? low : high) = middle;
  }
  return initial;
}

struct Measures {
  double squared_stretch, tension, energy;
};
Measures measures_of(const MaterialConstants& material, const Tensor<double>& F) {
  const Deformation<double> d = scalar::hex::deformation_of(F);
  return {d.spectrum.largest, scalar::hex::largest_eigenvalue(kirchhoff(material, F, d)) / d.jacobian,
          energy_density(material, F)};
}

}  // namespace

std::vector<LayerRows> layers_of_block(const Problem& problem, const std::vector<double>& depths) {
  const int rows = static_cast<int>(depths.size()) - 1;
  std::vector<LayerRows> layers;
  int begin = 0;
  double bottom = 0;
  const auto add = [&](double thickness, double density, bool last) {
    bottom += thickness;
    const auto below = std::ranges::lower_bound(depths, bottom);
    int end = static_cast<int>(below - depths.begin());
    if (end > 0 && end <= rows && bottom - depths[end - 1] < depths[end] - bottom) --end;
    layers.push_back({begin, last ? rows : std::clamp(end, begin, rows), density});
    begin = layers.back().end;
  };
  add(problem.depth, 1, problem.below.empty());
  for (const LowerLayer& layer : problem.below) add(layer.depth, layer.density, &layer == &problem.below.back());
  return layers;
}

TargetSolid solid_of_block(const Problem& problem, const std::vector<LayerRows>& rows) {
  TargetSolid solid(problem, rows);
  // The solid has no layer that has no row.
  std::size_t kept = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (k > 0 && rows[k].begin == rows[k].end) continue;
    const double along = k == 0 ? problem.stretch : problem.below[k - 1].stretch;
    const auto& across = k == 0 ? problem.stretch_across : problem.below[k - 1].stretch_across;
    MaterialConstants& material = solid.layers[kept++].material;
    material.initial = initial_stretch(along, across.value_or(along), material);
  }
  return solid;
}

LayeredSolidView view_of(const TargetSolid& solid) {
  return {solid.layers.data(), static_cast<int>(solid.layers.size()), solid.erosion_kind, solid.is_stretched(),
          solid.has_fibres()};
}

Symmetric<double> kirchhoff(const MaterialConstants& material, const Tensor<double>& F, const Deformation<double>& d) {
  const auto g = scalar::hex::powers_of(d.spectrum, d.mean, material.alpha);
  auto tau =
      scalar::hex::isochoric_kirchhoff(d.B, d.B2, d.trace_of_square, d.spectrum, g, 2 * material.mu / material.alpha);
  if (!material.fibres.is_none()) {
    const auto fibres = scalar::hex::fibre_stress(F, d.jacobian, scalar::hex::fibre_structure<double>(material.fibres));
    const auto& more = fibres.kirchhoff;
    tau = {tau.xx + more.xx, tau.yy + more.yy, tau.zz + more.zz, tau.xy + more.xy, tau.xz + more.xz, tau.yz + more.yz};
  }
  return scalar::hex::plus(tau, scalar::kirchhoff_pressure(PressureLaw::log_quadratic, d.jacobian, material.bulk));
}

Tensor<double> first_piola(const MaterialConstants& material, const Tensor<double>& F) {
  const auto d = scalar::hex::deformation_of(F);
  return scalar::hex::first_piola(kirchhoff(material, F, d), d);
}

double energy_density(const MaterialConstants& material, const Tensor<double>& F) {
  const auto d = scalar::hex::deformation_of(F);
  const auto g = scalar::hex::powers_of(d.spectrum, d.mean, material.alpha);
  const double matrix = 2 * material.mu / (material.alpha * material.alpha) * (g.sum() - 3) +
                        scalar::volumetric_energy(PressureLaw::log_quadratic, d.jacobian, material.bulk);
  if (material.fibres.is_none()) return matrix;
  return matrix +
         scalar::hex::fibre_stress(F, d.jacobian, scalar::hex::fibre_structure<double>(material.fibres)).energy;
}

double erosion_measure(const TargetSolid& solid, int row, const Tensor<double>& F) {
  const Measures measures = measures_of(solid.of_row(row), F);
  switch (solid.erosion_kind) {
    case ErosionKind::stress: return measures.tension;
    case ErosionKind::several: return std::ranges::max(shares_of_limits(solid, row, F));
    case ErosionKind::stretch: return measures.squared_stretch;
    default: return measures.energy;
  }
}

std::array<double, 3> shares_of_limits(const TargetSolid& solid, int row, const Tensor<double>& F) {
  const Measures measures = measures_of(solid.of_row(row), F);
  const scalar::SharesOfLimits per = scalar::per_limits(solid.of_row(row));
  return {(measures.squared_stretch - 1) * per.stretch, measures.tension * per.stress, measures.energy * per.energy};
}

Tensor<double> gradient_of_stretch(const InitialStretch& initial) {
  return {initial.r, 0, 0, 0, initial.hoop, 0, 0, 0, initial.z};
}

}  // namespace percal
