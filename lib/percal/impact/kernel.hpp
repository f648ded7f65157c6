// The three loops that take nearly all of the time, behind a table of functions: the same source compiled for several
// instruction levels (kernel_level.cpp), one chosen at start. Everything is dimensionless (problem/problem.hpp).
#pragma once
#include <string>

namespace percal {

// The nodes and elements of a block, column after column: entry i * stride + j is node or element (i, j). Owned by State.
template <class Real>
struct FieldsView {
  Real *u_r, *u_z;          // nodal displacements: never positions, whose rounding would heat a mesh in float
  Real *v_r, *v_z;          // nodal velocities, half a step behind
  Real *f_r, *f_z;          // nodal forces
  Real* inverse_mass;       // 0 where a node is held
  Real* contact_stiffness;  // of a node that has a live element, else 0
  Real* jacobian;           // J of an element at the last step
  Real* viscous_pressure;   // q of an element at the last step
  Real* alive;              // 1, or 0 for an eroded element and beyond the last row
  int stride;
};

// One column of elements.
struct ColumnShape {
  double width, height;  // of an element
  double mean_radius;    // of its centre
  bool at_axis;
};

struct MaterialConstants {
  double mu, bulk, alpha;
  double hourglass;             // stiffness of the hourglass mode over mu
  double linear_viscosity;      // times wave speed
  double quadratic_viscosity;   // squared
  double erosion_stretch;       // infinite where nothing erodes
  double smallest_jacobian;     // an element below it is taken out (0: none)
  double largest_inverse_step;  // an element above it is taken out (infinite: none)
};

// What one column of internal forces reports.
struct ColumnReport {
  double viscous_work = 0;          // done by the bulk viscosity in the last step, second order
  double largest_inverse_step = 0;  // 1/dt of the stable step, over live elements
  double smallest_jacobian = 1e30;  // over live elements
  int doomed = 0;                   // how many rows stand in the caller's list
};

struct SphereReport {
  double force = 0;  // that the nodes exert on the sphere, upwards positive
  double spring_energy = 0;
  double largest_gap = 0;  // deepest overlap of a node with the sphere
};

template <class Real>
struct Kernel {
  // Adds the corner forces of column i, rows 0 .. row_end-1, to the node columns i and i+1; node column i+1 is set to zero
  // first, as is node column 0 with i = 0. Lists in `doomed` (room for `stride` entries) the rows whose elements are to be
  // taken out: they gave no force. previous_step is 0 in the first step.
  void (*internal_forces)(const FieldsView<Real>&, int column, int row_end, const ColumnShape&,
                          const MaterialConstants&, double previous_step, int* doomed, ColumnReport&);
  // Adds the penalty forces of a sphere of radius 1 centred at depth `centre` to the nodes of column i, rows [row_begin, row_end).
  void (*sphere_contact)(const FieldsView<Real>&, int column, double radius, double row_height, int row_begin,
                         int row_end, double centre, SphereReport&);
  // v += kick f/m, u += drift v for the nodes of column i, rows 0 .. row_end. The axis moves along itself only.
  void (*kick_and_drift)(const FieldsView<Real>&, int column, int row_end, double kick, double drift);
  int lanes;  // rows are handled in groups of this many; arrays are padded accordingly
};

// The instruction level in use: the best that the processor has, or what the environment variable PERCAL_ISA names
// (x86_64_v2, x86_64_v3, x86_64_v4). Results of different levels differ in their last digits.
// Throws BadInput for a level that is unknown or that this processor lacks.
const std::string& instruction_level();
template <class Real>
const Kernel<Real>& kernel();
template <>
const Kernel<float>& kernel<float>();
template <>
const Kernel<double>& kernel<double>();

}  // namespace percal
