#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <map>

#include "percal/problem/problem.hpp"

namespace percal {
namespace {

Problem plainest() {
  Problem problem;
  problem.pi4 = 6.65;
  problem.density_ratio = 16.8;
  problem.alpha = 8.5;
  return problem;
}

std::string key(const Problem& problem) { return evaluation_key(problem, "level"); }

// Every way in which a problem can differ from the plainest one, each with the name of what it changes.
std::map<std::string, std::function<void(Problem&)>> changes() {
  const auto profile = [](auto change) {
    return [change](Problem& p) {
      RigidPolygon shape{.vertices = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}}, .mass = 2, .inertia = 0.5};
      change(shape);
      p.particle = shape;
    };
  };
  const auto layer = [](auto change) {
    return [change](Problem& p) {
      LowerLayer below{.depth = 10, .density = 1.1, .mu = 0.2, .alpha = 3, .bulk_ratio = 50, .erosion_limit = 0.7};
      change(below);
      p.below = {below};
    };
  };
  const auto series = [](std::vector<PronyTerm> terms) {
    return [terms](Problem& p) { p.relaxation = PronySeries{terms}; };
  };
  return {
      {"nothing", [](Problem&) {}},
      {"elements", [](Problem& p) { ++p.elements_per_radius; }},
      {"graded columns", [](Problem& p) { ++p.graded_columns; }},
      {"bottom", [](Problem& p) { p.bottom = Bottom::fixed; }},
      {"arithmetic", [](Problem& p) { p.arithmetic = Arithmetic::double_precision; }},
      {"geometry", [](Problem& p) { p.geometry = Geometry::plane_strain; }},
      {"whole", [](Problem& p) { p.geometry = Geometry::plane_strain, p.whole = true; }},
      {"rates", [](Problem& p) { p.rates = 1; }},
      {"until rest", [](Problem& p) { p.until = RunUntil::rest; }},
      {"until passage", [](Problem& p) { p.until = RunUntil::passage; }},
      {"hourglass form", [](Problem& p) { p.hourglass_form = HourglassForm::viscosity; }},
      {"volumetric law 1", [](Problem& p) { p.volumetric_law = VolumetricLaw::quadratic; }},
      {"volumetric law 2", [](Problem& p) { p.volumetric_law = VolumetricLaw::logarithmic; }},
      {"eroded nodes", [](Problem& p) { p.eroded_nodes = ErodedNodes::in_contact; }},
      {"strain", [](Problem& p) { p.erosion = StrainErosion{0.7}; }},
      {"another strain", [](Problem& p) { p.erosion = StrainErosion{0.71}; }},
      {"true strain",
       [](Problem& p) {
         p.erosion = StrainErosion{0.7, StrainMeasure::true_strain};
       }},
      {"stress", [](Problem& p) { p.erosion = StressErosion{0.7}; }},
      {"energy", [](Problem& p) { p.erosion = EnergyErosion{0.7}; }},
      {"strain and stress", [](Problem& p) { p.erosion = StrainErosion{0.7}, p.further_erosion.stress = 0.7; }},
      {"strain and energy", [](Problem& p) { p.erosion = StrainErosion{0.7}, p.further_erosion.energy = 0.7; }},
      {"all three",
       [](Problem& p) {
         p.erosion = StrainErosion{0.7}, p.further_erosion = {0.7, 0.7};
       }},
      {"stretch", [](Problem& p) { p.stretch = 1.1; }},
      {"stretch of a layer", layer([](LowerLayer& below) { below.stretch = 1.1; })},
      {"fibres",
       [](Problem& p) {
         p.fibres = PlanarFibres{1, 2, 0.4};
       }},
      {"fibres, dispersion",
       [](Problem& p) {
         p.fibres = PlanarFibres{1, 2, 0.45};
       }},
      {"fibres of a layer", layer([](LowerLayer& below) {
         below.fibres = PlanarFibres{1, 2, 0.4};
       })},
      {"friction", [](Problem& p) { p.friction = CoulombFriction{0.1}; }},
      {"friction, coefficient", [](Problem& p) { p.friction = CoulombFriction{0.2}; }},
      {"average", [](Problem& p) { p.erosion_average = AverageWithin{0.3}; }},
      {"average, length", [](Problem& p) { p.erosion_average = AverageWithin{0.4}; }},
      {"elastic",
       [](Problem& p) {
         p.particle = ElasticSphere{100, 0.3};
       }},
      {"elastic, E",
       [](Problem& p) {
         p.particle = ElasticSphere{101, 0.3};
       }},
      {"elastic, nu",
       [](Problem& p) {
         p.particle = ElasticSphere{100, 0.31};
       }},
      {"profile", profile([](RigidPolygon&) {})},
      {"profile, a corner", profile([](RigidPolygon& shape) { shape.vertices[2][1] += 1e-11; })},
      {"profile, a corner less", profile([](RigidPolygon& shape) { shape.vertices.pop_back(); })},
      {"profile, mass", profile([](RigidPolygon& shape) { shape.mass = 2.1; })},
      {"profile, inertia", profile([](RigidPolygon& shape) { shape.inertia = 0.51; })},
      {"profile, turning", profile([](RigidPolygon& shape) { shape.free_rotation = true; })},
      {"layer", layer([](LowerLayer&) {})},
      {"layer, depth", layer([](LowerLayer& below) { below.depth = 11; })},
      {"layer, density", layer([](LowerLayer& below) { below.density = 1.2; })},
      {"layer, mu", layer([](LowerLayer& below) { below.mu = 0.21; })},
      {"layer, alpha", layer([](LowerLayer& below) { below.alpha = -3; })},
      {"layer, bulk ratio", layer([](LowerLayer& below) { below.bulk_ratio = 51; })},
      {"layer, erosion", layer([](LowerLayer& below) { below.erosion_limit = 0.8; })},
      {"layer, no erosion", layer([](LowerLayer& b) { b.erosion_limit = std::numeric_limits<double>::infinity(); })},
      {"layer, further limit",
       [](Problem& p) {
         p.further_erosion.energy = 1;
         p.below = {LowerLayer{.depth = 10, .mu = 1, .further_erosion = {.energy = 2}}};
       }},
      {"layer without the further limit",
       [](Problem& p) {
         p.further_erosion.energy = 1;
         p.below = {LowerLayer{.depth = 10, .mu = 1}};
       }},
      {"two layers",
       [](Problem& p) {
         p.below = {LowerLayer{.depth = 10, .mu = 1}, LowerLayer{.depth = 10, .mu = 1}};
       }},
      {"series", series({{0.3, 2}})},
      {"series, share", series({{0.31, 2}})},
      {"series, time", series({{0.3, 2.1}})},
      {"series, two terms", series({{0.3, 2}, {0.3, 2}})},
      {"series, the other way round", series({{2, 0.3}})},
  };
}

