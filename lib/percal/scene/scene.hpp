// An impact as the user wrote it, in SI. problem/ turns it into the dimensionless problem that is solved. What a scene
// may leave out is a variant with an empty alternative or an optional; left out means: not there, not zero.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "percal/material/conventions.hpp"
#include "percal/material/prony.hpp"

namespace percal {

enum class Bottom { free, fixed };
enum class Arithmetic { single_precision, double_precision };
enum class Geometry { axisymmetric, plane_strain, block };  // block: in three dimensions

// --- volumetric stiffness: what the scene says about it ---------------------------------------------------------
// K at least 50 mu and a Mach number below 0.3.
struct ChooseBulk {
  bool operator==(const ChooseBulk&) const = default;
};
struct PoissonRatio {
  double nu;
  bool operator==(const PoissonRatio&) const = default;
};
struct BulkToShear {
  double ratio;  // K / mu_true
  bool operator==(const BulkToShear&) const = default;
};
using VolumetricChoice = std::variant<ChooseBulk, PoissonRatio, BulkToShear>;

// --- erosion ----------------------------------------------------------------------------------------------------
struct NoErosion {
  bool operator==(const NoErosion&) const = default;
};
struct StrainErosion {
  double limit;  // of the largest principal strain, in `measure`
  StrainMeasure measure = StrainMeasure::engineering;
  bool operator==(const StrainErosion&) const = default;
};
struct StressErosion {
  double limit;  // Pa, of the largest principal Cauchy stress
  bool operator==(const StressErosion&) const = default;
};
struct EnergyErosion {
  double limit;  // J per m3 of the undeformed solid, of the stored energy density
  bool operator==(const EnergyErosion&) const = default;
};
using Erosion = std::variant<NoErosion, StrainErosion, StressErosion, EnergyErosion>;
// Limits of other kinds beside Erosion's, which is the first of strain, stress and energy that a scene gives: an element goes by
// whichever it reaches first. Left out: there is no further one.
struct FurtherErosion {
  std::optional<double> stress;  // as StressErosion's limit
  std::optional<double> energy;  // as EnergyErosion's limit
  bool is_empty() const { return !stress && !energy; }
  bool operator==(const FurtherErosion&) const = default;
};

// --- a limit of strain that hangs on the particle's size ----------------------------------------------------------
struct AnySize {
  bool operator==(const AnySize&) const = default;
};
// Particles smaller than a cell of the tissue have to part other stuff than larger ones: erosion_size.hpp.
struct SmallerThanCell {
  double cell;    // m, of the particle's diameter (a profile's width as it stands)
  double strain;  // the limit for those that are smaller
  bool operator==(const SmallerThanCell&) const = default;
};
using ErosionBySize = std::variant<AnySize, SmallerThanCell>;

// --- over what erosion is judged --------------------------------------------------------------------------------
// Each element by its own value.
struct NoAverage {
  bool operator==(const NoAverage&) const = default;
};
// Besides by the average of the stored energy over its limit, within this length: docs/theory/impact.md (23).
struct AverageWithin {
  double length;  // m in a scene, radii in a problem
  bool operator==(const AverageWithin&) const = default;
};
using ErosionAverage = std::variant<NoAverage, AverageWithin>;

// --- relaxation -------------------------------------------------------------------------------------------------
struct NoRelaxation {
  bool operator==(const NoRelaxation&) const = default;
};
// Of the deviatoric stress: PronySeries of material/prony.hpp.
using Relaxation = std::variant<NoRelaxation, PronySeries>;

// --- fibres -----------------------------------------------------------------------------------------------------
struct NoFibres {
  bool operator==(const NoFibres&) const = default;
};
// In all directions of the layer's plane alike: W_f = (k1/(2 k2)) (exp(k2 E^2) - 1) where E = kappa (C_r + C_hoop) + (1 - 2 kappa) C_z -
// 1 of the isochoric C is positive, else 0.     docs/theory/target.md, Fibres
struct PlanarFibres {
  double k1;  // Pa in a scene, over rho_t v^2 in a problem
  double k2;
  double kappa = 0.5;  // dispersion out of the plane: 1/2 none, 1/3 the same in all directions of space
  bool operator==(const PlanarFibres&) const = default;
};
// Two families in the plane of a block's layer, at this angle to both sides of x, each of W_f with E = kappa (tr C - 3) + (1 - 3 kappa) (C_aa - 1)
// of the isochoric C along the family.     docs/theory/solid.md, Fibres
struct FibreFamilies {
  double k1;  // Pa in a scene, over rho_t v^2 in a problem
  double k2;
  double kappa = 0;  // dispersion: 0 none, 1/3 the same in all directions of space
  double angle = 0;  // rad
  bool operator==(const FibreFamilies&) const = default;
};
using Fibres = std::variant<NoFibres, PlanarFibres, FibreFamilies>;

// --- the particle -----------------------------------------------------------------------------------------------
// A sphere; in plane strain a cylinder lying on its side.
struct RoundShape {
  bool operator==(const RoundShape&) const = default;
};
// A rigid convex polygon: the cross-section of a prism in plane strain, the meridian of a body of revolution in an axisymmetric
// scene, where it is its own mirror image about x = 0. ParticleScene::radius is half its width, as it stands.
struct ProfileShape {
  std::string vertices_file;                    // CSV they came from; may be empty
  std::vector<std::array<double, 2>> vertices;  // m, (x, height), anticlockwise, before it is turned
  double orientation = 0;                       // rad, by which it is turned anticlockwise
  std::optional<double> mass;                   // kg, or kg per metre of a prism; left out: by the density
  bool free_rotation = false;                   // free to turn and to move sideways; else straight down as it stands
  double thickness = 0;                         // m, of a prism in a block; else 0
  bool operator==(const ProfileShape&) const = default;
};
// A rigid convex polyhedron in a block: x to the right, y along the block's other side, z upwards. ParticleScene::radius is half its width
// in x, as it stands.
struct PolyhedronShape {
  std::string vertices_file;                    // CSV or STL they came from; may be empty
  std::vector<std::array<double, 3>> vertices;  // m, before it is turned
  double orientation = 0;                       // rad, by which it is turned about y, anticlockwise where y points away
  std::optional<double> mass;                   // kg; left out: by the density
  bool free_rotation = false;                   // free to turn and to move sideways; else straight down as it stands
  bool operator==(const PolyhedronShape&) const = default;
};
using ParticleShape = std::variant<RoundShape, ProfileShape, PolyhedronShape>;

// --- friction between particle and target -------------------------------------------------------------------------
struct NoFriction {
  bool operator==(const NoFriction&) const = default;
};
// Coulomb's: the force along the surface is at most the coefficient times the one across it.
struct CoulombFriction {
  double coefficient;
  bool operator==(const CoulombFriction&) const = default;
};
using Friction = std::variant<NoFriction, CoulombFriction>;

enum class Elasticity { automatic, rigid, elastic };  // automatic: rigid where the target is too soft to deform it

struct ParticleScene {
  std::string name = "sphere";
  ParticleShape shape = RoundShape{};
  double radius = 0;                     // m
  double density = 0;                    // kg/m3
  double speed = 0;                      // m/s, straight down
  double angle = 0;                      // rad, of a block: the speed points so far to the right of straight down
  std::optional<double> youngs_modulus;  // Pa
  double poisson_ratio = 0.3;            // of an elastic particle
  Elasticity elasticity = Elasticity::automatic;
  Friction friction = NoFriction{};
  bool operator==(const ParticleScene&) const = default;
};

struct LayerScene {
  std::string name = "target";
  double density = 0;      // kg/m3
  double mu_as_given = 0;  // Pa, meant as `convention` says
  ModulusConvention convention = ModulusConvention::true_shear;
  double alpha = 0;
  VolumetricChoice volumetric = ChooseBulk{};
  double depth = 0;             // m
  std::optional<double> width;  // m, radius of the fixed outer wall; left out: scene/width.hpp
  Bottom bottom = Bottom::free;
  Erosion erosion = NoErosion{};
  FurtherErosion further_erosion = {};
  ErosionBySize erosion_by_size = AnySize{};
  ErosionAverage erosion_average = NoAverage{};
  Relaxation relaxation = NoRelaxation{};
  double stretch = 1;                    // of the plane of the layer before the impact; the wall holds it
  std::optional<double> stretch_across;  // of a block: along y, where `stretch` is along x; left out: as that
  Fibres fibres = NoFibres{};
  bool operator==(const LayerScene&) const = default;
};

// A layer below the target's first; LayerScene::depth is then the first one's thickness. Its erosion is judged as the first one's,
// with a limit of its own; modulus convention and relaxation are the first one's.
struct LowerLayerScene {
  std::string name = "layer";
  double density = 0;      // kg/m3
  double mu_as_given = 0;  // Pa
  double alpha = 0;
  VolumetricChoice volumetric = ChooseBulk{};
  double depth = 0;                     // m, its thickness
  std::optional<double> erosion_limit;  // in the unit of the first one's; left out: none of that kind
  FurtherErosion further_erosion = {};  // of kinds that the first one has
  ErosionBySize erosion_by_size = AnySize{};
  double stretch = 1;
  std::optional<double> stretch_across;
  Fibres fibres = NoFibres{};
  bool operator==(const LowerLayerScene&) const = default;
};

// The mesh: square elements of side radius/elements_per_radius to fine_width radii from the axis or just beyond, then
// graded_columns columns growing geometrically to the wall. In a block cubes, which grow beyond a fine box to the walls.
struct MeshScene {
  double elements_per_radius = 10;    // need not be whole
  double fine_width = 1.0;            // in particle radii
  std::optional<int> graded_columns;  // left out: as many as keep their growth at most usual_growth (mesh/graded.hpp)
  bool whole = false;                 // plane strain and block: both halves even where the scene is symmetric
  // Of a block:
  double fine_thickness = 1.0;       // in particle radii, as fine_width, along y
  std::optional<double> fine_depth;  // in particle radii; left out: all of the depth
  double growth = 1.25;              // of each cell over the one before, at most
  bool whole_across = false;         // both sides of y = 0, too
  bool operator==(const MeshScene&) const = default;
};

enum class VolumetricLaw { log_quadratic, quadratic, logarithmic };  // U/K = (J^2-1-2 ln J)/4, (J-1)^2/2, (ln J)^2/2
enum class HourglassForm { stiffness, viscosity };
double usual_hourglass(HourglassForm form, Geometry geometry = Geometry::axisymmetric);  // where a scene gives none
enum class ErodedNodes {
  released,
  in_contact
};  // whether a node that has lost its last element still meets the particle

// Numerical settings: the defaults are docs/theory/impact.md's setting S.
struct SolverScene {
  bool contact_stiffness_was_given = false;  // by a scene of a time when contact had springs: a warning says so
  double hourglass = 0.5;                    // stiffness in units of mu_true; viscosity: share of the wave impedance
  HourglassForm hourglass_form = HourglassForm::stiffness;
  VolumetricLaw volumetric_law = VolumetricLaw::log_quadratic;
  ErodedNodes eroded_nodes = ErodedNodes::released;
  double linear_viscosity = 0.06;
  double quadratic_viscosity = 0.6;
  double time_step_factor = 0.9;  // share of the stable step
  int rates = 2;  // time steps of different length: 1, or 2 (elements near the particle at half the step)
  bool stiffen_supersonic = false;  // K raised to a Mach number of 0.3 where the scene's own gives 1 or more
  Arithmetic arithmetic = Arithmetic::single_precision;
  std::optional<double> end_time;  // s; left out: 1000 radii at impact speed
  bool operator==(const SolverScene&) const = default;
};

// How long a run goes on: to the deepest point or the target's lower face; where that was reached, until the particle has passed or is
// held; past the deepest point, too, until the particle rests or leaves.
enum class RunUntil { deepest, passage, rest };

struct OutputScene {
  bool history = false;                // the penetration history as CSV
  RunUntil after = RunUntil::deepest;  // what a run is to tell last
  bool channel = false;                // the channel's radius along the depth
  bool half_speed_depth = false;       // asked for by jobs whose data tell of it, without a key of its own: every run says it
  bool operator==(const OutputScene&) const = default;
};

// Runs on meshes of different phase, each at a speed of its own, whose mean is a depth.     docs/decisions/0012-mesh-and-phase.md
inline constexpr int usual_replicates = 5;

struct Scene {
  std::string source;  // file it was read from, for messages
  Geometry geometry = Geometry::axisymmetric;
  ParticleScene particle;
  LayerScene target;
  std::vector<LowerLayerScene> below;
  MeshScene mesh;
  SolverScene solver;
  OutputScene output;
  int replicates = usual_replicates;  // runs whose mean is the depth: problem/replicates.hpp
  bool operator==(const Scene&) const = default;
};

}  // namespace percal
