// Energies of elements and nodes, in double whatever the fields are kept in. Per radian.
#pragma once
#include "percal/impact/element.hpp"
#include "percal/impact/result.hpp"
#include "percal/impact/state.hpp"
#include "percal/impact/target_solid.hpp"

namespace percal {

struct ElementEnergy {
  double elastic = 0;  // what would be left if all that can relax had relaxed
  double hourglass = 0;
  double last_work = 0;  // half of what the forces of these two would have done over the last step: f . v dt/2
};

// Deformation gradient at the centre of element (column, row) as it stands.
template <class Real>
scalar::Gradient<double> element_gradient(const Block<Real>&, int column, int row);

// Of element (column, row) as it stands. last_step is the step that led here.
template <class Real>
ElementEnergy element_energy(const Block<Real>&, const TargetSolid&, int column, int row, double last_step);

// What the upper `rows` of elements and their nodes hold now; velocities must stand at the same time as displacements. The
// rest must be at rest. Fills live_kinetic, freed_mass, elastic and hourglass, not yet divided by the impact energy.
template <class Real>
EnergyLedger stored_energy(const Block<Real>&, const TargetSolid&, int rows);

}  // namespace percal
