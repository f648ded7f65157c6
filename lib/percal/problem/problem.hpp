// The dimensionless problem: particle radius, impact speed and target density are 1. Similar systems are one problem.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "percal/problem/choices.hpp"
#include "percal/scene/scene.hpp"

namespace percal {

struct Problem {
  double pi4 = 0;            // rho_t v^2 / mu, mu the true shear modulus
  double density_ratio = 0;  // rho_p / rho_t = 1/pi5
  double alpha = 0;
  double bulk_ratio = least_bulk_ratio;  // K / mu
  double depth = 75;                     // L / a
  double width = 5;                      // w / a
  Bottom bottom = Bottom::free;
  Geometry geometry = Geometry::axisymmetric;
  bool whole = false;     // plane strain and block: both sides of x = 0; else the right half, mirrored
  BlockModel block = {};  // of geometry block
  Particle particle = RigidSphere{};
  Friction friction = NoFriction{};  // of a rigid particle
  std::vector<LowerLayer> below;     // `depth` is then the first layer's thickness
  Erosion erosion = NoErosion{};
  FurtherErosion further_erosion = {};
  ErosionAverage erosion_average = NoAverage{};
  double stretch = 1;                         // of the first layer's plane before the impact; 1: none
  std::optional<double> stretch_across = {};  // of a block, along y; left out: as stretch
  Fibres fibres = NoFibres{};                 // of the first layer
  Relaxation relaxation = NoRelaxation{};

  double elements_per_radius = 10;
  double fine_width = 1;
  int graded_columns = 5;

  double hourglass = 0.5;
  HourglassForm hourglass_form = HourglassForm::stiffness;
  VolumetricLaw volumetric_law = VolumetricLaw::log_quadratic;
  ErodedNodes eroded_nodes = ErodedNodes::released;
  double linear_viscosity = 0.06;
  double quadratic_viscosity = 0.6;
  double time_step_factor = 0.9;
  int rates = 2;  // at most: rates_of()
  Arithmetic arithmetic = Arithmetic::single_precision;
  double end_time = 1000;  // in radii at impact speed

  double speed_factor = 1;  // a replicate's speed over the scene's
  // About so many points of the penetration history, evenly spaced in steps; 0: none. Not part of the key, for it does
  // not change the result.
  int history_samples = 0;
  bool channel = false;  // ImpactResult::channel is kept; not part of the key either
  bool half_speed_depth = false;  // a kept result without ImpactResult::half_speed_depth will not do; likewise
  // Past the deepest point: ImpactResult::aftermath. Changes nothing else that a run says of its depth.
  RunUntil until = RunUntil::deepest;

  bool operator==(const Problem&) const = default;

  double mu() const { return 1 / pi4; }
  double bulk() const { return bulk_ratio / pi4; }
  double whole_depth() const;               // of all layers
  std::vector<double> lower_faces() const;  // their depths, undeformed
};

// The rates that a run takes: one where nothing erodes. Elements are then squeezed without end, and two rates do not close there;
// the few steps that they would save are not worth it.
int rates_of(const Problem& problem);

// What is said of a scene or job that still gives one.
inline constexpr char contact_stiffness_warning[] = "contact_stiffness has no effect: contact has no springs any more";

// Of a block and its particle, what is computed: 1, 1/2 or 1/4, by its planes of symmetry.
double computed_share(const Problem& problem);

// 0: none.
double friction_coefficient(const Problem& problem);

// v over the dilatational wave speed sqrt((K + 4 mu/3)/rho), of the layer that has the slowest.
double mach_number(const Problem& problem);

// Below this Mach number the depth no longer depends on K (docs/theory/impact.md), and the K/mu that gives it, with 1 % to spare.
inline constexpr double recommended_mach = 0.3;
double subsonic_bulk_ratio(double pi4);

// What takes dimensionless results back to SI.
struct Scales {
  double radius = 1;          // m
  double speed = 1;           // m/s
  double target_density = 1;  // kg/m3
};

// Something that the scene could have had and this run does without, and why.
struct LeftOut {
  std::string what;
  std::string why;
};

// What a run does without; said with every result.
std::vector<LeftOut> list_what_is_left_out(const Scene& scene, const Problem& problem);

// What of the mesh the scene left to the rules, and what came of it.
struct MeshChoice {
  bool width_was_chosen = false, columns_were_chosen = false;
  double columns = 0;  // of a right half
  double growth = 1;   // of its graded columns
};

struct Reduction {
  Problem problem;
  Scales scales;
  double mu_true = 0;       // Pa
  double bulk_modulus = 0;  // Pa
  double mach = 0;
  bool bulk_was_chosen = false;
  MeshChoice mesh;
  std::vector<LeftOut> left_out;
  std::vector<std::string> warnings;
};

// The scene without its dimensions; every input is rounded to 12 significant digits, so that one scene written in other
// units, and two similar systems, are the same problem to the last bit.
Reduction reduce(const Scene& scene);

// The canonical text of a problem: every number that decides the result, the solver's version and the instruction level.
std::string evaluation_key(const Problem& problem, const std::string& instruction_level);

// The problem of which `key` is the evaluation_key at this instruction level, to the last bit, as all its numbers have 12 digits. Nothing where
// it is of another solver version or level.
std::optional<Problem> problem_of_key(const std::string& key, const std::string& instruction_level);

// What every key of a rigid sphere of this solver version begins with.
std::string sphere_key_prefix(const std::string& instruction_level);

// x rounded to 12 significant digits.
double round_to_12_digits(double x);

}  // namespace percal
