// The loops of a block in three dimensions that take nearly all of its time, behind a table of functions as those of
// impact/kernel/kernel.hpp, for the same instruction levels. Everything is dimensionless (problem/problem.hpp).
#pragma once
#include <array>

#include "percal/impact/kernel/kernel.hpp"

namespace percal {

// The nodes and elements of a block, column after column: entry c * stride + k is node or element k of column c = i (columns of y) + j.
// Owned by SolidBlock. Of const Real: to look at.
template <class Real>
struct SolidFields {
  std::array<Real*, 3> u;  // nodal displacements in x, y, z: never positions
  std::array<Real*, 3> v;  // nodal velocities, half a step behind
  std::array<Real*, 3> f;  // forces on the nodes
  Real* inverse_mass;      // 0 where a node is held
  Real* jacobian;          // J of an element at its last step
  Real* viscous_pressure;  // q of an element at its last step
  Real* erosion_measure;   // what erosion is judged by, at its last step
  Real* alive;             // as FieldsView::alive
  int stride;
};

// Of each row of elements; as long as a column, 1 behind the last.
template <class Real>
struct RowHeights {
  const Real *height, *per_height, *root3;  // h, 1/h, the third root of h
};

struct BoxColumn {
  double width_x, width_y;  // of its elements
};

// Where the forces of one column of elements go. It gives to four columns of nodes; those at the greater x get what this slab of
// elements (one i) gives them, in their fields; those at the smaller x get the sum of two columns of this slab, added to what the slab
// before gave. So a node's force is a sum of pairs, whoever takes which slab: the bits do not depend on the threads.
template <class Real>
struct SlabForces {
  std::array<Real*, 3> inner;              // of node column (i, j)
  bool adds;                               // to what stands there; else it is set
  std::array<const Real*, 3> from_before;  // what column (i, j - 1) gave to it; null where there is none
  std::array<Real*, 3> to_next;            // what this one gives to (i, j + 1)
  std::array<Real*, 3> outer;              // of node column (i + 1, j)
  bool outer_adds;                         // column (i, j - 1) has given to it
  std::array<Real*, 3> outer_next;         // of node column (i + 1, j + 1): set
};

// A face of a rigid convex polyhedron: points with normal . (x - centre) < offset lie behind it.
struct PolyhedronFace {
  std::array<double, 3> normal;  // outward; z downwards
  double offset;
};

// Nodes of one column that the particle may meet.
struct ColumnNodes {
  long first;           // entry of its uppermost node
  double x, y;          // undeformed
  const double* depth;  // undeformed, of each row of nodes
  const void* below;    // Real: of each row, how far below the first one of its group of lanes
  Rows rows;
};

// A block that is more than one layer of the plain solid.
struct LayeredSolidView {
  const SolidLayer* layers;
  int layer_count;
  ErosionKind erosion_kind;
  bool is_stretched, has_fibres;  // some layer
};

template <class Real>
struct SolidKernel {
  // Sets the corner forces of the elements in column `entry` and these rows; marks those to be taken out, which give none. The four
  // columns of nodes begin at `nodes`: (i, j), (i + 1, j), (i, j + 1), (i + 1, j + 1). previous_step as in Kernel::internal_forces.
  void (*internal_forces)(const SolidFields<Real>&, const std::array<long, 4>& nodes, const SlabForces<Real>&, Rows,
                          const BoxColumn&, const RowHeights<Real>&, const MaterialConstants&, double previous_step,
                          ColumnReport&);
  // The same of a block that is more than that.
  void (*internal_forces_layered)(const SolidFields<Real>&, const std::array<long, 4>& nodes, const SlabForces<Real>&,
                                  Rows, const BoxColumn&, const RowHeights<Real>&, const LayeredSolidView&,
                                  double previous_step, ColumnReport&);
  // Writes the rows of the nodes inside a sphere of radius 1 about `centre`, in their order, and returns how many.
  int (*nodes_in_sphere)(const SolidFields<const Real>&, const ColumnNodes&, const std::array<double, 3>& centre,
                         int* found);
  // The same of a convex polyhedron, nothing of which is further than `reach` from `centre`.
  int (*nodes_in_polyhedron)(const SolidFields<const Real>&, const ColumnNodes&, const PolyhedronFace* faces,
                             int face_count, double reach, const std::array<double, 3>& centre, int* found);
  // v += kick f/m, u += drift v for the nodes of a column that begins at `first`. Held directions are not kicked.
  void (*kick_and_drift)(const SolidFields<Real>&, long first, Rows rows, std::array<bool, 3> held, double kick,
                         double drift);
  // Of the first `rows` elements of a column, in double; elastic energy over what the initial stretch has stored.
  StoredEnergy (*stored_energy)(const SolidFields<const Real>&, const std::array<long, 4>& nodes, int rows,
                                const BoxColumn&, const RowHeights<Real>&, const LayeredSolidView&);
  int lanes;
};

// Of instruction_level().
template <class Real>
const SolidKernel<Real>& solid_kernel();
template <>
const SolidKernel<float>& solid_kernel<float>();
template <>
const SolidKernel<double>& solid_kernel<double>();

}  // namespace percal
