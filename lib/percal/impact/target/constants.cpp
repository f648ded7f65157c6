#include "percal/impact/target/constants.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "percal/impact/settings.hpp"
#include "percal/impact/target/initial_stretch.hpp"
#include "percal/material/prony.hpp"
#include "percal/problem/domain.hpp"

namespace percal {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

double smallest_gap(const std::vector<double>& nodes) {
  double gap = nodes[1] - nodes[0];
  for (std::size_t i = 2; i < nodes.size(); ++i) gap = std::min(gap, nodes[i] - nodes[i - 1]);
  return gap;
}

double inverse_square(double side) { return 1 / (side * side); }

// The sum of 1/h^2 over the sides of the smallest element.
double inverse_squares_of_sides(const Problem& p) {
  if (p.geometry == Geometry::block) {
    const BoxGrid grid = box_grid(box_options(p));
    return inverse_square(smallest_gap(grid.x)) + inverse_square(smallest_gap(grid.y)) +
           inverse_square(smallest_gap(grid.z));
  }
  const GradedMesh mesh = mesh_of(p);
  return inverse_square(smallest_gap(mesh.radius)) + inverse_square(mesh.row_height);
}

double undeformed_step(double inverse_squares, double mu, double bulk) {
  return 1 / std::sqrt((bulk + 4.0 / 3 * mu) * inverse_squares);
}

bool is_supersonic(const Problem& p) { return mach_number(p) * p.speed_factor >= 1; }

struct Layer {
  double mu, bulk, alpha, density;
  double erosion_limit;  // as the scene means it
  FurtherErosion further_erosion = {};
  double stretch;  // of its plane, before the impact
  Fibres fibres;
  bool erodes() const { return erosion_limit < infinite || !further_erosion.is_empty(); }
  double wave_speed() const { return std::sqrt((bulk + 4.0 / 3 * mu) / density); }
};

struct LimitOf {
  double operator()(const NoErosion&) const { return infinite; }
  template <class Kind>
  double operator()(const Kind& erosion) const {
    return erosion.limit;
  }
};

std::vector<Layer> layers_of(const Problem& p) {
  std::vector<Layer> layers{
      {p.mu(), p.bulk(), p.alpha, 1, std::visit(LimitOf{}, p.erosion), p.further_erosion, p.stretch, p.fibres}};
  const bool erodes = !std::holds_alternative<NoErosion>(p.erosion);
  for (const LowerLayer& below : p.below)
    layers.push_back({below.mu, below.bulk_ratio * below.mu, below.alpha, below.density,
                      erodes ? below.erosion_limit : infinite, erodes ? below.further_erosion : FurtherErosion{},
                      below.stretch, below.fibres});
  return layers;
}

PressureLaw pressure_law_of(VolumetricLaw law) {
  switch (law) {
    case VolumetricLaw::quadratic: return PressureLaw::quadratic;
    case VolumetricLaw::logarithmic: return PressureLaw::logarithmic;
    case VolumetricLaw::log_quadratic: break;
  }
  return PressureLaw::log_quadratic;
}

// Of fibres in tension along the layer's plane.
double uniaxial_fibre_energy(const Fibres& fibres, double stretch) {
  const auto* planar = std::get_if<PlanarFibres>(&fibres);
  if (!planar) return 0;
  const double across = 1 / std::sqrt(stretch);
  const scalar::Gradient<double> F{stretch, 0, 0, across, across};
  return scalar::fibre_response(F, scalar::stretches(F), planar->k1, planar->k2, planar->kappa).energy;
}

// The energy density that a layer has in uniaxial tension at this stretch, volume kept: impact.md (24).
double uniaxial_energy(const Layer& layer, double stretch) {
  return 2 * layer.mu / (layer.alpha * layer.alpha) *
             (std::pow(stretch, layer.alpha) + 2 * std::pow(stretch, -layer.alpha / 2) - 3) +
         uniaxial_fibre_energy(layer.fibres, stretch);
}

// What a layer's measure of erosion may not exceed.
void set_erosion_limit(MaterialConstants& c, const Layer& layer, const Problem& p) {
  const auto* strain = std::get_if<StrainErosion>(&p.erosion);
  const double stretch = strain ? stretch_at(layer.erosion_limit, strain->measure) : infinite;
  switch (erosion_kind_of(p)) {
    case ErosionKind::stretch: c.erosion_stretch = stretch; break;
    case ErosionKind::averaged_energy:
      c.erosion_limit = strain && stretch < infinite ? uniaxial_energy(layer, stretch) : layer.erosion_limit;
      break;
    case ErosionKind::stress:
    case ErosionKind::energy: c.erosion_limit = layer.erosion_limit; break;
    case ErosionKind::several:
      c.erosion_stretch = stretch;
      c.stress_limit = layer.further_erosion.stress.value_or(infinite);
      c.energy_limit = layer.further_erosion.energy.value_or(infinite);
      if (std::holds_alternative<StressErosion>(p.erosion)) c.stress_limit = layer.erosion_limit;
      break;
  }
}

}  // namespace

