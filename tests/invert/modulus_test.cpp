// The inversion on closed-form forward models: ln depth = a line in ln modulus, with and without noise.
#include "percal/invert/modulus.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace percal {
namespace {

constexpr double root = 2.3;  // ln modulus at which the depth is the target
constexpr double target = 26;

DepthAnswer deep(double depth) { return {.depth = depth, .censored = false, .valid = true, .why = ""}; }
DepthAnswer at_least(double depth) { return {.depth = depth, .censored = true, .valid = true, .why = ""}; }
DepthAnswer no_answer(const std::string& why) { return {.depth = 0, .censored = false, .valid = false, .why = why}; }

// depth = target (modulus/e^root)^-exponent.
DepthOfModulus power_law(double exponent) {
  return [exponent](double x) { return deep(target * std::exp(-exponent * (x - root))); };
}

InversionOptions from(double start) { return {.target = target, .start = start}; }

TEST(Inversion, FindsTheRootOfAPowerLawExactly) {
  for (const double exponent : {0.3, 0.6, 1.0})
    for (const double start : {root - 2, root - 0.4, root, root + 0.05, root + 3}) {
      const Inversion found = invert_modulus(power_law(exponent), from(start));
      ASSERT_EQ(found.outcome, InversionOutcome::found) << exponent << " " << start;
      EXPECT_NEAR(found.log_modulus, root, 1e-9);
      EXPECT_NEAR(found.slope, -exponent, 1e-9);
      EXPECT_LE(found.points.size(), 24u);
    }
}

TEST(Inversion, FindsTheRootOfACurvedLaw) {
  const DepthOfModulus forward = [](double x) { return deep(target * (1.4 - std::atan(1.3 * (x - root))) / 1.4); };
  const Inversion found = invert_modulus(forward, from(root + 1));
  ASSERT_EQ(found.outcome, InversionOutcome::found);
  EXPECT_NEAR(found.log_modulus, root, 3 * found.log_modulus_error);
}

TEST(Inversion, ItsErrorIsNotBelowTheNoiseItWasTold) {
  InversionOptions options = from(root + 0.7);
  options.noise = 0.02;
  const Inversion found = invert_modulus(power_law(0.6), options);
  EXPECT_NEAR(found.scatter, 0.02, 1e-12) << "answers without scatter are not believed";
  EXPECT_GE(found.log_modulus_error, 0.02 / 0.6 / std::sqrt(static_cast<double>(found.points.size())) * 0.99);
}

// Noise of the size that replicates have. The expected error of the options is right, too small and too large in turn.
TEST(Inversion, ItsStandardErrorIsHonest) {
  for (const double noise : {0.008, 0.015, 0.03}) {
    int found_all = 0, within_two = 0;
    double squares = 0;
    constexpr int problems = 200;
    for (int k = 0; k < problems; ++k) {
      std::mt19937 random(1000 + k);
      std::normal_distribution<double> normal;
      const double exponent = std::uniform_real_distribution<double>(0.3, 0.9)(random);
      const double start = root + std::uniform_real_distribution<double>(-1.5, 1.5)(random);
      const DepthOfModulus forward = [&](double x) {
        return deep(target * std::exp(-exponent * (x - root) + noise * normal(random)));
      };
      const Inversion found = invert_modulus(forward, from(start));
      found_all += found.outcome == InversionOutcome::found;
      within_two += std::abs(found.log_modulus - root) < 2 * found.log_modulus_error;
      squares += std::pow((found.log_modulus - root) / found.log_modulus_error, 2) / problems;
    }
    EXPECT_EQ(found_all, problems) << noise;
    EXPECT_GE(within_two, 0.85 * problems) << noise;
    if (noise >= 0.015) {
      EXPECT_LE(within_two, 0.99 * problems) << noise;
    }
    RecordProperty("mean_square_" + std::to_string(noise), std::to_string(squares));
  }
}

// A layer of 29: what is a little softer is passed through.
TEST(Inversion, AnswersThatAreOnlyBoundsGuideTheSearchAndStayOutOfTheLine) {
  int censored = 0;
  const DepthOfModulus forward = [&](double x) {
    const double depth = target * std::exp(-0.6 * (x - root));
    censored += depth > 29;
    return depth > 29 ? at_least(29) : deep(depth);
  };
  const Inversion found = invert_modulus(forward, from(root - 3));
  ASSERT_EQ(found.outcome, InversionOutcome::found);
  EXPECT_GT(censored, 2);
  EXPECT_NEAR(found.log_modulus, root, 1e-9) << "as if the bounds were not there";
}

TEST(Inversion, ATargetThatNoModulusReachesIsOutOfReach) {
  const DepthOfModulus flat = [](double) { return deep(2 * target); };
  const Inversion found = invert_modulus(flat, from(root));
  EXPECT_EQ(found.outcome, InversionOutcome::out_of_reach);
  EXPECT_FALSE(found.points.empty());
  for (const auto& point : found.points) {
    EXPECT_GE(point.log_modulus, root) << "a depth too large asks for a stiffer material";
    EXPECT_LE(point.log_modulus, root + 6);
  }
  const DepthOfModulus shallow = [](double) { return deep(0.5 * target); };
  for (const auto& point : invert_modulus(shallow, from(root)).points) EXPECT_LE(point.log_modulus, root);
}

TEST(Inversion, AnAnswerThatIsNotValidEndsItWithTheReason) {
  const DepthOfModulus breaking = [](double x) {
    return x > root + 0.5 ? deep(2 * target) : no_answer("unstable: the time step collapsed");
  };
  const Inversion found = invert_modulus(breaking, from(root + 0.4));
  EXPECT_EQ(found.outcome, InversionOutcome::failed);
  EXPECT_EQ(found.why, "unstable: the time step collapsed");
  // A failure while Brent's method (C code) is at work ends it in the same way.
  int calls = 0;
  const DepthOfModulus late = [&](double x) { return ++calls == 4 ? no_answer("the fourth") : power_law(0.6)(x); };
  EXPECT_EQ(invert_modulus(late, from(root + 0.9)).why, "the fourth");
}

TEST(Inversion, ADepthOfZeroOrNanIsNotAnAnswer) {
  for (const double depth : {0.0, -1.0, std::nan("")}) {
    const DepthOfModulus forward = [depth](double) { return deep(depth); };
    EXPECT_EQ(invert_modulus(forward, from(root)).outcome, InversionOutcome::failed) << depth;
  }
}

TEST(Inversion, StopsAtTheNumberOfEvaluationsItMayUse) {
  int calls = 0;
  const DepthOfModulus counted = [&](double x) {
    ++calls;
    return power_law(0.6)(x);
  };
  InversionOptions options = from(root - 5);
  options.most_evaluations = 3;
  const Inversion found = invert_modulus(counted, options);
  EXPECT_EQ(found.outcome, InversionOutcome::out_of_evaluations);
  EXPECT_EQ(calls, 3);
  EXPECT_EQ(found.points.size(), 3u);
}

TEST(Inversion, KeepsEveryAnswerInItsOrder) {
  std::vector<double> asked;
  const DepthOfModulus forward = [&](double x) {
    asked.push_back(x);
    return power_law(0.6)(x);
  };
  const Inversion found = invert_modulus(forward, from(root + 1.3));
  ASSERT_EQ(found.points.size(), asked.size());
  for (std::size_t k = 0; k < asked.size(); ++k) EXPECT_EQ(found.points[k].log_modulus, asked[k]);
  std::sort(asked.begin(), asked.end());
  EXPECT_EQ(std::adjacent_find(asked.begin(), asked.end()), asked.end()) << "nothing is asked twice";
}

TEST(Inversion, ItsOutcomesHaveWords) {
  EXPECT_EQ(word(InversionOutcome::found), "found");
  EXPECT_EQ(word(InversionOutcome::out_of_reach), "out of reach");
  EXPECT_EQ(word(InversionOutcome::failed), "failed");
  EXPECT_EQ(word(InversionOutcome::out_of_evaluations), "out of evaluations");
}

}  // namespace
}  // namespace percal
