// Polyhedra without dimensions: what is computed of a block, similar systems, the mass over the shadow.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "percal/problem/particle.hpp"
#include "percal/problem/problem.hpp"
#include "percal/scene/scene_toml.hpp"

namespace percal {
namespace {

std::string corner(const std::string& x, const std::string& y, const std::string& z, const std::string& unit) {
  return "[\"" + x + " " + unit + "\", \"" + y + " " + unit + "\", \"" + z + " " + unit + "\"], ";
}
std::string box_corners(const std::string& unit) {
  std::string list = "shape = \"polyhedron\"\nvertices = [";
  for (const char* x : {"-2", "2"})
    for (const char* y : {"-1", "1"})
      for (const char* z : {"0", "3"}) list += corner(x, y, z, unit);
  return list + "]\n";
}
std::string wedge_corners(const std::string& unit) {
  return "shape = \"polyhedron\"\nvertices = [" + corner("-2", "-1", "0", unit) + corner("2", "-1", "0", unit) +
         corner("0", "1", "0", unit) + corner("0", "0", "3", unit) + "]\n";
}
Scene into_gel(const std::string& particle, const std::string& unit) {
  return parse_scene(
      "geometry = \"block\"\n[particle]\n" + particle +
          "density = \"7 t/m3\"\nspeed = \"50 m/s\"\n[target]\ndensity = \"1 t/m3\"\nmu = \"1 MPa\"\nalpha = "
          "9\ndepth = \"75 " +
          unit + "\"\nwidth = \"12 " + unit + "\"\n",
      "scene.toml");
}

TEST(PolyhedronProblem, SimilarOnesAreOneProblem) {
  for (const auto& corners_in : {box_corners, wedge_corners})
    EXPECT_EQ(reduce(into_gel(corners_in("mm"), "mm")).problem, reduce(into_gel(corners_in("um"), "um")).problem);
}

TEST(PolyhedronProblem, ItsMassOverItsShadowIsThePrisms) {
  const std::string prism =
      "shape = \"profile\"\nthickness = \"2 mm\"\nvertices = [[\"-2 mm\", \"0 mm\"], [\"2 mm\", \"0 mm\"], [\"2 mm\", "
      "\"3 "
      "mm\"], [\"-2 mm\", \"3 mm\"]]\n";
  const Reduction by_corners = reduce(into_gel(box_corners("mm"), "mm")), by_profile = reduce(into_gel(prism, "mm"));
  EXPECT_NEAR(sectional_density(by_corners.problem, by_corners.scales), 7000 * 0.003, 1e-9);
  EXPECT_NEAR(sectional_density(by_profile.problem, by_profile.scales), 7000 * 0.003, 1e-9);
  EXPECT_EQ(by_corners.problem.elements_per_radius, by_profile.problem.elements_per_radius);
  EXPECT_EQ(by_corners.problem.block, by_profile.problem.block);
}

TEST(PolyhedronProblem, WhatIsLeftOutOfABlockIsSaid) {
  const auto left_out = [](const std::string& particle) {
    std::vector<std::string> names;
    for (const LeftOut& omission : reduce(into_gel(particle, "mm")).left_out) names.push_back(omission.what);
    return names;
  };
  using testing::AllOf, testing::Contains, testing::Not;
  const std::string free = "rotation = \"free\"\n";
  EXPECT_THAT(left_out(box_corners("mm")), AllOf(Contains("three quarters"), Contains("rotation")));
  EXPECT_THAT(left_out(box_corners("mm") + free), AllOf(Contains("second half"), Not(Contains("rotation"))));
  EXPECT_THAT(left_out(wedge_corners("mm")), AllOf(Contains("second half"), Contains("rotation")));
  EXPECT_THAT(left_out(wedge_corners("mm") + free),
              AllOf(Not(Contains("second half")), Not(Contains("three quarters"))));
}

}  // namespace
}  // namespace percal
