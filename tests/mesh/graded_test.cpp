#include "percal/mesh/graded.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace percal {
namespace {

double width_of(const GradedMesh& mesh, int column) { return mesh.radius[column + 1] - mesh.radius[column]; }

TEST(GradedMesh, FineElementsAreSquare) {
  const GradedMesh mesh = graded_mesh({.elements_per_radius = 14, .graded_columns = 7});
  EXPECT_EQ(mesh.radius.front(), 0);
  for (int i = 0; i < 14; ++i) EXPECT_NEAR(width_of(mesh, i), mesh.row_height, 1e-14) << i;
  EXPECT_DOUBLE_EQ(mesh.row_height, 1.0 / 14);
}

TEST(GradedMesh, ColumnsGrowByOneFactorFromTheLastFineOneToTheWall) {
  for (const int graded : {1, 2, 5, 23, 40}) {
    const GradedMesh mesh = graded_mesh({.elements_per_radius = 10, .graded_columns = graded});
    ASSERT_EQ(mesh.columns(), 10 + graded);
    const double factor = width_of(mesh, 10) / width_of(mesh, 9);
    for (int i = 10; i < mesh.columns(); ++i)
      EXPECT_NEAR(width_of(mesh, i) / width_of(mesh, i - 1), factor, 1e-11)
          << graded << " graded columns, column " << i;
  }
}

// 100 columns over four radii are narrower than the fine ones: they shrink by one factor instead.
TEST(GradedMesh, ManyGradedColumnsShrinkTowardsTheWall) {
  const GradedMesh mesh = graded_mesh({.elements_per_radius = 10, .graded_columns = 100});
  EXPECT_LT(width_of(mesh, 109), width_of(mesh, 10));
  for (int i = 0; i < mesh.columns(); ++i) EXPECT_GT(width_of(mesh, i), 0) << i;
}

TEST(GradedMesh, TheWallIsHitExactly) {
  for (const double width : {5.0, 1.7, 3.14159, 20.0})
    for (const int n : {3, 7, 10, 42}) {
      const GradedMesh mesh = graded_mesh({.elements_per_radius = n, .width = width, .depth = 10});
      EXPECT_EQ(mesh.radius.back(), width);
    }
}

TEST(GradedMesh, RowsFillTheDepth) {
  for (const double depth : {75.0, 10.04, 0.3}) {
    const GradedMesh mesh = graded_mesh({.elements_per_radius = 7, .depth = depth});
    EXPECT_NEAR(mesh.rows * mesh.row_height, depth, 1e-13 * depth);
    EXPECT_NEAR(mesh.row_height, 1.0 / 7, 0.5 / 7 / mesh.rows) << "rounded to the nearest whole number of rows";
  }
}

TEST(GradedMesh, TheThesissMeshHas204750Elements) {
  const GradedMesh mesh = graded_mesh({.elements_per_radius = 42, .graded_columns = 23});
  EXPECT_EQ(mesh.rows, 3150);
  EXPECT_EQ(mesh.columns(), 65);
  EXPECT_EQ(mesh.elements(), 204750);
}

TEST(GradedMesh, FineColumnsThatReachTheWallLeaveNoneToGrade) {
  const GradedMesh mesh = graded_mesh({.elements_per_radius = 6, .fine_width = 5, .graded_columns = 9});
  EXPECT_EQ(mesh.columns(), 30);
  EXPECT_EQ(mesh.radius.back(), 5);
  for (int i = 0; i < 30; ++i) EXPECT_NEAR(width_of(mesh, i), 1.0 / 6, 1e-14);
}

TEST(GradedMesh, AFineZoneWiderThanTheBlockIsCutAtTheWall) {
  const GradedMesh mesh = graded_mesh({.elements_per_radius = 6, .fine_width = 8, .width = 2});
  EXPECT_EQ(mesh.radius.back(), 2);
  EXPECT_EQ(mesh.columns(), 12);
}

}  // namespace
}  // namespace percal