ErosionKind erosion_kind_of(const Problem& p) {
  if (std::holds_alternative<NoErosion>(p.erosion)) return ErosionKind::stretch;
  if (!p.further_erosion.is_empty()) return ErosionKind::several;
  if (std::holds_alternative<StressErosion>(p.erosion)) return ErosionKind::stress;
  if (std::holds_alternative<AverageWithin>(p.erosion_average)) return ErosionKind::averaged_energy;
  return std::holds_alternative<EnergyErosion>(p.erosion) ? ErosionKind::energy : ErosionKind::stretch;
}

GradedMesh mesh_of(const Problem& p) {
  const GradedMesh right = graded_mesh(mesh_options(p));
  return p.whole ? mirrored(right) : right;
}

std::vector<MaterialConstants> constants_of_layers(const Problem& p) {
  const bool shock = is_supersonic(p);
  const double linear = shock ? std::max(p.linear_viscosity, supersonic_linear) : p.linear_viscosity;
  const double quadratic = shock ? std::max(p.quadratic_viscosity, supersonic_quadratic) : p.quadratic_viscosity;
  const auto* series = std::get_if<PronySeries>(&p.relaxation);
  const double lasting = series ? lasting_share(*series) : 1;
  const double sides = inverse_squares_of_sides(p);
  std::vector<MaterialConstants> layers;
  for (const Layer& layer : layers_of(p)) {
    MaterialConstants c{.mu = layer.mu,
                        .bulk = layer.bulk,
                        .alpha = layer.alpha,
                        .hourglass = p.hourglass,
                        .linear_viscosity = linear * layer.density * layer.wave_speed(),
                        .quadratic_viscosity = quadratic * quadratic * layer.density,
                        .erosion_stretch = infinite,
                        .smallest_jacobian = inverted_jacobian,
                        .largest_inverse_step = infinite,
                        .density = layer.density,
                        .erosion_limit = infinite};
    set_erosion_limit(c, layer, p);
    if (const auto* fibres = std::get_if<PlanarFibres>(&layer.fibres))
      c.fibres = {fibres->k1, fibres->k2, fibres->kappa};
    if (const auto* fibres = std::get_if<FibreFamilies>(&layer.fibres))
      c.fibres = {fibres->k1, fibres->k2, fibres->kappa, true, fibres->angle};
    if (p.geometry != Geometry::block)  // whose stretch of two directions is solid_of_block()'s
      c.initial =
          initial_stretch(layer.stretch, p.geometry,
                          {{layer.mu * lasting, layer.bulk, layer.alpha, pressure_law_of(p.volumetric_law)}, c.fibres});
    if (layer.erodes()) {
      c.smallest_jacobian = distorted_jacobian;
      c.largest_inverse_step =
          1 / (distorted_step * undeformed_step(sides, layer.mu / layer.density, layer.bulk / layer.density));
    }
    layers.push_back(c);
  }
  return layers;
}

TargetSolid::TargetSolid(const MaterialConstants& plain) : layers{{0, 1, plain}} {}

