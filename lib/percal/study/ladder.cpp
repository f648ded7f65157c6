#include "percal/study/ladder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "percal/base/error.hpp"
#include "percal/impact/target/size.hpp"
#include "percal/math/grid_convergence.hpp"
#include "percal/problem/domain.hpp"

namespace percal {
namespace {

constexpr double between_meshes = 1.4;  // from one mesh of a ladder to the next
constexpr double rounding = 0.01;       // of the finest mesh that is usual

// Half the step is tried on the second mesh and on the middle one.
std::vector<double> half_step_meshes(const std::vector<double>& meshes) {
  const std::size_t middle = std::max<std::size_t>(2, meshes.size() / 2);
  return {meshes[1], meshes[middle]};
}

struct Setting {
  double elements_per_radius;
  double time_step_factor;
  Arithmetic arithmetic;
};

// The finest first: the long runs shall not be the last ones on one thread.
std::vector<Setting> settings_of(const LadderOptions& options) {
  const double step = *options.time_step_factor;
  std::vector<Setting> settings;
  for (const double mesh : options.meshes) settings.push_back({mesh, step, Arithmetic::single_precision});
  for (const double mesh : half_step_meshes(options.meshes))
    settings.push_back({mesh, step / 2, Arithmetic::single_precision});
  settings.push_back({options.meshes[1], step, Arithmetic::double_precision});
  std::ranges::stable_sort(settings, std::ranges::greater{}, &Setting::elements_per_radius);
  return settings;
}

}  // namespace

LadderOptions usual_ladder(const Scene& scene) {
  LadderOptions options;
  const double finest = options.meshes.back(), coarsest = coarsest_mesh(scene);
  if (coarsest <= options.meshes.front()) return options;
  options.meshes.clear();
  for (double mesh = coarsest; options.meshes.size() < fewest_grids || mesh <= finest * (1 + rounding);
       mesh *= between_meshes)
    options.meshes.push_back(std::round(mesh));
  return options;
}

Rung rung_of(const Reduction& reduction, const std::vector<Evaluation>& runs) {
  const Problem& problem = reduction.problem;
  Rung rung{.elements_per_radius = problem.elements_per_radius,
            .time_step_factor = problem.time_step_factor,
            .arithmetic = problem.arithmetic,
            .replicates = static_cast<int>(runs.size()),
            .penetration = summarise(runs, problem, reduction.scales),
            .elements = runs.front().result.elements};
  const auto share = 1 / static_cast<double>(runs.size());
  for (const auto& run : runs) {
    rung.steps += share * static_cast<double>(run.result.steps);
    rung.element_steps += share * run.result.element_steps;
    rung.cpu_seconds += share * run.cpu_seconds;
  }
  return rung;
}

const Rung& Ladder::on_mesh(double elements_per_radius) const {
  return *std::ranges::find(meshes, elements_per_radius, &Rung::elements_per_radius);
}

Scene rung_scene(const Scene& scene, double elements_per_radius, double time_step_factor, Arithmetic arithmetic) {
  Scene rung = on_mesh(scene, elements_per_radius);
  rung.solver.time_step_factor = time_step_factor;
  rung.solver.arithmetic = arithmetic;
  rung.output = {};
  return rung;
}

LadderOptions checked(LadderOptions options, const Scene& scene) {
  auto& meshes = options.meshes;
  std::ranges::sort(meshes);
  meshes.erase(std::unique(meshes.begin(), meshes.end()), meshes.end());
  if (meshes.size() < fewest_grids || meshes.front() < 1 || meshes.back() > 1000)
    throw BadInput(Place{.file = "", .line = 0, .key = "--meshes"}, fmt::format("{}", fmt::join(meshes, ",")),
                   fmt::format("{} or more different numbers from 1 to 1000", fewest_grids));
  if (meshes.front() < coarsest_mesh(scene))
    throw BadInput(Place{.file = scene.source, .line = 0, .key = "--meshes"}, fmt::format("{}", meshes.front()),
                   fmt::format("{} elements per radius or more, three in the erosion length", coarsest_mesh(scene)));
  if (options.replicates < fewest_ladder_replicates)
    throw BadInput(Place{.file = "", .line = 0, .key = "--replicates"}, fmt::format("{}", options.replicates),
                   fmt::format("{} or more", fewest_ladder_replicates));
  refuse_what_is_too_large(finest_problem(options, scene), scene.source);
  if (!options.time_step_factor) options.time_step_factor = scene.solver.time_step_factor;
  return options;
}

Problem finest_problem(const LadderOptions& options, const Scene& scene) {
  const double step = options.time_step_factor.value_or(scene.solver.time_step_factor);
  return reduce(rung_scene(scene, options.meshes.back(), step, Arithmetic::single_precision)).problem;
}

long ladder_runs(const LadderOptions& options) {
  return (static_cast<long>(options.meshes.size()) + 3) * options.replicates;
}

Ladder run_ladder(const Scene& scene, const LadderOptions& wanted, Campaign& campaign, Progress* progress) {
  Ladder ladder;
  ladder.options = checked(wanted, scene);
  ladder.refinement = refinement(scene);
  ladder.scene_mesh = scene.mesh.elements_per_radius;
  const auto settings = settings_of(ladder.options);
  std::vector<Reduction> reductions;
  std::vector<Problem> problems;
  for (const Setting& s : settings) {
    reductions.push_back(reduce(rung_scene(scene, s.elements_per_radius, s.time_step_factor, s.arithmetic)));
    problems.push_back(reductions.back().problem);
  }
  const auto runs = campaign.replicate(problems, ladder.options.replicates, progress);
  for (std::size_t i = settings.size(); i-- > 0;) {
    Rung rung = rung_of(reductions[i], runs[i]);
    rung.time_step_factor = settings[i].time_step_factor;  // not rounded
    if (rung.arithmetic == Arithmetic::double_precision)
      ladder.double_precision = std::move(rung);
    else if (rung.time_step_factor < *ladder.options.time_step_factor)
      ladder.half_steps.push_back(std::move(rung));
    else
      ladder.meshes.push_back(std::move(rung));
  }
  return ladder;
}

}  // namespace percal
