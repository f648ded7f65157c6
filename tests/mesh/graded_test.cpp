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
    for (const double n : {3.0, 7.0, 10.0, 42.0}) {
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

TEST(GradedMesh, ElementsNeedNotFitIntoTheRadius) {
  const GradedMesh mesh = graded_mesh({.elements_per_radius = 9.66, .graded_columns = 12});
  EXPECT_EQ(mesh.columns(), 10 + 12) << "fine columns up to the first node at or beyond one radius";
  for (int i = 0; i < 10; ++i) EXPECT_NEAR(width_of(mesh, i), 1 / 9.66, 1e-14) << i;
  EXPECT_EQ(mesh.radius.back(), 5);
  EXPECT_EQ(mesh.rows, 725) << "75 * 9.66 = 724.5";
  const GradedMesh whole = mirrored(mesh);
  ASSERT_EQ(whole.columns(), 2 * mesh.columns());
  for (int i = 0; i <= mesh.columns(); ++i) {
    EXPECT_EQ(whole.radius[mesh.columns() + i], mesh.radius[i]) << i;
    EXPECT_EQ(whole.radius[mesh.columns() - i], -mesh.radius[i]) << i;
  }
}

// The study's counts: 12 graded columns to 5 radii, 17 to 12, at 10 per radius.
TEST(GradedMesh, TheUsualColumnsGrowByUpToAFifth) {
  EXPECT_EQ(graded_columns_for(usual_growth, {.elements_per_radius = 10, .width = 5}), 12);
  EXPECT_EQ(graded_columns_for(usual_growth, {.elements_per_radius = 10, .width = 12}), 17);
  for (const double n : {3.0, 7.0, 9.66, 10.34, 28.0})
    for (const double width : {1.9, 5.0, 12.0, 20.0, 300.0}) {
      GradedMeshOptions options{.elements_per_radius = n, .width = width};
      options.graded_columns = graded_columns_for(usual_growth, options);
      const GradedMesh mesh = graded_mesh(options);
      EXPECT_LE(mesh.growth, usual_growth + 1e-9) << n << ' ' << width;
      for (int i = 1; i < mesh.columns(); ++i)
        EXPECT_LE(width_of(mesh, i), (usual_growth + 1e-9) * width_of(mesh, i - 1)) << n << ' ' << width << ' ' << i;
      if (options.graded_columns < 2) continue;
      --options.graded_columns;
      EXPECT_GT(graded_mesh(options).growth, usual_growth) << "fewer would do: " << n << ' ' << width;
    }
}

TEST(GradedMesh, WhereHardlyAColumnIsLeftToTheWallAllAreEven) {
  GradedMeshOptions options{.elements_per_radius = 10.3, .width = 1.15};
  options.graded_columns = graded_columns_for(usual_growth, options);
  EXPECT_EQ(options.graded_columns, 0);
  const GradedMesh mesh = graded_mesh(options);
  EXPECT_EQ(mesh.columns(), 12);
  for (int i = 0; i < 12; ++i) EXPECT_NEAR(width_of(mesh, i), 1.15 / 12, 1e-14);
}

TEST(GradedMesh, IsCountedBeforeItIsMade) {
  for (const double n : {1.0, 7.0, 9.66})
    for (const double fine : {0.5, 1.0, 4.0, 9.0})
      for (const int graded : {0, 1, 12}) {
        const GradedMeshOptions options{
            .elements_per_radius = n, .fine_width = fine, .graded_columns = graded, .depth = 7.3};
        const GradedCounts counts = counts_of(options);
        const GradedMesh mesh = graded_mesh(options);
        EXPECT_EQ(counts.columns(), mesh.columns()) << n << ' ' << fine << ' ' << graded;
        EXPECT_EQ(counts.rows, mesh.rows);
        EXPECT_NEAR(counts.fine_column_width, mesh.radius[1], 1e-15);
      }
  const GradedCounts huge = counts_of({.depth = 1e9});
  EXPECT_EQ(huge.rows, 1e10) << "counted without overflow";
}

}  // namespace
}  // namespace percal
