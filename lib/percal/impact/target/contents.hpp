// What a block holds as it stands, in double whatever its fields are kept in: energies of its elements and nodes for
// the ledger, states of its cells for an observer. Per radian, or per thickness.
#pragma once
#include "percal/impact/frame.hpp"
#include "percal/impact/kernel/element.hpp"
#include "percal/impact/result.hpp"
#include "percal/impact/target/block.hpp"
#include "percal/impact/target/constants.hpp"

namespace percal {

struct ElementEnergy {
  double elastic = 0;  // what would be left if all that can relax had relaxed, over what it has by its initial stretch
  double hourglass = 0;
  double last_work = 0;  // half of what the forces of these two would have done over the last step: f . v dt/2
};

// Deformation gradient over the mesh at the centre of element (column, row) as it stands; an initial stretch is not in it.
template <class Real>
scalar::Gradient<double> element_gradient(const Block<Real>&, int column, int row);

// Of element (column, row) as it stands. last_step is the step that led here.
template <class Real>
ElementEnergy element_energy(const Block<Real>&, const TargetSolid&, int column, int row, double last_step);

// What erosion is judged by, of element (column, row) as it stands: FieldsView::erosion_measure.
template <class Real>
double erosion_measure(const Block<Real>&, const TargetSolid&, int column, int row);

// Where several criteria decide: the one of which this element has reached the largest share of its limit.
enum class Criterion { strain, stress, energy };
inline long& count_of(ErodedBy& eroded, Criterion criterion) {
  switch (criterion) {
    case Criterion::stress: return eroded.stress;
    case Criterion::energy: return eroded.energy;
    case Criterion::strain: break;
  }
  return eroded.strain;
}
template <class Real>
Criterion leading_criterion(const Block<Real>&, const TargetSolid&, int column, int row);

// What the upper `rows` of elements and their nodes hold now; velocities must stand at the same time as displacements. The
// rest must be at rest. Fills live_kinetic, freed_mass, elastic and hourglass, not yet divided by the impact energy.
template <class Real>
EnergyLedger stored_energy(const Block<Real>&, const TargetSolid&, int rows);

// In the axes that F and the first Piola stress P are given in.
CellState cell_state(const scalar::Gradient<double>& F, const scalar::Piola<double>& P, double energy_density);

// The block's nodes column by column, each from the surface downwards, and its elements in the same order: always all
// of them.
template <class Real>
TargetPiece target_piece(const Block<Real>&, const TargetSolid&);

}  // namespace percal
