// What march, kernel and ledger take from a problem before the first step: mesh, solid, limits of the step.
#pragma once
#include <vector>

#include "percal/impact/kernel/kernel.hpp"
#include "percal/impact/target/block.hpp"
#include "percal/mesh/graded.hpp"
#include "percal/problem/problem.hpp"

namespace percal {

GradedMesh mesh_of(const Problem& problem);
ErosionKind erosion_kind_of(const Problem& problem);
std::vector<MaterialConstants> constants_of_layers(const Problem& problem);

// What the target is made of.
struct TargetSolid {
  TargetSolid(const MaterialConstants& plain);  // one layer of the plain solid
  TargetSolid(const Problem& problem, const std::vector<LayerRows>& rows);

  std::vector<SolidLayer> layers;
  PressureLaw pressure_law = PressureLaw::log_quadratic;
  HourglassKind hourglass_kind = HourglassKind::stiffness;
  ErosionKind erosion_kind = ErosionKind::stretch;
  std::vector<RelaxingTerm> relaxation;

  // Whether a kernel will do that knows no more than the plain solid: Kernel::internal_forces, internal_forces_averaged.
  bool is_plain() const;
  bool has_fibres() const;    // some layer
  bool is_stretched() const;  // some layer, before the impact
  const MaterialConstants& of_row(int row) const;
  bool erodes(int row) const;
  double lasting_share() const;  // of mu, when all has relaxed
  double limit_of(const MaterialConstants& material) const;  // of what erosion is judged by

  // What the kernel takes; holds while this object and the block stay where they are.
  template <class Real>
  GeneralSolidView<Real> view(Block<Real>& block) const;
};

struct StepLimits {
  // Stable step of the undeformed square element, the least of all layers, without the time-step factor.
  double first_step;
  double time_step_factor;  // the problem's, or less where the impact is supersonic
};
StepLimits step_limits(const Problem& problem);

}  // namespace percal
