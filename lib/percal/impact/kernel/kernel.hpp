// The loops that take nearly all of the time, behind a table of functions: the same source compiled for several instruction
// levels (kernel_level.cpp), one chosen at start. Everything is dimensionless (problem/problem.hpp).
#pragma once
#include <string>

namespace percal {

// The nodes and elements of a block, column after column: entry i * stride + j is node or element (i, j). Owned by
// Block. Of const Real: to look at. Motion is written by kick_and_drift (and Sweep::settle), the state of elements by
// internal forces.
template <class Real>
struct FieldsView {
  Real *u_r, *u_z;         // nodal displacements: never positions, whose rounding would heat a mesh in float
  Real *v_r, *v_z;         // nodal velocities, half a step behind
  Real* inverse_mass;      // 0 where a node is held
  Real* touchable;         // 1 for a node that the particle can meet, else 0
  Real* jacobian;          // J of an element at its last step
  Real* viscous_pressure;  // q of an element at its last step
  Real* erosion_measure;   // what erosion is judged by, at its last step
  Real* foreseen_measure;  // the same one and a half steps on; null where no average is taken (averaged_energy)
  Real* alive;  // 1; 0 for an eroded element and beyond the last row; to be taken out after this step: -1 for
                // having reached the limit of erosion, -2 for being distorted; `candidate`, `condemned`
  int stride;
};

// `alive` of elements that bear load and are judged by an average: one that a look has found beyond its own limit, until it is
// judged; one that the average lets go, until the next look (impact/target/averaged_erosion.hpp).
inline constexpr double candidate = 0.75, condemned = 0.5;

// Forces on the nodes of one block, in the same order.
template <class Real>
struct NodeForces {
  Real *r, *z;
};

// Rows [begin, end), both whole groups of lanes; `end` may pass the last row.
struct Rows {
  int begin, end;
  bool empty() const { return begin >= end; }
};

// One column of elements. In plane strain the thickness is 1 and per_radius 0: no hoop strain.
struct ColumnShape {
  double width, height;  // of an element
  double thickness;      // R at its centre (per radian), or 1
  double per_radius;     // 1/R, or 0
  bool at_axis;
};

// What an element of a layer has been stretched by before it came to stand as the mesh has it; its sides are the mesh's.
struct InitialStretch {
  double r = 1, z = 1, hoop = 1;
  double jacobian() const { return r * z * hoop; }
  bool is_none() const { return r == 1 && z == 1 && hoop == 1; }
};

// PlanarFibres of scene/scene.hpp, which brings too much here; in a block FibreFamilies too.
struct FibreConstants {
  double k1 = 0, k2 = 1, kappa = 0.5;
  bool in_families = false;
  double angle = 0;  // of the families with x, to both sides
  bool is_none() const { return k1 == 0; }
};

struct MaterialConstants {
  double mu, bulk, alpha;
  double hourglass;             // stiffness of the hourglass mode over mu, or its viscosity over the wave impedance
  double linear_viscosity;      // times wave speed
  double quadratic_viscosity;   // squared
  double erosion_stretch;       // infinite where nothing erodes
  double smallest_jacobian;     // an element below it is taken out (0: none)
  double largest_inverse_step;  // an element above it is taken out (infinite: none)
  double density = 1;           // over the first layer's
  double erosion_limit =
      1e30;  // of stress or energy density, where that alone decides (ErosionKind); infinite likewise
  // Beside erosion_stretch, where the first limit reached decides (ErosionKind::several); infinite likewise.
  double stress_limit = 1e30, energy_limit = 1e30;
  InitialStretch initial = {};
  FibreConstants fibres = {};
};
inline constexpr double no_erosion = 1e15;  // limits from here on are infinite

// --- a target that is more than one layer of the plain solid (general_solid.hpp) ----------------------------------
enum class PressureLaw {
  log_quadratic,
  quadratic,
  logarithmic
};  // VolumetricLaw of scene/scene.hpp, which brings too much here
enum class HourglassKind { stiffness, viscosity };
enum class ErosionKind { stretch, stress, energy, averaged_energy, several };

struct SolidLayer {
  int begin, end;  // rows of elements
  MaterialConstants material;
};

// One term of a Prony series: its share of the shear modulus and its time.
struct RelaxingTerm {
  double share, time;
};
inline constexpr int most_relaxing_terms = 3;

// A symmetric tensor of each element, as the second Piola stress: in the plane, and hoop.
template <class Real>
struct TensorField {
  Real *rr, *rz, *zz, *hoop;
};

// What relaxation remembers of each element since it was last looked at. No terms: nothing.
template <class Real>
struct RelaxationView {
  int terms = 0;
  RelaxingTerm term[most_relaxing_terms] = {};
  TensorField<Real> overstress[most_relaxing_terms] = {};  // H of each term
  TensorField<Real> isochoric = {};                        // instantaneous isochoric second Piola stress
  TensorField<Real> strain = {};                           // C - 1, C = F^T F
  double* looked_at = nullptr;                             // time, of each cell: groups_per_column a column
  int groups_per_column = 0;
};

// The velocity of an element's hourglass mode at its last step; null where nothing is viscous about it.
template <class Real>
struct HourglassView {
  Real *r = nullptr, *z = nullptr;
};

template <class Real>
struct GeneralSolidView {
  const SolidLayer* layers;
  int layer_count;
  PressureLaw pressure_law;
  HourglassKind hourglass_kind;
  ErosionKind erosion_kind;
  HourglassView<Real> hourglass;
  RelaxationView<Real> relaxation;
  bool is_stretched;  // before the impact: some layer
  bool has_fibres;    // some layer
  double time = 0;    // of the displacements
};

// Where the forces of one column go.
template <class Real>
struct ColumnForces {
  Real *inner_r, *inner_z;  // of node column i: added to, or set where `first`
  Real *outer_r, *outer_z;  // of node column i+1: set
  bool first;
};

// What one column of internal forces reports, added to what stands here.
struct ColumnReport {
  double viscous_work = 0;          // done by bulk and hourglass viscosity in the last step, second order
  double relaxing_work = 0;         // done by the stresses that relax, likewise
  double largest_inverse_step = 0;  // 1/dt of the stable step, over live elements
  double smallest_jacobian = 1e30;  // over live elements
  int doomed = 0;                   // elements marked with alive below 0
  int groups = 0;                   // of lanes that had live elements
  Rows candidates{1 << 30, 0};      // the first and behind the last group that has elements marked as such
};

// A watch for elements that are too stiff for the step they take: flags[row / lanes] is set for those above inverse_step.
struct StiffnessWatch {
  double inverse_step;
  unsigned char* flags;
};

// A side of a rigid convex polygon: points x with normal . (x - centre) < offset lie behind it.
struct PolygonSide {
  double normal_x, normal_z;  // outward; z downwards
  double offset;
};

// Nodes of one column that the particle may meet.
struct ContactNodes {
  int column;
  double x;           // undeformed r or x of the column
  double row_height;  // undeformed distance of two rows
  Rows rows;
};

// Over elements of an average.
struct WeightedSum {
  double share = 0;  // of weight x measure over limit
  double weight = 0;
};

// Of one column of nodes: the mass of node j is column_mass row_density[j], and it has live_elements[j] elements left.
struct ColumnMasses {
  double column_mass;
  const double* row_density;
  const unsigned char* live_elements;
};
struct KineticEnergy {
  double live = 0, freed = 0;  // of nodes with elements, of nodes without
};
struct StoredEnergy {
  double elastic = 0, hourglass = 0;
};

template <class Real>
struct Kernel {
  // Sets the corner forces of column i's elements in these rows; marks the elements that are to be taken out, which give none.
  // previous_step led to these displacements; 0 in the first step, and where the same displacements are looked at again.
  void (*internal_forces)(const FieldsView<Real>&, const ColumnForces<Real>&, int column, Rows, const ColumnShape&,
                          const MaterialConstants&, double previous_step, const StiffnessWatch&, ColumnReport&);
  // The same of the plain solid whose erosion is judged by an average of the energy.
  void (*internal_forces_averaged)(const FieldsView<Real>&, const ColumnForces<Real>&, int column, Rows,
                                   const ColumnShape&, const MaterialConstants&, double previous_step,
                                   const StiffnessWatch&, ColumnReport&);
  // The same of a target that is more than one layer of the plain solid.
  void (*internal_forces_general)(const FieldsView<Real>&, const ColumnForces<Real>&, int column, Rows,
                                  const ColumnShape&, const GeneralSolidView<Real>&, double previous_step,
                                  const StiffnessWatch&, ColumnReport&);
  // Writes the rows of the touchable nodes inside a sphere (or cylinder) of radius 1 centred at depth `centre` on the
  // axis, in their order, and returns how many. `found` has room for all rows.
  int (*nodes_in_sphere)(const FieldsView<const Real>&, const ContactNodes&, double centre, int* found);
  // The same of a convex polygon, its centre of mass at (centre_x, centre_z).
  int (*nodes_in_polygon)(const FieldsView<const Real>&, const ContactNodes&, const PolygonSide* sides, int side_count,
                          double centre_x, double centre_z, int* found);
  // v += kick f/m, u += drift v for the nodes of column i. Where `held` the column moves along z only.
  void (*kick_and_drift)(const FieldsView<Real>&, const NodeForces<Real>&, int column, Rows, bool held, double kick,
                         double drift);
  // Over `count` elements of a column that live and have a limit, per_limit > 0. Weights must be 0 from `count` on, or elements dead;
  // one group of lanes behind all arrays is read.
  WeightedSum (*weighted_sum)(const Real* alive, const Real* measure, const Real* per_limit, const Real* weights,
                              int count);
  // Of the first `nodes` of a column, and of the first `rows` elements of a column of the plain solid; whole groups are looked at.
  KineticEnergy (*kinetic_energy)(const FieldsView<const Real>&, int column, int nodes, const ColumnMasses&);
  StoredEnergy (*stored_energy)(const FieldsView<const Real>&, int column, int rows, const ColumnShape&,
                                const MaterialConstants&);
  int lanes;  // rows are handled in groups of this many; arrays are padded accordingly
};

// Of instruction_level() (math/instruction_level.hpp).
template <class Real>
const Kernel<Real>& kernel();
template <>
const Kernel<float>& kernel<float>();
template <>
const Kernel<double>& kernel<double>();

}  // namespace percal
