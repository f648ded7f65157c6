// An impact as the user wrote it, in SI. problem/ turns it into the dimensionless problem that is solved. What a scene
// may leave out is a variant with an empty alternative or an optional; left out means: not there, not zero.
#pragma once
#include <optional>
#include <string>
#include <variant>

#include "percal/material/conventions.hpp"

namespace percal {

enum class Bottom { free, fixed };
enum class Arithmetic { single_precision, double_precision };

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
using Erosion = std::variant<NoErosion, StrainErosion>;

struct SphereScene {
  std::string name = "sphere";
  double radius = 0;                     // m
  double density = 0;                    // kg/m3
  double speed = 0;                      // m/s, straight down
  std::optional<double> youngs_modulus;  // Pa; only decides whether a rigid particle is good enough
  bool operator==(const SphereScene&) const = default;
};

struct LayerScene {
  std::string name = "target";
  double density = 0;      // kg/m3
  double mu_as_given = 0;  // Pa, meant as `convention` says
  ModulusConvention convention = ModulusConvention::true_shear;
  double alpha = 0;
  VolumetricChoice volumetric = ChooseBulk{};
  double depth = 0;  // m
  double width = 0;  // m, radius of the fixed outer wall
  Bottom bottom = Bottom::free;
  Erosion erosion = NoErosion{};
  bool operator==(const LayerScene&) const = default;
};

// The mesh: square elements of side radius/elements_per_radius within fine_width radii of the axis, then
// graded_columns columns growing geometrically to the wall.
struct MeshScene {
  int elements_per_radius = 10;
  double fine_width = 1.0;            // in particle radii
  std::optional<int> graded_columns;  // left out: half of the fine ones
  bool operator==(const MeshScene&) const = default;
};

// Numerical settings: the defaults are docs/theory/impact.md's setting S.
struct SolverScene {
  double contact_stiffness = 0.6;  // kappa: k = kappa m/dt_ref^2
  double hourglass = 0.5;          // elastic hourglass stiffness in units of mu_true
  double linear_viscosity = 0.06;
  double quadratic_viscosity = 1.2;
  double time_step_factor = 0.8;  // share of the stable step
  Arithmetic arithmetic = Arithmetic::single_precision;
  std::optional<double> end_time;  // s; left out: 1000 radii at impact speed
  bool operator==(const SolverScene&) const = default;
};

struct OutputScene {
  bool history = false;  // the penetration history as CSV
  bool operator==(const OutputScene&) const = default;
};

struct Scene {
  std::string source;  // file it was read from, for messages
  SphereScene particle;
  LayerScene target;
  MeshScene mesh;
  SolverScene solver;
  OutputScene output;
  int replicates = 3;  // runs at speeds times 1, 1.001, 0.999, 1.002, ...
  bool operator==(const Scene&) const = default;
};

}  // namespace percal
