// Polyhedra in a block's scene: CSV, STL and arrays, what they become, and what is refused.
#include "percal/scene/polyhedron_toml.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>

#include "percal/problem/problem.hpp"
#include "percal/scene/profile.hpp"
#include "percal/scene/scene_toml.hpp"
#include "scene/refusal.hpp"

namespace percal {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::string heavy = "density = \"7 t/m3\"\n";

std::string body_scene(const std::string& lines, const std::string& rest = "", const std::string& geometry = "block") {
  return "geometry = \"" + geometry + "\"\n[particle]\nshape = \"polyhedron\"\nspeed = \"50 m/s\"\n" + lines +
         test::block_target + rest;
}
Scene scene_with(const std::string& lines, const std::string& rest = "") {
  return parse_scene(body_scene(lines, rest), "scene.toml");
}
std::string body_refusal(const std::string& lines, const std::string& rest = "",
                         const std::string& geometry = "block") {
  return test::refusal(body_scene(lines, rest, geometry));
}

std::string triples(const Vertices& points, const std::string& unit = "mm") {
  std::string text = "vertices = [";
  for (const auto& [x, y, z] : points)
    text += "[\"" + std::to_string(x) + " " + unit + "\", \"" + std::to_string(y) + " " + unit + "\", \"" +
            std::to_string(z) + " " + unit + "\"], ";
  return text + "]\n";
}

const Vertices brick{{-2, -1, 0}, {2, -1, 0}, {-2, 1, 0}, {2, 1, 0}, {-2, -1, 3}, {2, -1, 3}, {-2, 1, 3}, {2, 1, 3}};
const Vertices splinter{{-1, -1, 0}, {1, -0.5, 0}, {0, 1, 0.25}, {0.25, 0, 2}};

const PolyhedronShape& polyhedron_in(const Scene& scene) { return std::get<PolyhedronShape>(scene.particle.shape); }
const RigidPolyhedron& reduced_in(const Scene& scene, Reduction& reduction) {
  reduction = reduce(scene);
  return std::get<RigidPolyhedron>(reduction.problem.particle);
}

// A folder of its own with the files of bodies; scenes lie there, too.
class PolyhedronFiles : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  void put(const std::string& name, const std::string& content) {
    std::ofstream(folder_ / name, std::ios::binary) << content;
  }
  Scene read(const std::string& lines) {
    put("scene.toml", body_scene(lines));
    return read_scene((folder_ / "scene.toml").string());
  }
  std::string refused(const std::string& lines) {
    try {
      read(lines);
      return "accepted";
    } catch (const BadInput& error) {
      return error.what();
    }
  }
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("percal_polyhedron_test_" + std::to_string(getpid()));
};

std::string text_stl(const Vertices& points, const std::vector<std::vector<int>>& faces) {
  std::string text = "solid body\n";
  for (const auto& face : faces)
    for (std::size_t k = 1; k + 1 < face.size(); ++k) {
      text += "facet normal 0 0 0\nouter loop\n";
      for (const int corner : {face[0], face[k], face[k + 1]}) {
        const auto& [x, y, z] = points[corner];
        text += "vertex " + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
      }
      text += "endloop\nendfacet\n";
    }
  return text + "endsolid body\n";
}

std::string binary_stl(const Vertices& points, const std::vector<std::vector<int>>& faces) {
  std::string triangles;
  std::uint32_t count = 0;
  for (const auto& face : faces)
    for (std::size_t k = 1; k + 1 < face.size(); ++k, ++count) {
      triangles.append(12, '\0');
      for (const int corner : {face[0], face[k], face[k + 1]})
        for (const double coordinate : points[corner]) {
          const auto number = static_cast<float>(coordinate);
          triangles.append(reinterpret_cast<const char*>(&number), 4);
        }
      triangles.append(2, '\0');
    }
  return std::string(80, ' ') + std::string(reinterpret_cast<const char*>(&count), 4) + triangles;
}

