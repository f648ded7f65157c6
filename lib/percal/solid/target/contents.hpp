// What a block in three dimensions holds as it stands, in double whatever its fields are kept in. Of the modelled part: a quarter or a
// half of the whole.
#pragma once
#include "percal/impact/kernel/element.hpp"
#include "percal/impact/result.hpp"
#include "percal/impact/target/contents.hpp"
#include "percal/solid/kernel/hexahedron.hpp"
#include "percal/solid/target/block.hpp"
#include "percal/solid/target/solid_of.hpp"

namespace percal {

// Deformation gradient over the mesh at the centre of an element; an initial stretch is not in it.
template <class Real>
scalar::hex::Tensor<double> element_gradient(const SolidBlock<Real>&, int i, int j, int k);

// As of a block of quads. last_step is the step that led here.
template <class Real>
ElementEnergy element_energy(const SolidBlock<Real>&, const TargetSolid&, int i, int j, int k, double last_step);

// Over the unstretched solid.
template <class Real>
scalar::hex::Tensor<double> whole_gradient(const SolidBlock<Real>&, const TargetSolid&, int i, int j, int k);

// Where several criteria decide: the one of which this element has reached the largest share of its limit.
template <class Real>
Criterion leading_criterion(const SolidBlock<Real>&, const TargetSolid&, int i, int j, int k);

// J and what erosion is judged by at first. False where that alone reaches a limit.
template <class Real>
bool take_initial_state(SolidBlock<Real>&, const TargetSolid&);

// What the upper `rows` of elements and their nodes hold now; velocities must stand at the same time as displacements. The rest must
// be at rest. Not yet divided by the impact energy.
template <class Real>
EnergyLedger stored_energy(const SolidBlock<Real>&, const TargetSolid&, int rows);

// Downwards.
template <class Real>
double momentum(const SolidBlock<Real>&);

// The cut in the plane y = 0, as a piece of quads: x to the right, y upwards, the undeformed surface at y = 0. Where x = 0 is a plane of
// symmetry, its right side. Volumes are areas of the cut.
template <class Real>
TargetPiece cut_piece(const SolidBlock<Real>&, const TargetSolid&);

// All of it, as hexahedra, column by column from the surface down. Volumes are those of the unstretched solid.
template <class Real>
SpaceTarget space_piece(const SolidBlock<Real>&, const TargetSolid&);

}  // namespace percal
