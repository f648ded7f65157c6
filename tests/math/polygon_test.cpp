#include "percal/math/polygon.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace percal {
namespace {

constexpr double pi = std::numbers::pi;
const Polygon square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};

std::string fault(const Polygon& points) {
  try {
    convex_polygon(points);
    return "none";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

TEST(ConvexPolygon, ClockwiseBecomesAnticlockwiseWithTheSameFirstPoint) {
  EXPECT_EQ(convex_polygon({{-1, -1}, {-1, 1}, {1, 1}, {1, -1}}), square);
  EXPECT_EQ(convex_polygon(square), square);
}

TEST(ConvexPolygon, RepeatedPointsAndPointsOnASideAreDropped) {
  EXPECT_EQ(convex_polygon({{-1, -1}, {0, -1}, {1, -1}, {1, 1}, {1, 1}, {-1, 1}, {-1, -1}}), square);
}

TEST(ConvexPolygon, WhatIsNoConvexPolygonIsRefusedInWords) {
  EXPECT_EQ(fault({}), "no points");
  EXPECT_EQ(fault({{0, 0}, {1, 0}, {1, 0}}), "fewer than three different points");
  EXPECT_EQ(fault({{0, 0}, {1, 0}, {2, std::numeric_limits<double>::quiet_NaN()}}), "a point that is not finite");
  EXPECT_EQ(fault({{0, 0}, {1, 1}, {2, 2}}), "a polygon that is not convex");          // there and back
  EXPECT_EQ(fault({{0, 0}, {4, 0}, {4, 4}, {3, 1}}), "a polygon that is not convex");  // a dent
  EXPECT_EQ(fault({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), "a polygon that is not convex");  // a bow
  Polygon star;
  for (int i = 0; i < 5; ++i) star.push_back({std::cos(0.8 * pi * i), std::sin(0.8 * pi * i)});
  EXPECT_EQ(fault(star), "a polygon that crosses itself") << "every corner turns left, but twice round";
}

TEST(Polygon, TurningASquareByHalfARightAngleMakesItWiderByTheRootOfTwo) {
  EXPECT_DOUBLE_EQ(half_width(square), 1);
  EXPECT_DOUBLE_EQ(half_width(turned(square, pi / 4)), std::sqrt(2));
  EXPECT_NEAR(turned({{1, 0}}, pi / 2)[0][1], 1, 1e-15) << "anticlockwise";
}

TEST(Polygon, OnlyItsOwnMirrorImageHasAnAxis) {
  EXPECT_EQ(mirror_axis(square), 0);
  EXPECT_EQ(mirror_axis({{2, 0}, {4, 0}, {3, 5}}), 3);
  EXPECT_TRUE(mirror_axis(turned(square, pi / 4)));
  EXPECT_FALSE(mirror_axis(turned(square, 0.3)));
  EXPECT_FALSE(mirror_axis({{0, 0}, {2, 0}, {1.001, 5}}));
}

TEST(Polygon, ARightHalfIsMirroredToTheWhole) {
  const Polygon cone = mirrored_whole({{0, 0}, {1, 3}, {0, 3}});  // flat top: the middle of the base is no corner
  EXPECT_EQ(cone, (Polygon{{0, 0}, {1, 3}, {-1, 3}}));
  EXPECT_EQ(mirrored_whole({{0, 3}, {1, 3}, {0, 0}}), cone) << "either order";
  EXPECT_EQ(mirrored_whole({{0, 0}, {1, 0}, {1, 2}, {0, 2}}).size(), 4u);
  EXPECT_THROW(mirrored_whole({{0.1, 0}, {1, 0}, {1, 2}}), std::invalid_argument) << "a ring";
  EXPECT_THROW(mirrored_whole({{0, 0}, {1, -1}, {1, 1}}), std::invalid_argument) << "meets the axis in one point";
  EXPECT_THROW(mirrored_whole({{0, 0}, {1, -1}, {1, 1}, {0, 1}}), std::invalid_argument) << "hollow below";
}

// I about the centre: b h (b^2 + h^2)/12.
TEST(Prism, ARectangleHasItsAreaCentreAndPolarMoment) {
  const SolidBody body = prism({{10, 20}, {12, 20}, {12, 23}, {10, 23}});
  EXPECT_NEAR(body.measure, 6, 1e-13);
  EXPECT_NEAR(body.centre[0], 11, 1e-13);
  EXPECT_NEAR(body.centre[1], 21.5, 1e-13);
  EXPECT_NEAR(body.inertia, 6 * (4 + 9) / 12.0, 1e-12);
}

TEST(Prism, TurningChangesNeitherAreaNorPolarMoment) {
  const SolidBody upright = prism(square), tilted = prism(turned(square, 0.4));
  EXPECT_NEAR(tilted.measure, upright.measure, 1e-14);
  EXPECT_NEAR(tilted.inertia, upright.inertia, 1e-14);
}

// Half diagonals p, q: area 2 p q, polar moment p q (p^2 + q^2)/3.
TEST(Prism, ARhombusHasItsClosedForms) {
  const double p = 3, q = 3 * std::sqrt(3);
  const SolidBody body = prism({{0, -q}, {p, 0}, {0, q}, {-p, 0}});
  EXPECT_NEAR(body.measure, 2 * p * q, 1e-12);
  EXPECT_NEAR(body.inertia, p * q * (p * p + q * q) / 3, 1e-11);
}

// Volume pi R^2 H/3, centre H/4 from the base, inertia across the axis (3/80) m (4 R^2 + H^2); all per radian.
TEST(BodyOfRevolution, AConeHasItsClosedForms) {
  const double radius = 2, height = 5;
  const SolidBody body = body_of_revolution({{0, 1}, {radius, 1 + height}, {-radius, 1 + height}});
  const double volume = radius * radius * height / 6;
  EXPECT_NEAR(body.measure, volume, 1e-13);
  EXPECT_EQ(body.centre[0], 0);
  EXPECT_NEAR(body.centre[1], 1 + 0.75 * height, 1e-13);
  EXPECT_NEAR(body.inertia, 3.0 / 80 * volume * (4 * radius * radius + height * height), 1e-12);
}

// Volume pi R^2 H, inertia m (3 R^2 + H^2)/12.
TEST(BodyOfRevolution, ACylinderHasItsClosedForms) {
  const SolidBody body = body_of_revolution({{-2, 0}, {2, 0}, {2, 3}, {-2, 3}});
  EXPECT_NEAR(body.measure, 6, 1e-13);
  EXPECT_NEAR(body.centre[1], 1.5, 1e-13);
  EXPECT_NEAR(body.inertia, 6 * (3 * 4 + 9) / 12.0, 1e-12);
}

TEST(BodyOfRevolution, ManyCornersApproachASphereToSecondOrder) {
  const auto error = [](int corners) {
    Polygon circle;
    for (int i = 0; i < corners; ++i)
      circle.push_back({std::cos(2 * pi * i / corners), std::sin(2 * pi * i / corners)});
    return std::abs(body_of_revolution(circle).measure - 2.0 / 3);
  };
  EXPECT_NEAR(std::log2(error(100) / error(200)), 2, 0.01);
}

}  // namespace
}  // namespace percal
