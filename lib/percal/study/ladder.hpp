// One scene on a ladder of meshes, with replicates on each; half the time step on two of them; double precision on one.
#pragma once
#include <optional>
#include <vector>

#include "percal/campaign/campaign.hpp"
#include "percal/scene/erosion_length.hpp"
#include "percal/scene/scene.hpp"

namespace percal {

inline constexpr int fewest_ladder_replicates = 3;  // the spread and the comparisons need them

struct LadderOptions {
  std::vector<double> meshes{5, 7, 10, 14, 20, 28};  // elements per radius; sorted and made unique by the ladder
  int replicates = usual_replicates;
  std::optional<double> time_step_factor;  // left out: the scene's
  bool operator==(const LadderOptions&) const = default;
};

// The ladder where nobody names meshes. Where erosion is judged over a length it begins with the coarsest mesh that has three elements
// in it, four meshes or more.
LadderOptions usual_ladder(const Scene& scene);

// One setting of mesh, time step and arithmetic, with its replicates.
struct Rung {
  double elements_per_radius = 0;
  double time_step_factor = 0;
  Arithmetic arithmetic = Arithmetic::single_precision;
  int replicates = 0;
  Penetration penetration;
  long elements = 0;
  double steps = 0, element_steps = 0, cpu_seconds = 0;  // of a run: means over the replicates
};

// What the runs of one reduced scene say and cost; one run or more.
Rung rung_of(const Reduction& reduction, const std::vector<Evaluation>& runs);

struct Ladder {
  LadderOptions options;                          // as run: sorted, the time step filled in
  Refinement refinement = Refinement::any_order;  // of the scene
  double scene_mesh = 0;                          // its elements per radius
  std::vector<Rung> meshes;                       // coarse to fine, single precision
  std::vector<Rung> half_steps;                   // half the time step, on two of these meshes
  Rung double_precision;                          // on the second mesh
  const Rung& on_mesh(double elements_per_radius) const;
};

// The scene as a rung has it.
Scene rung_scene(const Scene& scene, double elements_per_radius, double time_step_factor, Arithmetic arithmetic);

// Of sorted options: the largest run at the scene's own step.
Problem finest_problem(const LadderOptions& options, const Scene& scene);

// The options sorted, each mesh once, the time step filled in. Throws BadInput: fewer than four meshes or three replicates, a mesh
// that is too large to be run.
LadderOptions checked(LadderOptions options, const Scene& scene);

// How many runs the ladder makes, for a progress bar.
long ladder_runs(const LadderOptions& options);

// All runs through the campaign. Throws as checked().
Ladder run_ladder(const Scene& scene, const LadderOptions& options, Campaign& campaign, Progress* progress);

}  // namespace percal
