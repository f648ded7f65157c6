#include <gtest/gtest.h>

#include <algorithm>
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
    p.geometry = static_cast<Geometry>(std::max(0, choice(5) - 2));
    p.whole = p.geometry != Geometry::axisymmetric && choice(2);
    if (p.geometry == Geometry::block)
      p.block = {number_of_any_size(), number_of_any_size(), number_of_any_size(), number_of_any_size()};
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
    p.speed_factor = replicate_speed_factor(choice(400));
    p.particle = particle();
    p.further_erosion = further();
    p.stretch = stretch();
    p.fibres = fibres();
    if (choice(3) == 0) p.stretch_across = stretch();
    if (choice(3) == 0) p.friction = CoulombFriction{number_of_any_size()};
    if (choice(3) == 0) p.relaxation = PronySeries{{{0.3, number_of_any_size()}, {0.1, number_of_any_size()}}};
    for (int layers = choice(3); layers > 0; --layers)
      p.below.push_back(
          {.depth = number_of_any_size(),
           .density = number_of_any_size(),
           .mu = number_of_any_size(),
           .alpha = number_of_any_size(),
           .bulk_ratio = number_of_any_size(),
           .erosion_limit = choice(2) ? number_of_any_size() : INFINITY,
           .further_erosion = p.further_erosion.is_empty() ? FurtherErosion{} : further(),  // as scenes have it
           .stretch = stretch(),
           .fibres = fibres()});
    return p;
  }

 private:
  int choice(int count) { return static_cast<int>(engine_() % static_cast<unsigned>(count)); }
  double number_of_any_size() {
    const double digits = 1 + static_cast<double>(engine_()) / 4.3e9 * 9;
    return round_to_12_digits(digits * std::pow(10.0, choice(12) - 6));
  }
  Particle particle() {
    switch (choice(3)) {
      case 0: return ElasticSphere{number_of_any_size(), 0.3};
      case 1:
        return RigidPolygon{.vertices = {{0, -number_of_any_size()}, {1, 0}, {-0.577350269190, number_of_any_size()}},
                            .mass = number_of_any_size(),
                            .inertia = number_of_any_size(),
                            .free_rotation = choice(2) == 0,
                            .half_thickness = choice(2) ? 0 : number_of_any_size()};
      default: return RigidSphere{};
    }
  }
  FurtherErosion further() {
    FurtherErosion limits;
    if (choice(3) == 0) limits.stress = number_of_any_size();
    if (choice(3) == 0) limits.energy = number_of_any_size();
    return limits;
  }
  double stretch() { return choice(2) ? 1 : 1.05; }
  Fibres fibres() {
    if (choice(2)) return NoFibres{};
    if (choice(2)) return FibreFamilies{number_of_any_size(), number_of_any_size(), 0.1, 0.5};
    return PlanarFibres{number_of_any_size(), number_of_any_size(), 0.4};
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
  int spheres = 0;
  for (int i = 0; i < 500; ++i) {
    const Problem p = random();
    const std::string key = evaluation_key(p, "avx2");
    const auto found = problem_of_key(key, "avx2");
    ASSERT_TRUE(found) << key;
    EXPECT_EQ(evaluation_key(*found, "avx2"), key);
    EXPECT_TRUE(*found == p) << key;
    if (!std::holds_alternative<RigidSphere>(p.particle) || p.geometry == Geometry::block) continue;
    ++spheres;
    EXPECT_TRUE(key.starts_with(sphere_key_prefix("avx2")));
  }
  EXPECT_GT(spheres, 100);
}

TEST(ProblemOfKey, APartThatIsNotKnownIsRefused) {
  const std::string key = evaluation_key(RandomProblems{}(), "avx2");
  EXPECT_FALSE(problem_of_key(key + " tilt=5", "avx2"));
  EXPECT_FALSE(problem_of_key(key + " frozen", "avx2"));
}

TEST(ProblemOfKey, AnotherLevelVersionOrTextIsRefused) {
  Problem p = RandomProblems{}();
  p.geometry = Geometry::axisymmetric;
  std::string key = evaluation_key(p, "avx2");
  EXPECT_FALSE(problem_of_key(key, "avx512"));
  EXPECT_FALSE(problem_of_key("", "avx2"));
  const std::string now = "solver=" + std::to_string(solver_version);
  EXPECT_FALSE(problem_of_key(key.replace(key.find(now), now.size(), "solver=0"), "avx2"));
  p.geometry = Geometry::block;
  key = evaluation_key(p, "avx2");
  const std::string of_a_block = "solver=solid-" + std::to_string(solid_version);
  EXPECT_TRUE(problem_of_key(key, "avx2"));
  EXPECT_FALSE(problem_of_key(key.replace(key.find(of_a_block), of_a_block.size(), "solver=solid-0"), "avx2"));
}

}  // namespace
}  // namespace percal