TargetSolid::TargetSolid(const Problem& problem, const std::vector<LayerRows>& rows)
    : pressure_law(pressure_law_of(problem.volumetric_law)),
      hourglass_kind(problem.hourglass_form == HourglassForm::viscosity ? HourglassKind::viscosity
                                                                        : HourglassKind::stiffness),
      erosion_kind(erosion_kind_of(problem)) {
  const std::vector<MaterialConstants> materials = constants_of_layers(problem);
  for (std::size_t k = 0; k < rows.size(); ++k)
    if (k == 0 || rows[k].begin < rows[k].end) layers.push_back({rows[k].begin, rows[k].end, materials[k]});
  if (const auto* series = std::get_if<PronySeries>(&problem.relaxation))
    for (const PronyTerm& term : series->terms) relaxation.push_back({term.share, term.time});
  if (relaxation.size() > most_relaxing_terms) throw std::invalid_argument("a Prony series of more than three terms");
}

bool TargetSolid::is_plain() const {
  return layers.size() == 1 && pressure_law == PressureLaw::log_quadratic &&
         hourglass_kind == HourglassKind::stiffness && relaxation.empty() && !is_stretched() && !has_fibres() &&
         (erosion_kind == ErosionKind::stretch || erosion_kind == ErosionKind::averaged_energy);
}

bool TargetSolid::has_fibres() const {
  return std::ranges::any_of(layers, [](const SolidLayer& layer) { return !layer.material.fibres.is_none(); });
}

bool TargetSolid::is_stretched() const {
  return std::ranges::any_of(layers, [](const SolidLayer& layer) { return !layer.material.initial.is_none(); });
}

const MaterialConstants& TargetSolid::of_row(int row) const {
  std::size_t k = 0;
  while (k + 1 < layers.size() && row >= layers[k].end) ++k;
  return layers[k].material;
}

bool TargetSolid::erodes(int row) const {
  const MaterialConstants& material = of_row(row);
  if (erosion_kind == ErosionKind::several)
    return std::min({material.erosion_stretch, material.stress_limit, material.energy_limit}) < no_erosion;
  return (erosion_kind == ErosionKind::stretch ? material.erosion_stretch : material.erosion_limit) < no_erosion;
}

double TargetSolid::limit_of(const MaterialConstants& material) const {
  switch (erosion_kind) {
    case ErosionKind::several: return 1;
    case ErosionKind::stretch: return material.erosion_stretch * material.erosion_stretch;
    default: return material.erosion_limit;
  }
}

double TargetSolid::lasting_share() const {
  double share = 1;
  for (const auto& term : relaxation) share -= term.share;
  return share;
}

template <class Real>
GeneralSolidView<Real> TargetSolid::view(Block<Real>& block) const {
  GeneralSolidView<Real> view{.layers = layers.data(),
                              .layer_count = static_cast<int>(layers.size()),
                              .pressure_law = pressure_law,
                              .hourglass_kind = hourglass_kind,
                              .erosion_kind = erosion_kind,
                              .hourglass = block.hourglass_velocity(),
                              .relaxation = block.relaxation(),
                              .is_stretched = is_stretched(),
                              .has_fibres = has_fibres()};
  view.relaxation.terms = static_cast<int>(relaxation.size());
  for (std::size_t k = 0; k < relaxation.size(); ++k) view.relaxation.term[k] = relaxation[k];
  return view;
}

template GeneralSolidView<float> TargetSolid::view(Block<float>&) const;
template GeneralSolidView<double> TargetSolid::view(Block<double>&) const;

StepLimits step_limits(const Problem& p) {
  const double sides = inverse_squares_of_sides(p);
  double first_step = infinite;
  for (const Layer& layer : layers_of(p))
    first_step = std::min(first_step, undeformed_step(sides, layer.mu / layer.density, layer.bulk / layer.density));
  return {.first_step = first_step,
          .time_step_factor = is_supersonic(p) ? std::min(p.time_step_factor, supersonic_step) : p.time_step_factor};
}

}  // namespace percal
