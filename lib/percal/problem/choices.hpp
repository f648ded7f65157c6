// Everything that a scene may ask for and may leave out, on one page. Each is a variant with an empty alternative, or a
// list that may be empty: what is left out has no state and costs no work. The march is compiled for each particle in
// each arithmetic; a target that needs no more than the plain solid gets a kernel that knows no more. Dimensionless:
// radius, impact speed and the first layer's density are 1.
#pragma once
#include <array>
#include <optional>
#include <variant>
#include <vector>

#include "percal/scene/scene.hpp"

namespace percal {

// Elements that are stretched or loaded too far are taken out of the mesh, or nothing is: NoErosion, StrainErosion,
// StressErosion, EnergyErosion of scene/scene.hpp, limits over rho_t v^2. What decides is an element's own value, or an average
// within a length too: NoAverage, AverageWithin of scene/scene.hpp, in radii. Further limits of other kinds, or none: FurtherErosion
// of scene/scene.hpp, over rho_t v^2.

// A layer has fibres, or none: NoFibres, PlanarFibres, FibreFamilies of scene/scene.hpp, k1 over rho_t v^2.

// The particle rubs along the target, or it does not: NoFriction, CoulombFriction of scene/scene.hpp.

// The deviatoric stress relaxes, or it does not: NoRelaxation, PronySeries of scene/scene.hpp, times in radii at impact speed.

// The particle.
struct RigidSphere {
  bool operator==(const RigidSphere&) const = default;
};
// A convex polygon, anticlockwise, with x to the right and y upwards from its centre of mass, its half width 1.
struct RigidPolygon {
  std::vector<std::array<double, 2>> vertices;
  // Of the whole body, per radian (axisymmetric) or per unit of thickness, over rho_t a^3 or rho_t a^2.
  double mass = 0;
  double inertia = 0;  // about the centre of mass; used where free_rotation
  bool free_rotation = false;
  double half_thickness = 0;  // of a prism in a block: along y, to both sides; else 0
  bool operator==(const RigidPolygon&) const = default;
};
// A convex polyhedron in a block, its vertices from the centre of mass, z upwards, half its width in x 1.
struct RigidPolyhedron {
  std::vector<std::array<double, 3>> vertices;
  double mass = 0;  // of the whole body, over rho_t a^3
  bool free_rotation = false;
  bool operator==(const RigidPolyhedron&) const = default;
};
struct ElasticSphere {
  double youngs_modulus = 0;  // over rho_t v^2
  double poisson_ratio = 0.3;
  bool operator==(const ElasticSphere&) const = default;
};
using Particle = std::variant<RigidSphere, RigidPolygon, ElasticSphere, RigidPolyhedron>;

// A block in three dimensions: x to the right, y along the particle's thickness, z downwards. y = 0 is a plane of symmetry unless
// whole_across, and x = 0 unless Problem::whole. Cells are cubes near the particle's path and grow towards the walls, which are as far away in x and y.
struct BlockModel {
  double fine_thickness =
      1;  // cells are cubes for |y| up to here or to the first node beyond, as for |x| up to Problem::fine_width
  double fine_depth = 0;  // and down to here
  double growth = 1.25;   // of each cell over the one before, at most, from there on
  double angle =
      0;  // rad: the first velocity points so far to the right of straight down; cubes and wall reach further there
  bool whole_across = false;  // both sides of y = 0
  bool operator==(const BlockModel&) const = default;
};

// The least K/mu that is chosen where a scene gives none: with more, a soft solid's depth no longer depends on K.
inline constexpr double least_bulk_ratio = 50;

// A layer below the first.
struct LowerLayer {
  double depth = 0;    // its thickness
  double density = 1;  // over the first layer's
  double mu = 0;       // over rho_t v^2: the first layer's would be 1/pi4
  double alpha = 0;
  double bulk_ratio = least_bulk_ratio;  // K / mu
  double erosion_limit = 0;              // as the first layer's limit is meant; infinite: none of that kind
  FurtherErosion further_erosion = {};
  double stretch = 1;                         // of its plane before the impact; 1: none
  std::optional<double> stretch_across = {};  // of a block, along y; left out: as stretch
  Fibres fibres = NoFibres{};
  bool operator==(const LowerLayer&) const = default;
};

static_assert(std::is_empty_v<NoErosion> && std::is_empty_v<NoFibres> && std::is_empty_v<NoAverage> &&
              std::is_empty_v<NoRelaxation> && std::is_empty_v<NoFriction> && std::is_empty_v<RigidSphere>);

}  // namespace percal