TEST_F(PolyhedronFiles, CsvAndBothFormsOfStlAreTheSameBody) {
  const Polyhedron body = convex_polyhedron(splinter);
  put("body.csv", "# mm\nx_mm,y_mm,z_mm\n-1,-1,0\n1,-0.5,0\n0,1,0.25\n0.25,0,2\n");
  put("text.stl", text_stl(splinter, body.faces));
  put("binary.STL", binary_stl(splinter, body.faces));
  Reduction by_array, other;
  const RigidPolyhedron expected = reduced_in(scene_with(triples(splinter) + heavy), by_array);
  for (const std::string& file : {"vertices = \"body.csv\"\n", "vertices = \"text.stl\"\nstl_unit = \"1 mm\"\n",
                                  "vertices = \"binary.STL\"\nstl_unit = \"1 mm\"\n"}) {
    const Scene scene = read(file + heavy);
    EXPECT_EQ(polyhedron_in(scene).vertices.size(), 4u);
    EXPECT_THAT(polyhedron_in(scene).vertices_file, HasSubstr(folder_.string()));
    EXPECT_EQ(reduced_in(scene, other), expected) << file;
    EXPECT_EQ(evaluation_key(other.problem, "x"), evaluation_key(by_array.problem, "x")) << file;
  }
}

TEST_F(PolyhedronFiles, WhatIsNotConvexIsRefusedWithFileAndLine) {
  put("dented.csv", "x_mm,y_mm,z_mm\n-1,-1,0\n1,-1,0\n0,1,0\n0,0,0.5\n0,0,2\n");
  EXPECT_THAT(
      refused("vertices = \"dented.csv\"\n" + heavy),
      HasSubstr("dented.csv:5: particle.vertices: found a point inside the convex hull of the others; accepted: the "
                "corners of a convex polyhedron, 4 to 500 of them"));
  put("flat.csv", "x_mm,y_mm,z_mm\n-1,-1,0\n1,-1,0\n0,1,0\n1,1,0\n");
  EXPECT_THAT(refused("vertices = \"flat.csv\"\n" + heavy),
              HasSubstr("flat.csv: particle.vertices: found points in one plane"));
  put("bare.csv", "x,y,z\n-1,-1,0\n1,-1,0\n0,1,0\n0,0,2\n");
  EXPECT_NE(refused("vertices = \"bare.csv\"\n" + heavy), "accepted") << "no unit";
  put("two.csv", "x_mm,y_mm\n-1,-1\n1,-1\n0,1\n0,0\n");
  EXPECT_THAT(refused("vertices = \"two.csv\"\n" + heavy), HasSubstr("z"));
  EXPECT_THAT(refused("vertices = \"none.csv\"\n" + heavy), HasSubstr("there is no such file"));

  const Polyhedron body = convex_polyhedron(splinter);
  // A fifth point within: three triangles in place of the first face.
  Vertices points = splinter;
  auto faces = body.faces;
  points.push_back({0, 0, 0.4});
  const auto first = faces.front();
  faces.erase(faces.begin());
  for (int k = 0; k < 3; ++k) faces.push_back({first[k], first[(k + 1) % 3], 4});
  const std::string unit = "stl_unit = \"1 mm\"\n";
  put("dented.stl", text_stl(points, faces));
  EXPECT_THAT(
      refused("vertices = \"dented.stl\"\n" + unit + heavy),
      AllOf(HasSubstr("dented.stl:27: particle.vertices: found a point inside"), HasSubstr("accepted: the corners")));
  put("open.stl", text_stl(splinter, {body.faces[0], body.faces[1], body.faces[2]}));
  EXPECT_THAT(refused("vertices = \"open.stl\"\n" + unit + heavy),
              HasSubstr("open.stl: particle.vertices: found triangles that cover"));
  auto inner = convex_polyhedron(brick).faces;
  inner.push_back({0, 1, 7});
  put("inner.stl", text_stl(brick, inner));
  EXPECT_THAT(refused("vertices = \"inner.stl\"\n" + unit + heavy), HasSubstr("inside the convex hull of all"));
  put("broken.stl", "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0\n");
  EXPECT_THAT(refused("vertices = \"broken.stl\"\n" + unit + heavy), HasSubstr("broken.stl:4: found"));
}