TEST(EvaluationKey, NoTwoDifferentProblemsShareOne) {
  std::map<std::string, std::string> seen;
  for (const auto& [name, change] : changes()) {
    Problem problem = plainest();
    change(problem);
    const auto [place, is_new] = seen.emplace(key(problem), name);
    EXPECT_TRUE(is_new) << name << " has the key of " << place->second;
  }
  EXPECT_EQ(seen.size(), changes().size());
}

TEST(EvaluationKey, EveryNumberThatDecidesTheResultChangesIt) {
  for (double Problem::*number :
       {&Problem::pi4, &Problem::density_ratio, &Problem::alpha, &Problem::bulk_ratio, &Problem::depth, &Problem::width,
        &Problem::fine_width, &Problem::hourglass, &Problem::linear_viscosity, &Problem::quadratic_viscosity,
        &Problem::time_step_factor, &Problem::end_time, &Problem::speed_factor}) {
    Problem other = plainest();
    other.*number *= 1 + 1e-9;
    EXPECT_NE(key(other), key(plainest()));
  }
  EXPECT_NE(evaluation_key(plainest(), "other level"), key(plainest()));
}

TEST(EvaluationKey, AHistoryOrAChannelDoesNotChangeIt) {
  Problem problem = plainest();
  problem.history_samples = 400;
  problem.channel = true;
  EXPECT_EQ(key(problem), key(plainest()));
}

TEST(EvaluationKey, ThePlainestProblemSaysNothingOfWhatItDoesNotHave) {
  for (const char* word : {"plane", "whole", "below", "length", "relaxation", "profile", "elastic", "rates", "until"})
    EXPECT_EQ(key(plainest()).find(word), std::string::npos) << word;
}

}  // namespace
}  // namespace percal
