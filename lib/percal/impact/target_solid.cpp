#include "percal/impact/target_solid.hpp"

#include <stdexcept>

#include "percal/impact/constants.hpp"

namespace percal {
namespace {

PressureLaw pressure_law_of(VolumetricLaw law) {
  switch (law) {
    case VolumetricLaw::quadratic: return PressureLaw::quadratic;
    case VolumetricLaw::logarithmic: return PressureLaw::logarithmic;
    case VolumetricLaw::log_quadratic: break;
  }
  return PressureLaw::log_quadratic;
}

ErosionKind erosion_kind_of(const Erosion& erosion) {
  if (std::holds_alternative<StressErosion>(erosion)) return ErosionKind::stress;
  return std::holds_alternative<EnergyErosion>(erosion) ? ErosionKind::energy : ErosionKind::stretch;
}

}  // namespace

TargetSolid::TargetSolid(const MaterialConstants& plain) : layers{{0, 1, plain}} {}

TargetSolid::TargetSolid(const Problem& problem, const std::vector<LayerRows>& rows)
    : pressure_law(pressure_law_of(problem.volumetric_law)),
      hourglass_kind(problem.hourglass_form == HourglassForm::viscosity ? HourglassKind::viscosity
                                                                        : HourglassKind::stiffness),
      erosion_kind(erosion_kind_of(problem.erosion)) {
  const std::vector<MaterialConstants> materials = constants_of_layers(problem);
  for (std::size_t k = 0; k < rows.size(); ++k)
    if (k == 0 || rows[k].begin < rows[k].end) layers.push_back({rows[k].begin, rows[k].end, materials[k]});
  if (const auto* series = std::get_if<PronySeries>(&problem.relaxation))
    for (const PronyTerm& term : series->terms) relaxation.push_back({term.share, term.time});
  if (relaxation.size() > most_relaxing_terms) throw std::invalid_argument("a Prony series of more than three terms");
}

bool TargetSolid::is_plain() const {
  return layers.size() == 1 && pressure_law == PressureLaw::log_quadratic &&
         hourglass_kind == HourglassKind::stiffness && erosion_kind == ErosionKind::stretch && relaxation.empty();
}

const MaterialConstants& TargetSolid::of_row(int row) const {
  std::size_t k = 0;
  while (k + 1 < layers.size() && row >= layers[k].end) ++k;
  return layers[k].material;
}

bool TargetSolid::erodes(int row) const {
  const MaterialConstants& material = of_row(row);
  return (erosion_kind == ErosionKind::stretch ? material.erosion_stretch : material.erosion_limit) < no_erosion;
}

double TargetSolid::lasting_share() const {
  double share = 1;
  for (const RelaxingTerm& term : relaxation) share -= term.share;
  return share;
}

template <class Real>
GeneralSolidView<Real> TargetSolid::view(const Block<Real>& block) const {
  GeneralSolidView<Real> view{.layers = layers.data(),
                              .layer_count = static_cast<int>(layers.size()),
                              .pressure_law = pressure_law,
                              .hourglass_kind = hourglass_kind,
                              .erosion_kind = erosion_kind,
                              .hourglass = block.hourglass_velocity(),
                              .relaxation = block.relaxation()};
  view.relaxation.terms = static_cast<int>(relaxation.size());
  for (std::size_t k = 0; k < relaxation.size(); ++k) view.relaxation.term[k] = relaxation[k];
  return view;
}

template GeneralSolidView<float> TargetSolid::view(const Block<float>&) const;
template GeneralSolidView<double> TargetSolid::view(const Block<double>&) const;

}  // namespace percal
