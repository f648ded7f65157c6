// The audit of omissions with a solver made up for it: depths that a known change moves by a known amount.
#include "percal/study/omissions.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "page/page_words.hpp"
#include "percal/problem/domain.hpp"
#include "percal/scene/scene_toml.hpp"
#include "percal/study/page/omissions.hpp"

namespace percal {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

Scene sample(const std::string& name) { return read_scene(PERCAL_DATA "/guha2009/" + name); }
Scene gold_sample() { return sample("gold.toml"); }

Evaluation stopped_at(double depth, double cpu_seconds = 1) {
  Evaluation evaluation;
  evaluation.result.outcome = Outcome::stopped;
  evaluation.result.depth = depth;
  evaluation.result.steps = 100;
  evaluation.result.energy.particle = 1;
  evaluation.cpu_seconds = cpu_seconds;
  return evaluation;
}

// 27 radii with a scatter of 1 %, changed by what `effect` says of the problem.
Replicator solver(std::function<Evaluation(const Problem&)> effect) {
  return [effect](const std::vector<Problem>& problems, int replicates) {
    std::vector<std::vector<Evaluation>> all;
    for (const Problem& problem : problems) {
      std::vector<Evaluation> runs;
      for (int k = 0; k < replicates; ++k) {
        runs.push_back(effect(problem));
        runs.back().result.depth *= 1 + 0.01 * std::sqrt(0.5) * (k - 2);  // of five: standard deviation 0.0112
      }
      all.push_back(runs);
    }
    return all;
  };
}
const Replicator nothing_matters = solver([](const Problem&) { return stopped_at(27); });

const AuditedOmission& named(const Omissions& audit, const std::string& name) {
  for (const auto& one : audit.omissions)
    if (one.variant.name == name) return one;
  throw std::runtime_error("no omission is called " + name);
}
std::vector<std::string> names(const Omissions& audit) {
  std::vector<std::string> list;
  for (const auto& one : audit.omissions) list.push_back(one.variant.name);
  return list;
}

TEST(Omissions, EverythingThatTheGoldSceneLeavesOutIsSwitchedOnOnce) {
  const Omissions audit = audit_omissions(gold_sample(), 5, nothing_matters);
  EXPECT_THAT(names(audit),
              testing::UnorderedElementsAre(
                  "elastic particle", "friction", "initial stretch", "fibres", "second layer of the same", "second layer twice as stiff", "relaxation",
                  "volumetric law quadratic", "volumetric law logarithmic", "eroded nodes in contact", "bottom fixed",
                  "width x 2", "thickness x 1.5", "hourglass stiffness 0.1", "hourglass stiffness 1",
                  "hourglass viscosity", "bulk viscosity halved", "no linear bulk viscosity", "21 elements per radius",
                  "half the time step", "one rate", "double precision", "K/mu x 4"));
  EXPECT_THAT(audit.skipped, IsEmpty());
}

TEST(Omissions, EachVariantIsAnotherProblemThatDiffersInWhatItSays) {
  const Scene scene = gold_sample();
  const Reduction baseline = reduce(scene);
  std::set<std::string> keys{evaluation_key(baseline.problem, "any")};
  const OmissionPlan plan = plan_omissions(scene, baseline, std::nullopt);
  for (const auto& variant : plan.variants)
    EXPECT_TRUE(keys.insert(evaluation_key(reduce(variant.scene).problem, "any")).second) << variant.name;
  const auto problem = [&](const std::string& name) {
    for (const auto& variant : plan.variants)
      if (variant.name == name) return reduce(variant.scene).problem;
    throw std::runtime_error(name);
  };
  EXPECT_NEAR(std::get<ElasticSphere>(problem("elastic particle").particle).youngs_modulus * 1000 * 651 * 651, 79e9, 10)
      << "to 12 digits";
  EXPECT_EQ(problem("width x 2").width, 10);
  EXPECT_EQ(problem("thickness x 1.5").depth, 112.5);
  EXPECT_EQ(problem("K/mu x 4").bulk_ratio, 200);
  const auto series = std::get<PronySeries>(problem("relaxation").relaxation);
  EXPECT_EQ(series.terms.at(0).share, 0.2);
  EXPECT_DOUBLE_EQ(series.terms.at(0).time, 1) << "a radius at impact speed";
}

TEST(Omissions, AWiderLayerKeepsTheGradingOfItsColumns) {
  const Scene scene = gold_sample();
  const OmissionPlan plan = plan_omissions(scene, reduce(scene), std::nullopt);
  const auto growth = [](const Problem& p) { return graded_mesh(mesh_options(p)).growth; };
  const auto wide = std::ranges::find(plan.variants, "width x 2", &OmissionVariant::name);
  EXPECT_NEAR(growth(reduce(wide->scene).problem), growth(reduce(scene).problem), 0.05);
}

TEST(Omissions, TheSecondLayerBeginsInTheMiddleOfThePenetrationAndTheTargetStaysAsDeep) {
  const Omissions audit = audit_omissions(gold_sample(), 5, nothing_matters);
  const Problem same = reduce(named(audit, "second layer of the same").variant.scene).problem;
  const Problem stiff = reduce(named(audit, "second layer twice as stiff").variant.scene).problem;
  ASSERT_EQ(same.below.size(), 1u);
  EXPECT_NEAR(same.depth, 13.5, 0.5 / 14);
  EXPECT_NEAR(same.depth * 14, std::round(same.depth * 14), 1e-9) << "between two rows of elements";
  EXPECT_NEAR(same.whole_depth(), 75, 1e-9);
  EXPECT_NEAR(same.below[0].mu, same.mu(), 1e-12);
  EXPECT_NEAR(stiff.below[0].mu, 2 * stiff.mu(), 1e-12);
  EXPECT_EQ(same.below[0].erosion_limit, 0.7);
  EXPECT_TRUE(named(audit, "second layer twice as stiff").variant.is_illustration);
}

TEST(Omissions, AnEffectIsFoundWithItsSizeAndComesFirst) {
  const Omissions audit =
      audit_omissions(gold_sample(), 5, solver([](const Problem& p) {
                        return stopped_at(p.bottom == Bottom::fixed ? 27 * 0.952 : 27, p.rates == 1 ? 1.5 : 1);
                      }));
  const AuditedOmission& first = audit.omissions.front();
  EXPECT_EQ(first.variant.name, "bottom fixed");
  EXPECT_NEAR(*first.change.share, -0.048, 1e-9);
  EXPECT_NEAR(*first.change.standard_error, 0.01118 * std::sqrt(2.0 / 5), 1e-4);
  EXPECT_EQ(first.effect, Effect::clear);
  EXPECT_EQ(first.verdict, "an effect of -4.8 +- 0.7 %");
  EXPECT_NEAR(named(audit, "one rate").change.cost_ratio, 1.5, 1e-12);
  EXPECT_EQ(named(audit, "one rate").effect, Effect::none);
  EXPECT_THAT(named(audit, "one rate").verdict, HasSubstr("no effect beyond noise"));
  EXPECT_THAT(audit.conclusions, Contains(AllOf(HasSubstr("domain is too small"), HasSubstr("bottom fixed (-4.8"))));
}

TEST(Omissions, BetweenTwoAndThreeStandardErrorsAnEffectIsOnlyPossible) {
  const auto with = [](double effect) {
    return audit_omissions(gold_sample(), 5, solver([effect](const Problem& p) {
                             return stopped_at(p.bottom == Bottom::fixed ? 27 * (1 + effect) : 27);
                           }));
  };
  EXPECT_EQ(named(with(0.012), "bottom fixed").effect, Effect::none);
  EXPECT_EQ(named(with(0.018), "bottom fixed").effect, Effect::possible);
  EXPECT_EQ(named(with(0.024), "bottom fixed").effect, Effect::clear);
}

TEST(Omissions, TwoMeansThatHappenToScatterLittleAreNotTakenForExact) {
  int calls = 0;
  const Replicator lucky = [&](const std::vector<Problem>& problems, int replicates) {
    auto all = nothing_matters(problems, replicates);
    for (auto& runs : all)
      if (calls++ < 2)  // the scene as it is and the first variant: no scatter, a difference of 0.2 %
        for (auto& run : runs) run.result.depth = calls == 1 ? 27 : 27.054;
    return all;
  };
  const Omissions audit = audit_omissions(gold_sample(), 5, lucky);
  EXPECT_EQ(named(audit, "elastic particle").effect, Effect::none);
  EXPECT_GT(*named(audit, "elastic particle").change.standard_error, 0.005);
}

TEST(Omissions, AVariantThatDoesNotStopIsToldByItsOutcomeAndStandsBeforeAll) {
  const Omissions audit = audit_omissions(gold_sample(), 5, solver([](const Problem& p) {
                                            Evaluation evaluation = stopped_at(27);
                                            if (p.eroded_nodes == ErodedNodes::in_contact) {
                                              evaluation.result.outcome = Outcome::passed_through;
                                              evaluation.result.depth = 75;
                                            }
                                            return evaluation;
                                          }));
  const AuditedOmission& first = audit.omissions.front();
  EXPECT_EQ(first.variant.name, "eroded nodes in contact");
  EXPECT_EQ(first.effect, Effect::ends_otherwise);
  EXPECT_EQ(first.verdict, "ends otherwise: passed through (5 of 5 runs)");
  EXPECT_FALSE(first.change.share.has_value());
  const auto json = omissions_to_json(gold_sample(), audit, {});
  EXPECT_TRUE(json["omissions"][0]["change"].is_null());
  EXPECT_EQ(json["omissions"][0]["effect"], "ends otherwise");
  EXPECT_THAT(audit.conclusions, Contains("changes how the particle ends: eroded nodes in contact"));
}

TEST(Omissions, ASceneThatDoesNotStopHasNothingToCompare) {
  const Omissions audit = audit_omissions(gold_sample(), 5, solver([](const Problem&) {
                                            Evaluation evaluation = stopped_at(75);
                                            evaluation.result.outcome = Outcome::passed_through;
                                            return evaluation;
                                          }));
  for (const auto& one : audit.omissions) EXPECT_EQ(one.effect, Effect::ends_otherwise) << one.variant.name;
  ASSERT_EQ(audit.conclusions.size(), 1u);
  EXPECT_THAT(audit.conclusions[0], HasSubstr("passed through (5 of 5 runs)"));
}

TEST(Omissions, TheListOfWhatWasLeftOutSaysHowEachEntryIsAudited) {
  const Omissions audit = audit_omissions(gold_sample(), 5, nothing_matters);
  ASSERT_EQ(audit.left_out.size(), audit.reduction.left_out.size());
  for (const auto& one : audit.left_out) EXPECT_NE(one.audited_by.empty(), one.why_not.empty()) << one.left_out.what;
  const auto entry = [&](const std::string& what) {
    for (const auto& one : audit.left_out)
      if (one.left_out.what == what) return one;
    throw std::runtime_error(what);
  };
  EXPECT_THAT(entry("elastic particle").audited_by, testing::ElementsAre("elastic particle"));
  EXPECT_THAT(entry("elastic particle").left_out.why, HasSubstr("is below 0.02"));
  EXPECT_THAT(entry("further layers").audited_by.size(), 2u);
  EXPECT_THAT(entry("rate dependence").audited_by, testing::ElementsAre("relaxation"));
  EXPECT_THAT(entry("double precision").audited_by, testing::ElementsAre("double precision"));
  EXPECT_THAT(entry("history").why_not, HasSubstr("changes no number"));
}

TEST(Omissions, WhatASceneCannotHaveIsSkippedWithTheReason) {
  Scene scene = gold_sample();
  scene.particle.youngs_modulus.reset();
  scene.target.erosion = NoErosion{};
  const Omissions audit = audit_omissions(scene, 5, nothing_matters);
  ASSERT_EQ(audit.skipped.size(), 2u);
  EXPECT_EQ(audit.skipped[0].name, "elastic particle");
  EXPECT_EQ(audit.skipped[0].why, "the scene gives no Young's modulus");
  EXPECT_EQ(audit.skipped[1].name, "eroded nodes in contact");
  const Omissions prism = audit_omissions(sample("rhombus.toml"), 5, nothing_matters);
  const auto elastic = std::ranges::find(prism.skipped, "elastic particle", &SkippedVariant::name);
  ASSERT_NE(elastic, prism.skipped.end());
  EXPECT_THAT(elastic->why, HasSubstr("only a sphere in an axisymmetric scene can be elastic"));
  EXPECT_TRUE(std::get<RigidPolygon>(reduce(named(prism, "rotation").variant.scene).problem.particle).free_rotation);
  EXPECT_TRUE(reduce(named(prism, "second half").variant.scene).problem.whole);
}

TEST(Omissions, WhatTheSceneHasIsTakenAwayInstead) {
  Scene scene = sample("skin_layers.toml");
  scene.particle.elasticity = Elasticity::elastic;
  scene.target.relaxation = PronySeries{{{0.3, 1e-9}}};
  scene.target.bottom = Bottom::fixed;
  scene.solver.eroded_nodes = ErodedNodes::in_contact;
  scene.solver.rates = 1;
  scene.solver.arithmetic = Arithmetic::double_precision;
  const Omissions audit = audit_omissions(scene, 5, nothing_matters);
  for (const char* name : {"rigid particle", "one layer", "no relaxation", "bottom free", "eroded nodes released",
                           "two rates", "single precision"})
    EXPECT_NO_THROW(named(audit, name)) << name;
  EXPECT_NEAR(reduce(named(audit, "one layer").variant.scene).problem.whole_depth(), 105, 1e-9);
  EXPECT_THAT(names(audit), Not(Contains("elastic particle")));
}

TEST(Omissions, TheTableHasALineForTheSceneAndOneForEach) {
  const Omissions audit = audit_omissions(gold_sample(), 5, nothing_matters);
  const auto result = omissions_to_json(gold_sample(), audit, {});
  const std::string csv = omissions_csv(result), page = test::words_of(omissions_page(result));
  EXPECT_EQ(std::ranges::count(csv, '\n'), 2 + static_cast<long>(audit.omissions.size()));
  EXPECT_THAT(csv, HasSubstr("\n\"as it is\",,stopped,"));
  for (const auto& one : audit.omissions) EXPECT_THAT(page, HasSubstr("\n" + one.variant.name));
  for (const auto& one : audit.left_out) EXPECT_THAT(page, HasSubstr(one.left_out.why));
}

}  // namespace
}  // namespace percal
