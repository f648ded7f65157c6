#include <gtest/gtest.h>

#include <random>

#include "percal/base/version.hpp"
#include "percal/problem/problem.hpp"
#include "percal/problem/replicates.hpp"

namespace percal {
namespace {

class RandomProblems {
 public:
  Problem operator()() {
    Problem p;
    for (double Problem::*number :
         {&Problem::pi4, &Problem::density_ratio, &Problem::alpha, &Problem::bulk_ratio, &Problem::depth,
          &Problem::width, &Problem::fine_width, &Problem::hourglass, &Problem::linear_viscosity,
          &Problem::quadratic_viscosity, &Problem::time_step_factor, &Problem::end_time})
      p.*number = number_of_any_size();
    p.alpha *= choice(2) ? 1 : -1;
    p.bottom = choice(2) ? Bottom::fixed : Bottom::free;
    p.geometry = choice(4) ? Geometry::axisymmetric : Geometry::plane_strain;
    p.whole = p.geometry == Geometry::plane_strain && choice(2);
    p.erosion = erosion();
    if (choice(3) == 0) p.erosion_average = AverageWithin{number_of_any_size()};
    p.elements_per_radius = round_to_12_digits(1 + choice(60) + choice(100) / 99.0);
    p.graded_columns = choice(40);
    p.hourglass_form = choice(2) ? HourglassForm::viscosity : HourglassForm::stiffness;
    p.volumetric_law = static_cast<VolumetricLaw>(choice(3));
    p.eroded_nodes = choice(2) ? ErodedNodes::in_contact : ErodedNodes::released;
    p.rates = 1 + choice(2);
    p.until = static_cast<RunUntil>(choice(3));
    p.arithmetic = choice(2) ? Arithmetic::double_precision : Arithmetic::single_precision;
    p.speed_factor = replicate_speed_factor(choice(9));
    for (int layers = choice(3); layers > 0; --layers)
      p.below.push_back({.depth = number_of_any_size(),
                         .density = number_of_any_size(),
                         .mu = number_of_any_size(),
                         .alpha = number_of_any_size(),
                         .bulk_ratio = number_of_any_size(),
                         .erosion_limit = choice(2) ? number_of_any_size() : INFINITY});
    return p;
  }

 private:
  int choice(int count) { return static_cast<int>(engine_() % static_cast<unsigned>(count)); }
  double number_of_any_size() {
    const double digits = 1 + static_cast<double>(engine_()) / 4.3e9 * 9;
    return round_to_12_digits(digits * std::pow(10.0, choice(12) - 6));
  }
  Erosion erosion() {
    const double limit = number_of_any_size();
    switch (choice(6)) {
      case 0: return NoErosion{};
      case 1: return StressErosion{limit};
      case 2: return EnergyErosion{limit};
      default: return StrainErosion{limit, static_cast<StrainMeasure>(choice(3))};
    }
  }
  std::mt19937 engine_{20090401};
};

TEST(ProblemOfKey, AProblemComesBackFromItsKey) {
  RandomProblems random;
  for (int i = 0; i < 500; ++i) {
    const Problem p = random();
    const std::string key = evaluation_key(p, "avx2");
    const auto found = problem_of_key(key, "avx2");
    ASSERT_TRUE(found) << key;
    EXPECT_EQ(evaluation_key(*found, "avx2"), key);
    EXPECT_EQ(found->pi4, p.pi4);
    EXPECT_EQ(found->alpha, p.alpha);
    EXPECT_EQ(found->erosion, p.erosion);
    EXPECT_EQ(found->below, p.below);
    EXPECT_EQ(found->elements_per_radius, p.elements_per_radius);
    EXPECT_DOUBLE_EQ(found->speed_factor, p.speed_factor);
    EXPECT_TRUE(key.starts_with(sphere_key_prefix("avx2")));
  }
}

TEST(ProblemOfKey, WhatItDoesNotKnowIsRefused) {
  const auto refused = [](auto change) {
    Problem p = RandomProblems{}();
    change(p);
    return !problem_of_key(evaluation_key(p, "avx2"), "avx2");
  };
  EXPECT_FALSE(refused([](Problem&) {}));
  EXPECT_TRUE(refused([](Problem& p) { p.particle = ElasticSphere{100, 0.3}; }));
  EXPECT_TRUE(refused([](Problem& p) { p.particle = RigidPolygon{.vertices = {{0, -1}, {1, 0}, {0, 1}}, .mass = 2}; }));
  EXPECT_TRUE(refused([](Problem& p) { p.below = {LowerLayer{.depth = 10, .mu = 1, .stretch = 1.1}}; }));
  EXPECT_TRUE(refused([](Problem& p) { p.relaxation = PronySeries{{{0.3, 2}}}; }));
}

TEST(ProblemOfKey, AnotherLevelVersionOrTextIsRefused) {
  std::string key = evaluation_key(RandomProblems{}(), "avx2");
  EXPECT_FALSE(problem_of_key(key, "avx512"));
  EXPECT_FALSE(problem_of_key("", "avx2"));
  EXPECT_FALSE(problem_of_key(key + " friction=0.1", "avx2"));
  const std::string now = "solver=" + std::to_string(solver_version);
  EXPECT_FALSE(problem_of_key(key.replace(key.find(now), now.size(), "solver=0"), "avx2"));
}

}  // namespace
}  // namespace percal