TEST_F(PolyhedronFiles, AnStlFileNeedsAUnitAndNothingElseHasOne) {
  put("body.stl", text_stl(splinter, convex_polyhedron(splinter).faces));
  put("body.csv", "x_mm,y_mm,z_mm\n-1,-1,0\n1,-0.5,0\n0,1,0.25\n0.25,0,2\n");
  EXPECT_THAT(refused("vertices = \"body.stl\"\n" + heavy), HasSubstr("particle.stl_unit: found no such key"));
  EXPECT_THAT(refused("vertices = \"body.csv\"\nstl_unit = \"1 mm\"\n" + heavy),
              HasSubstr("particle.stl_unit: found this beside"));
  EXPECT_NEAR(read("vertices = \"body.stl\"\nstl_unit = \"0.5 cm\"\n" + heavy).particle.radius, 0.005, 1e-9);
}

TEST(PolyhedronToml, ItsPlanesOfSymmetryDecideWhatIsComputed) {
  const auto computed = [](const std::string& lines) { return reduce(scene_with(lines)).problem; };
  Problem p = computed(triples(brick) + heavy);
  EXPECT_EQ(computed_share(p), 0.25);
  EXPECT_FALSE(p.whole || p.block.whole_across);
  p = computed(triples(brick) + heavy + "rotation = \"free\"\n");
  EXPECT_TRUE(p.whole);
  EXPECT_FALSE(p.block.whole_across) << "it turns about y alone";
  EXPECT_TRUE(computed(triples(brick) + heavy + "orientation = \"10 deg\"\n").whole);
  EXPECT_EQ(computed_share(computed(triples(brick) + heavy + "orientation = \"90 deg\"\n")), 0.25);
  Vertices wedge = brick;  // its own mirror image in x = 0 alone
  wedge[2][2] = wedge[3][2] = 1;
  p = computed(triples(wedge) + heavy);
  EXPECT_FALSE(p.whole);
  EXPECT_TRUE(p.block.whole_across);
  EXPECT_EQ(computed_share(computed(triples(wedge) + heavy + "rotation = \"free\"\n")), 1);
  EXPECT_EQ(computed_share(computed(triples(splinter) + heavy)), 1);
}

TEST(PolyhedronToml, WholeAcrossIsGivenOrRefused) {
  const auto share = [](const std::string& mesh) {
    return computed_share(reduce(scene_with(triples(brick) + heavy, "[mesh]\n" + mesh)).problem);
  };
  EXPECT_EQ(share("whole_across = true\n"), 0.5);
  EXPECT_EQ(share("whole_across = true\nwhole = true\n"), 1);
  EXPECT_THAT(body_refusal(triples(splinter) + heavy, "[mesh]\nwhole_across = false\n"),
              HasSubstr("mesh.whole_across: found false for a particle that is not its own mirror image in y = 0"));
  EXPECT_THAT(body_refusal(triples(splinter) + heavy, "[mesh]\nwhole = false\n"), HasSubstr("mesh.whole: found false"));
  const std::string ball =
      "[particle]\nradius = \"1 mm\"\ndensity = \"7 t/m3\"\nspeed = \"50 m/s\"\n" + test::block_target;
  EXPECT_THAT(test::refusal("geometry = \"block\"\n" + ball + "[mesh]\nwhole_across = true\n"),
              HasSubstr("mesh.whole_across: found true of a sphere or a prism"));
  EXPECT_THAT(test::refusal(ball + "[mesh]\nwhole_across = true\n"),
              HasSubstr("mesh.whole_across: found this in a scene of two dimensions"));
}

