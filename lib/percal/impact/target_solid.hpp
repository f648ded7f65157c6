// What the target is made of, as the kernels and the ledger take it.
#pragma once
#include <vector>

#include "percal/impact/state.hpp"

namespace percal {

struct TargetSolid {
  TargetSolid(const MaterialConstants& plain);  // one layer of the plain solid
  TargetSolid(const Problem& problem, const std::vector<LayerRows>& rows);

  std::vector<SolidLayer> layers;
  PressureLaw pressure_law = PressureLaw::log_quadratic;
  HourglassKind hourglass_kind = HourglassKind::stiffness;
  ErosionKind erosion_kind = ErosionKind::stretch;
  std::vector<RelaxingTerm> relaxation;

  // Whether Kernel::internal_forces will do, which knows no more than the plain solid.
  bool is_plain() const;
  const MaterialConstants& of_row(int row) const;
  bool erodes(int row) const;
  double lasting_share() const;  // of mu, when all has relaxed

  // What the kernel takes; holds while this object and the block stay where they are.
  template <class Real>
  GeneralSolidView<Real> view(const Block<Real>& block) const;
};

}  // namespace percal
