// Energies of elements and nodes, in double whatever the fields are kept in. Per radian.
#pragma once
#include "percal/impact/result.hpp"
#include "percal/impact/state.hpp"

namespace percal {

struct ElementEnergy {
  double elastic = 0;
  double hourglass = 0;
  double last_work = 0;        // half of what its corner forces would have done over the last step: f . v dt/2
  double largest_stretch = 1;  // principal, the hoop included
};

// Of element (column, row) as it stands. last_step is the step that led here.
template <class Real>
ElementEnergy element_energy(const Block<Real>&, const MaterialConstants&, int column, int row, double last_step);

// What the elements and nodes hold now; velocities must stand at the same time as displacements.
// Fills live_kinetic, freed_mass, elastic and hourglass, not yet divided by the impact energy.
template <class Real>
EnergyLedger stored_energy(const Block<Real>&, const MaterialConstants&);

}  // namespace percal
