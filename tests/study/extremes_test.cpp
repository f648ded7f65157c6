// The matrix of extreme impacts: what it covers, how its cells are judged; a few of them for real, and all of them slowly.
#include "percal/study/extremes.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "percal/campaign/campaign.hpp"
#include "percal/impact/march/march.hpp"
#include "percal/study/page/extremes.hpp"

namespace percal {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

ExtremeCell cell(const std::string& what) {
  for (const auto& one : extreme_cells())
    if (one.what == what) return one;
  throw std::runtime_error("no cell is called " + what);
}

ImpactResult sound_result() {
  ImpactResult r;
  r.outcome = Outcome::stopped;
  r.depth = 20;
  r.steps = 100;
  r.smallest_step = 0.3;
  r.energy.particle = 0.4;
  r.energy.elastic = 0.6;
  return r;
}

std::vector<Evaluation> all_sound(const std::vector<Problem>& problems) {
  return std::vector<Evaluation>(problems.size(), Evaluation{.result = sound_result(), .instruction_level = "any"});
}
std::vector<Evaluation> run_for_real(const std::vector<Problem>& problems) {
  return Campaign(nullptr, 1).evaluate(problems, nullptr);
}

void expect_no_nan(const nlohmann::json& value, const std::string& where) {
  if (value.is_number()) {
    EXPECT_TRUE(std::isfinite(value.get<double>())) << where;
  }
  if (value.is_structured())
    for (const auto& [key, inner] : value.items()) expect_no_nan(inner, where + "/" + key);
}

TEST(Extremes, TheMatrixHasSixtyCellsOrMoreEachWithANameOfItsOwn) {
  const auto cells = extreme_cells();
  EXPECT_GE(cells.size(), 60u);
  std::set<std::string> names;
  for (const auto& one : cells) EXPECT_TRUE(names.insert(one.group + "/" + one.what).second) << one.what;
}

TEST(Extremes, TheMatrixSpansWhatItPromises) {
  std::set<double> alphas, ratios, bulks;
  double smallest_radius = 1, largest_radius = 0, least_pi4 = 1, most_pi4 = 1;
  for (const auto& result : run_extremes(extreme_cells(), "any", all_sound)) {
    if (!result.run) continue;
    const Problem& p = result.run->reduction.problem;
    alphas.insert(p.alpha);
    ratios.insert(p.density_ratio);
    bulks.insert(p.bulk_ratio);
    smallest_radius = std::min(smallest_radius, result.run->reduction.scales.radius);
    largest_radius = std::max(largest_radius, result.run->reduction.scales.radius);
    least_pi4 = std::min(least_pi4, p.pi4);
    most_pi4 = std::max(most_pi4, p.pi4);
  }
  for (const double alpha : {-20.0, -5.0, -2.0, 0.5, 2.0, 9.0, 16.0, 25.0}) EXPECT_TRUE(alphas.contains(alpha));
  EXPECT_EQ(*ratios.begin(), 0.5);
  EXPECT_EQ(*ratios.rbegin(), 20);
  EXPECT_NEAR(*bulks.rbegin(), bulk_to_shear(0.4999), 1e-6);
  EXPECT_DOUBLE_EQ(smallest_radius, 1e-8);
  EXPECT_DOUBLE_EQ(largest_radius, 1);
  EXPECT_DOUBLE_EQ(least_pi4, 1e-3);
  EXPECT_NEAR(most_pi4, 1e4, 1e-7);
}

TEST(Extremes, TheSteelIntoGelatinIsTwentyMillionTimesAsStiff) {
  const Scene scene = cell("steel, E 210 GPa, into gelatin of 10 kPa at 20 m/s").scene;
  EXPECT_DOUBLE_EQ(*scene.particle.youngs_modulus / scene.target.mu_as_given, 2.1e7);
}

TEST(Extremes, RefusedCellsAreNotRunAndSayWhy) {
  std::size_t evaluated = 0;
  const auto cells = extreme_cells();
  const auto results = run_extremes(cells, "any", [&](const std::vector<Problem>& problems) {
    evaluated = problems.size();
    return all_sound(problems);
  });
  ASSERT_EQ(results.size(), cells.size());
  std::size_t refused = 0;
  for (const auto& result : results) {
    EXPECT_EQ(result.cell.group == "refused", !result.run) << result.cell.what << ": " << result.reason;
    if (result.run) continue;
    ++refused;
    EXPECT_EQ(result.outcome(), "refused");
    EXPECT_THAT(result.reason, HasSubstr("accepted:")) << result.cell.what;
  }
  EXPECT_GT(refused, 5u);
  EXPECT_EQ(evaluated, cells.size() - refused);
}

TEST(Extremes, TheSameImpactFromTenNanometresToAMetreIsOneProblem) {
  const auto results = run_extremes(extreme_cells(), "any", all_sound);
  std::string first;
  int same = 0;
  for (const auto& result : results)
    if (result.cell.group == "radius") {
      const std::string key = evaluation_key(result.run->reduction.problem, "any");
      if (first.empty()) first = key;
      EXPECT_EQ(key, first) << result.cell.what;
      same += !result.run->same_problem_as.empty();
    }
  EXPECT_GE(same, 5);
}

TEST(Extremes, AndGivesTheSameBits) {
  const auto at = [](const std::string& what) {
    Scene scene = cell(what).scene;
    *scene.solver.end_time /= 100;
    return run_impact(reduce(scene).problem);
  };
  const ImpactResult small = at("radius 10 nm"), large = at("radius 1 m");
  EXPECT_EQ(small.depth, large.depth);
  EXPECT_EQ(small.steps, large.steps);
  EXPECT_EQ(small.energy.sum(), large.energy.sum());
}

TEST(Extremes, ASoundRunHasNoTrouble) { EXPECT_THAT(judge_run(sound_result(), Problem{}), IsEmpty()); }

TEST(Extremes, SilentNonsenseIsTrouble) {
  const auto troubles = [](const std::function<void(ImpactResult&)>& spoil) {
    ImpactResult r = sound_result();
    spoil(r);
    return judge_run(r, Problem{}).size();
  };
  EXPECT_EQ(troubles([](auto& r) { r.depth = nan; }), 1u);
  EXPECT_EQ(troubles([](auto& r) { r.energy.hourglass = nan; }), 1u);
  EXPECT_EQ(troubles([](auto& r) { r.energy.elastic += 0.06; }), 1u);
  EXPECT_EQ(troubles([](auto& r) { r.energy.elastic += 0.04; }), 0u);
  EXPECT_EQ(troubles([](auto& r) { r.smallest_jacobian = -0.1; }), 1u);
  EXPECT_EQ(troubles([](auto& r) { r.depth = 100; }), 1u) << "below the bottom of 75 radii";
  EXPECT_EQ(troubles([](auto& r) {
              r.energy.viscosity = -0.3;
              r.energy.elastic += 0.3;
            }),
            1u);
}

TEST(Extremes, AnUnstableRunIsNoTroubleIfItSaysWhy) {
  ImpactResult r = sound_result();
  r.outcome = Outcome::unstable;
  r.energy.elastic = nan;
  EXPECT_EQ(judge_run(r, Problem{}).size(), 1u);
  r.reason = "a force is not finite";
  EXPECT_THAT(judge_run(r, Problem{}), IsEmpty());
}

TEST(Extremes, TroubleIsSeenInJsonAndPage) {
  const auto results = run_extremes({cell("alpha 9"), cell("alpha 25")}, "any", [](const auto& problems) {
    auto all = all_sound(problems);
    all[1].result.energy.elastic = 0.9;
    return all;
  });
  EXPECT_TRUE(has_troubles(results));
  EXPECT_FALSE(has_troubles({results[0]}));
  const auto json = extremes_to_json(results, {});
  EXPECT_THAT(json["cells"][0]["troubles"], IsEmpty());
  EXPECT_EQ(json["cells"][1]["troubles"][0], "the energy is +30.0 % off");
  EXPECT_EQ(json["summary"]["cells_with_troubles"], 1);
  EXPECT_THAT(extremes_csv(json), HasSubstr("the energy is +30.0 % off"));
}

TEST(Extremes, AnUnstableRunWithoutNumbersGivesNoNanInTheOutput) {
  const auto results = run_extremes({cell("alpha 9"), cell("nu 0.5")}, "any", [](const auto& problems) {
    auto all = all_sound(problems);
    all[0].result.outcome = Outcome::unstable;
    all[0].result.reason = "a force is not finite";
    all[0].result.depth = all[0].result.energy.elastic = nan;
    return all;
  });
  const auto json = extremes_to_json(results, {});
  expect_no_nan(json, "");
  EXPECT_TRUE(json["cells"][0]["energy_closure"].is_null());
  EXPECT_EQ(json["cells"][1]["outcome"], "refused");
  EXPECT_TRUE(json["cells"][1].contains("mach") && json["cells"][1]["mach"].is_null());
  for (const std::string& text : {json.dump(), extremes_csv(json)})
    EXPECT_EQ(text.find("nan"), std::string::npos) << text;
}

TEST(Extremes, AFewCellsForReal) {
  const auto results =
      run_extremes({cell("1 element per radius"), cell("pi4 1e-3"), cell("1.1 radii")}, "any", run_for_real);
  for (const auto& result : results) EXPECT_THAT(result.troubles, IsEmpty()) << result.cell.what;
  EXPECT_EQ(results[1].outcome(), "stopped") << results[1].reason;
  EXPECT_EQ(results[2].outcome(), "passed through") << results[2].reason;
}

TEST(SlowExtremes, EveryCellEndsAsANamedOutcomeWithoutTrouble) {
  const auto results = run_extremes(extreme_cells(), "any", run_for_real);
  const std::set<std::string> outcomes{"stopped", "passed through", "time up", "unstable", "refused"};
  for (const auto& result : results) {
    EXPECT_THAT(outcomes, testing::Contains(result.outcome())) << result.cell.what;
    EXPECT_THAT(result.troubles, IsEmpty()) << result.cell.group << ": " << result.cell.what;
    if (result.outcome() == "refused" || result.outcome() == "unstable") {
      EXPECT_FALSE(result.reason.empty()) << result.cell.what;
    }
  }
  expect_no_nan(extremes_to_json(results, {}), "");
}

}  // namespace
}  // namespace percal