TEST(PolyhedronToml, ItsMeshHasSixCubesOnTheSmallerHalfAndHoldsItsReach) {
  const Scene held = scene_with(triples(brick) + heavy);
  EXPECT_DOUBLE_EQ(held.particle.radius, 2e-3);
  EXPECT_DOUBLE_EQ(held.mesh.elements_per_radius, 12);  // half of 2 mm across
  EXPECT_NEAR(held.mesh.fine_width, 1.15, 1e-12);
  EXPECT_NEAR(held.mesh.fine_thickness, 0.65, 1e-12);
  const Scene free = scene_with(triples(splinter) + heavy + "rotation = \"free\"\n");
  EXPECT_NEAR(free.mesh.fine_width, free.mesh.fine_thickness, 1e-12);
  EXPECT_GT(free.mesh.fine_width, 1.3);
}

TEST(PolyhedronToml, MassAndVolumeMakeTheDensity) {
  const Scene scene = scene_with(triples(brick) + "mass = \"0.168 g\"\n");  // 24 mm3
  EXPECT_NEAR(particle_density(scene), 7000, 1e-8);
  Reduction reduction;
  EXPECT_NEAR(reduced_in(scene, reduction).mass, 7 * 3, 1e-9);  // 3 cubes of the radius
  EXPECT_THAT(body_refusal(triples(brick) + heavy + "mass = \"1 g\"\n"),
              HasSubstr("particle.mass: found this beside density"));
}

TEST(PolyhedronToml, ASceneIsWrittenAsItIsReadAndItsProblemIsReadFromItsKey) {
  for (const std::string& lines :
       {triples(splinter) + heavy + "rotation = \"free\"\norientation = \"20 deg\"\nangle = \"10 deg\"\n",
        triples(brick) + "mass = \"1 g\"\n"}) {
    const Scene scene = scene_with(lines);
    EXPECT_EQ(parse_scene(scene_to_toml(scene, ""), scene.source), scene) << scene_to_toml(scene, "");
    const Problem p = reduce(scene).problem;
    EXPECT_EQ(problem_of_key(evaluation_key(p, "x"), "x"), p);
  }
}

TEST(PolyhedronToml, TheOrderOfCornersIsNoOther) {
  Vertices backwards(splinter.rbegin(), splinter.rend());
  EXPECT_EQ(reduce(scene_with(triples(backwards) + heavy)).problem,
            reduce(scene_with(triples(splinter) + heavy)).problem);
}

TEST(PolyhedronToml, WhatItCannotHaveIsRefusedByName) {
  EXPECT_THAT(body_refusal(triples(brick) + heavy, "", "axisymmetric"),
              HasSubstr("particle.shape: found \"polyhedron\" in a scene of two dimensions"));
  for (const char* key : {"radius = \"1 mm\"", "side = \"1 mm\"", "tip_angle = \"60 deg\"", "thickness = \"1 mm\""})
    EXPECT_THAT(body_refusal(triples(brick) + heavy + key + "\n"),
                HasSubstr("found this beside shape = \"polyhedron\""))
        << key;
  EXPECT_THAT(body_refusal(heavy), HasSubstr("particle.vertices: found no such key"));
  EXPECT_THAT(body_refusal("vertices = [[\"0 mm\", \"0 mm\"]]\n" + heavy), HasSubstr("an array of triples"));
  Vertices dented = brick;
  dented.push_back({0, 0, 1});
  EXPECT_THAT(body_refusal(triples(dented) + heavy),
              HasSubstr("scene.toml:5: particle.vertices[9]: found a point inside"));
  EXPECT_THAT(body_refusal(triples(brick) + heavy + "angle = \"10 deg\"\n"), HasSubstr("found this beside rotation"));
  EXPECT_THAT(body_refusal(triples(brick) + heavy + "youngs_modulus = \"1 GPa\"\nelasticity = \"elastic\"\n"),
              HasSubstr("\"elastic\" for a polyhedron"));
  EXPECT_THAT(test::refusal("geometry = \"block\"\n[particle]\nradius = \"1 mm\"\nstl_unit = \"1 mm\"\n"),
              HasSubstr("particle.stl_unit: found this beside shape = \"sphere\""));
}

}  // namespace
}  // namespace percal
