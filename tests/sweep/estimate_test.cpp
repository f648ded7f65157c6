// What a plan is expected to cost, against what it does: by element-steps, which no other load of the machine changes.
#include "percal/sweep/estimate.hpp"

#include <gtest/gtest.h>

#include "percal/impact/target/size.hpp"
#include "percal/sweep/sweep_runs.hpp"
#include "sweep/small_plan.hpp"

namespace percal {
namespace {

using test::listed_sweep;
using test::ranged;

struct Estimated {
  const char* name;
  std::string sweeps, head;
  double scene_depth = 40;  // mm
};

class SlowEstimate : public test::PlanFolder, public testing::WithParamInterface<Estimated> {};

TEST_P(SlowEstimate, IsWithinThirtyPercent) {
  const auto& [name, sweeps, head, depth] = GetParam();
  std::string text = test::small_scene;
  text.replace(text.find("elements_per_radius = 3"), 23, "elements_per_radius = 10");
  write("scene.toml", text.replace(text.find("40 mm"), 5, std::to_string(depth) + " mm"));
  const auto points = points_to_run(plan(sweeps, head));
  const auto problems = problems_of(points);
  long runs = 0;
  for (const auto& replicates : problems) runs += static_cast<long>(replicates.size());
  const CostEstimate estimate = estimate_cost(problems_to_run(problems, nullptr), runs, 2);
  Campaign campaign(nullptr, 2);
  Progress silent;
  double element_steps = 0;
  for (const auto& of_point : run_points(points, campaign, nullptr, silent))
    for (const Evaluation& run : of_point) element_steps += run.result.element_steps;
  EXPECT_NEAR(estimate.element_steps / element_steps, 1, 0.3);
  EXPECT_EQ(estimate.runs, runs);
  EXPECT_LE(estimate.longest_seconds, estimate.wall_seconds);
}

INSTANTIATE_TEST_SUITE_P(
    SlowPlans, SlowEstimate,
    testing::Values(
        Estimated{"Speeds", ranged("particle.speed", "\"40 m/s\"", "\"200 m/s\"", "count = 5\n"), "replicates = 2\n",
                  100},
        Estimated{"Sobol",
                  ranged("pi4", "20", "150", "spacing = \"log\"\n") + ranged("target.erosion.strain", "0.6", "1.5"),
                  "replicates = 1\ndesign = \"sobol\"\ncount = 24\n"},
        Estimated{"Meshes", ranged("mesh.elements_per_radius", "6", "16", "count = 6\n"), "replicates = 2\n"},
        Estimated{"Densities",
                  ranged("pi5", "0.1", "1", "count = 4\nspacing = \"log\"\n") +
                      listed_sweep("target.bottom", "[\"free\", \"fixed\"]"),
                  "replicates = 1\n"}),
    [](const auto& info) { return info.param.name; });

class Estimate : public test::PlanFolder {};

TEST_F(Estimate, OfNothingToRunIsNothing) {
  const CostEstimate estimate = estimate_cost({{}, {}}, 4, 2);
  EXPECT_EQ(estimate.stored, 4);
  EXPECT_EQ(estimate.cpu_seconds, 0);
  EXPECT_EQ(estimate.measured_runs, 0);
}

TEST_F(Estimate, MeasuresAFewPointsOfMany) {
  const auto points = points_to_run(
      plan(ranged("target.alpha", "2", "8", "count = 50\n") + listed_sweep("target.depth", "[\"8 mm\"]")));
  const CostEstimate estimate = estimate_cost(problems_of(points), 50, 1);
  EXPECT_EQ(estimate.measured_runs, 16);
  EXPECT_GT(estimate.cpu_seconds, estimate.longest_seconds);
  EXPECT_EQ(estimate.side_by_side, 1);
  EXPECT_GT(estimate.bytes, size_of(points[0].reduction.problem).bytes);
}

}  // namespace
}  // namespace percal
