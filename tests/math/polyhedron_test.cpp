// Hulls, masses and inertias of convex polyhedra against closed forms.
#include "percal/math/polyhedron.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace percal {
namespace {

const Vertices unit_tetrahedron{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
const Vertices octahedron{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};

Vertices cuboid(double a, double b, double c) {
  Vertices corners;
  for (const double x : {-a, a})
    for (const double y : {-b, b})
      for (const double z : {-c, c}) corners.push_back({x, y, z});
  return corners;
}

Vertices moved(const Vertices& points, const Eigen::Quaterniond& turn, const Eigen::Vector3d& by) {
  Vertices result;
  for (const auto& [x, y, z] : points) {
    const Eigen::Vector3d at = turn * Eigen::Vector3d(x, y, z) + by;
    result.push_back({at[0], at[1], at[2]});
  }
  return result;
}

const Eigen::Quaterniond aslant = Eigen::Quaterniond(0.3, -0.5, 0.7, 0.2).normalized();

TEST(Polyhedron, ACubeHasSixFacesOfFourCorners) {
  for (const Vertices& cube : {cuboid(1, 1, 1), moved(cuboid(1, 1, 1), aslant, {3, -2, 1})}) {
    const Polyhedron body = convex_polyhedron(cube);
    EXPECT_EQ(body.vertices, cube);
    ASSERT_EQ(body.faces.size(), 6u);
    for (const auto& face : body.faces) EXPECT_EQ(face.size(), 4u);
    EXPECT_NEAR(surface_area(body), 24, 1e-12);
  }
}

TEST(Polyhedron, AllOfItLiesBehindEachFace) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  Vertices points;
  for (int k = 0; k < 200; ++k) {
    const Eigen::Vector3d at = Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
    points.push_back({at[0], at[1], at[2]});
  }
  const Polyhedron body = convex_polyhedron(points);
  EXPECT_EQ(body.vertices, points);
  EXPECT_EQ(body.faces.size(), 2 * points.size() - 4) << "triangles";
  const auto planes = face_planes(body);
  for (std::size_t k = 0; k < planes.size(); ++k) {
    const auto& n = planes[k].normal;
    int on = 0;
    for (const auto& v : points) {
      const double beyond = n[0] * v[0] + n[1] * v[1] + n[2] * v[2] - planes[k].offset;
      EXPECT_LE(beyond, 1e-12);
      on += beyond > -1e-9 ? 1 : 0;
    }
    EXPECT_EQ(on, 3);
  }
  EXPECT_NEAR(mass_properties(body).volume, 4 * std::numbers::pi / 3, 0.25) << "nearly a sphere";
}

// Moments of inertia of a = b = c = 1: 1/80 about each axis through the centre, products 1/480.
TEST(Polyhedron, ATetrahedronHasTheMassPropertiesOfTheBooks) {
  const MassProperties found = mass_properties(convex_polyhedron(unit_tetrahedron));
  EXPECT_NEAR(found.volume, 1.0 / 6, 1e-15);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(found.centre[i], 0.25, 1e-15);
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(found.inertia[i][j], i == j ? 1.0 / 80 : 1.0 / 480, 1e-15);
  }
}

TEST(Polyhedron, ACuboidAndAnOctahedronHaveTheMassPropertiesOfTheBooks) {
  const double a = 1, b = 2, c = 0.5, mass = 8 * a * b * c;
  const MassProperties box = mass_properties(convex_polyhedron(cuboid(a, b, c)));
  EXPECT_NEAR(box.volume, mass, 1e-13);
  EXPECT_NEAR(box.inertia[0][0], mass * (b * b + c * c) / 3, 1e-13);
  EXPECT_NEAR(box.inertia[1][1], mass * (a * a + c * c) / 3, 1e-13);
  EXPECT_NEAR(box.inertia[2][2], mass * (a * a + b * b) / 3, 1e-13);
  const MassProperties eight = mass_properties(convex_polyhedron(octahedron));  // edge sqrt(2): m edge^2/10
  EXPECT_NEAR(eight.volume, 4.0 / 3, 1e-14);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(eight.inertia[i][j], i == j ? 4.0 / 3 * 0.2 : 0, 1e-14);
}

