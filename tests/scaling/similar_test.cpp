#include "percal/scaling/similar.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "percal/base/error.hpp"
#include "systems.hpp"

namespace percal {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::ThrowsMessage;

std::string source_of(const Completion& completion, const std::string& key) {
  auto found = std::ranges::find_if(completion.derived, [&](const Derived& one) { return one.quantity->key == key; });
  return found == completion.derived.end() ? "not derived" : found->because->symbol;
}

TEST(Completion, OfASteelBallFindsTheWholeModel) {
  auto completion = complete(gold_in_skin(), steel_ball());
  const auto& model = completion.model;
  EXPECT_THAT(completion.conflicts, IsEmpty());
  EXPECT_THAT(completion.gaps, IsEmpty());
  EXPECT_NEAR(model.target_density.value(), 464.2857, 1e-4);
  EXPECT_NEAR(*model.mu / *gold_in_skin().mu, 0.00754709, 1e-8);
  EXPECT_NEAR(model.depth.value(), 119.25e-3, 1e-12);
  EXPECT_NEAR(model.width.value(), 7.95e-3, 1e-12);
  EXPECT_NEAR(model.penetration.value(), 41.34e-3, 1e-12);
  EXPECT_EQ(model.alpha, 8.5);
  EXPECT_EQ(model.erosion_strain, 0.7);
  EXPECT_EQ(model.particle_modulus, 210e9) << "steel stays steel";
  EXPECT_EQ(source_of(completion, "target_density"), "pi5");
  EXPECT_EQ(source_of(completion, "mu"), "pi4");
  EXPECT_EQ(source_of(completion, "depth"), "pi1");
  EXPECT_EQ(source_of(completion, "penetration"), "pi8");
}

TEST(Completion, MakesEveryDemandedGroupAgreeExactly) {
  auto model = complete(gold_in_skin(), steel_ball()).model;
  for (const auto& one : compare(gold_in_skin(), model, exact_agreement)) {
    if (one.group->number > 8) continue;  // neither rate nor time is said
    EXPECT_EQ(one.agreement, one.group->number == 3 ? Agreement::differ : Agreement::agree) << one.group->symbol;
  }
}

TEST(Completion, FindsTheSpeedFromAModulusAndTheDensityFromASpeed) {
  auto ball = steel_ball();
  ball.speed.reset();
  ball.mu = *gold_in_skin().mu * (7.8 / 16.8) * (83.0 / 651) * (83.0 / 651);
  auto with_modulus = complete(gold_in_skin(), ball);
  EXPECT_NEAR(with_modulus.model.speed.value(), 83, 1e-12);
  EXPECT_EQ(source_of(with_modulus, "speed"), "pi4");

  ball.speed = 83;
  ball.particle_density.reset();
  auto with_both = complete(gold_in_skin(), ball);
  EXPECT_NEAR(with_both.model.target_density.value(), 464.2857, 1e-4);
  EXPECT_NEAR(with_both.model.particle_density.value(), 7800, 1e-9);
}

TEST(Completion, FindsTheBallFromTheDepthOfTheGelatin) {
  auto ball = steel_ball();
  ball.radius.reset();
  ball.depth = 0.1;
  EXPECT_NEAR(complete(gold_in_skin(), ball).model.radius.value(), 0.1 / 75, 1e-15);
}

TEST(Completion, NeverDerivesABallFromAResponseOrFromTheParticlesModulus) {
  auto ball = steel_ball();
  ball.radius.reset();
  ball.penetration = 4e-2;
  EXPECT_FALSE(complete(gold_in_skin(), ball).model.radius);
  ball.particle_density.reset();
  EXPECT_FALSE(complete(gold_in_skin(), ball).model.particle_density);
}

TEST(Completion, WithoutAParticleModulusFindsTheSimilarOne) {
  auto ball = steel_ball();
  ball.particle_modulus.reset();
  EXPECT_NEAR(complete(gold_in_skin(), ball).model.particle_modulus.value(), 79e9 * 0.00754709, 79e9 * 1e-8);
}

TEST(Completion, NamesTheTiedNumbersWhereTheInputIsTooLittle) {
  auto ball = steel_ball();
  ball.speed.reset();
  auto completion = complete(gold_in_skin(), ball);
  ASSERT_THAT(completion.gaps, SizeIs(1));
  EXPECT_THAT(describe(completion.gaps[0]),
              AllOf(HasSubstr("pi4"), HasSubstr("speed and mu are missing"), HasSubstr("give one")));
  EXPECT_THAT([&] { require_similar(completion, "job.toml"); },
              ThrowsMessage<BadInput>(AllOf(HasSubstr("job.toml"), HasSubstr("pi4"))));
}

TEST(Completion, SaysWhatToLeaveOutWhereTheInputIsTooMuch) {
  auto ball = steel_ball();
  ball.target_density = 1010;  // real gelatin
  auto completion = complete(gold_in_skin(), ball);
  ASSERT_THAT(completion.conflicts, SizeIs(1));
  EXPECT_THAT(describe(completion.conflicts[0]),
              AllOf(HasSubstr("pi5"), HasSubstr("target_density (it would be 464.286 kg/m3)"),
                    HasSubstr("particle_density (it would be 16968 kg/m3)")));
  EXPECT_EQ(source_of(completion, "mu"), "pi4") << "the rest is still completed, with the density that was given";
  EXPECT_THAT([&] { require_similar(completion, "job.toml"); }, ThrowsMessage<BadInput>(HasSubstr("over-determined")));
}

TEST(Completion, NamesOnlyGivenNumbersAsTheOnesToLeaveOut) {
  auto ball = steel_ball();
  ball.mu = 1e6;  // beside the speed and, through pi5, the target density
  auto completion = complete(gold_in_skin(), ball);
  ASSERT_THAT(completion.conflicts, SizeIs(1));
  EXPECT_EQ(completion.conflicts[0].group->symbol, "pi4");
  ASSERT_THAT(completion.conflicts[0].instead, SizeIs(2));
  EXPECT_EQ(completion.conflicts[0].instead[0].quantity->key, "speed");
  EXPECT_NEAR(completion.conflicts[0].instead[1].value, 481127, 1) << "mu";
}

TEST(Completion, ComparesAGivenPenetrationWithoutCallingItAConflict) {
  auto ball = steel_ball();
  ball.penetration = 4.05e-2;
  auto completion = complete(gold_in_skin(), ball);
  EXPECT_THAT(completion.conflicts, IsEmpty());
  EXPECT_NEAR(compare(gold_in_skin(), completion.model, 0.01)[7].difference.value(), 4.05 / 4.134 - 1, 1e-12);
}

TEST(Completion, LeavesOutWhatThePrototypeDoesNotSay) {
  auto gold = gold_in_skin();
  gold.erosion_strain.reset();
  gold.penetration.reset();
  auto completion = complete(gold, steel_ball());
  EXPECT_FALSE(completion.model.erosion_strain || completion.model.penetration);
  EXPECT_NO_THROW(require_similar(completion, "job.toml"));
}

TEST(Mapping, CarriesAQuantityAsTheCompletionDoes) {
  auto gold = gold_in_skin();
  gold.time = 1e-7;
  auto steel = complete(gold, steel_ball()).model;
  EXPECT_DOUBLE_EQ(map_penetration(*gold.penetration, gold, steel), *steel.penetration);
  EXPECT_DOUBLE_EQ(map_modulus(*gold.mu, gold, steel), *steel.mu);
  EXPECT_DOUBLE_EQ(map_time(*gold.time, gold, steel), *steel.time);
}

TEST(Mapping, ThereAndBackIsWhereItStarted) {
  auto gold = gold_in_skin(), steel = steel_in_gelatin();
  EXPECT_DOUBLE_EQ(map_modulus(map_modulus(15e6, gold, steel), steel, gold), 15e6);
  EXPECT_DOUBLE_EQ(map_time(map_time(1e-7, gold, steel), steel, gold), 1e-7);
}

TEST(Mapping, SaysWhichNumberOfWhichSystemIsMissing) {
  auto steel = steel_ball();
  EXPECT_THAT([&] { modulus_ratio(gold_in_skin(), steel); },
              ThrowsMessage<BadInput>(AllOf(HasSubstr("steel into gelatin"), HasSubstr("target_density"))));
}

}  // namespace
}  // namespace percal