TEST(Polyhedron, InertiaTurnsWithTheBody) {
  const auto matrix = [](const MassProperties& found) {
    Eigen::Matrix3d inertia;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) inertia(i, j) = found.inertia[i][j];
    return inertia;
  };
  const MassProperties still = mass_properties(convex_polyhedron(unit_tetrahedron)),
                       turned = mass_properties(convex_polyhedron(moved(unit_tetrahedron, aslant, {10, 5, -7})));
  const Eigen::Matrix3d R = aslant.matrix();
  EXPECT_LT((matrix(turned) - R * matrix(still) * R.transpose()).norm(), 1e-13);
  EXPECT_NEAR(turned.volume, still.volume, 1e-13);
}

TEST(Polyhedron, PointsOnFacesAndEdgesAreNoCornersAndRepeatedOnesAreOne) {
  Vertices points = cuboid(1, 1, 1);
  const Vertices corners = points;
  points.insert(points.begin() + 3, {{0, 0, 1}, {1, 1, 0.3}, {-1, -1, -1}, {1, 0.2, -0.4}});
  EXPECT_EQ(convex_polyhedron(points).vertices, corners);
}

TEST(Polyhedron, WhatIsNoneIsRefused) {
  const auto found = [](const Vertices& points) -> std::pair<std::string, std::optional<std::size_t>> {
    try {
      convex_polyhedron(points);
    } catch (const NotAPolyhedron& error) {
      return {error.what(), error.point};
    }
    return {"accepted", std::nullopt};
  };
  Vertices dented = cuboid(1, 1, 1);
  dented.insert(dented.begin() + 2, {0, 0, 0.5});
  EXPECT_EQ(found(dented).first, "a point inside the convex hull of the others");
  EXPECT_EQ(found(dented).second, 2u);
  EXPECT_EQ(found({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}).first, "points in one plane");
  EXPECT_EQ(found(moved({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, aslant, {1, 2, 3})).first, "points in one plane");
  EXPECT_EQ(found({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}).first, "points on one line");
  EXPECT_EQ(found({{0, 0, 0}, {1, 0, 0}, {2, 3, 0}, {0, 0, 0}}).first, "fewer than four different points");
  EXPECT_EQ(found({{0, 0, 0}, {1, 0, 0}, {0, NAN, 0}, {0, 0, 1}}).second, 2u);
  Vertices many;
  for (std::size_t k = 0; k <= most_vertices; ++k)
    many.push_back({std::cos(k), std::sin(k), 0.001 * static_cast<double>(k)});
  EXPECT_EQ(found(many).first, "more than 500 different points");
}

TEST(Polyhedron, FindsItsPlanesOfSymmetry) {
  EXPECT_NEAR(*mirror_plane(moved(cuboid(1, 2, 3), Eigen::Quaterniond::Identity(), {5, 6, 7}), 1), 6, 1e-12);
  EXPECT_FALSE(mirror_plane(unit_tetrahedron, 0));
  Vertices nearly = octahedron;
  nearly[0][0] = 1 + 1e-7, nearly[4][1] = 1e-8;
  ASSERT_TRUE(mirror_plane(nearly, 0));
  const Vertices exact = exactly_mirrored(nearly, 0);
  EXPECT_EQ(exact[0][0], -exact[1][0]);
  EXPECT_EQ(exact[2][0], 0);
}

TEST(Polyhedron, IsCutInHalvesAndThroughItsMiddle) {
  const Polyhedron body = convex_polyhedron(octahedron);
  EXPECT_NEAR(mass_properties(upper_part(body, 1)).volume, 2.0 / 3, 1e-14);
  EXPECT_NEAR(mass_properties(upper_part(upper_part(body, 0), 1)).volume, 1.0 / 3, 1e-14);
  const Vertices section =
      middle_section(convex_polyhedron(moved(cuboid(1, 1, 1), Eigen::Quaterniond::Identity(), {0, 0.4, 0})));
  ASSERT_EQ(section.size(), 4u);
  double area = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto &a = section[k], &b = section[(k + 1) % 4];
    area += 0.5 * (a[0] * b[2] - a[2] * b[0]);
    EXPECT_EQ(a[1], 0);
  }
  EXPECT_NEAR(area, 4, 1e-14) << "anticlockwise";
  EXPECT_TRUE(middle_section(convex_polyhedron(moved(octahedron, aslant, {0, 3, 0}))).empty());
  EXPECT_NEAR(shadow_area(body), 2, 1e-14);
}

}  // namespace
}  // namespace percal
