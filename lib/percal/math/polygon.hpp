// Convex polygons in the plane, and the bodies they stand for: a prism of unit thickness, or the body that the right half makes
// when it turns about x = 0. Points are (x, y), y upwards; lengths in any unit.
#pragma once
#include <array>
#include <optional>
#include <vector>

namespace percal {

using Polygon = std::vector<std::array<double, 2>>;

// The same polygon anticlockwise, without repeated points and points on a straight line between their neighbours (to 1e-9).
// Throws std::invalid_argument, whose message says what was found, where fewer than three corners are left, a number is not
// finite, or the rest is not a convex polygon that goes round once.
Polygon convex_polygon(const Polygon& points);

// Turned anticlockwise about the origin by an angle in rad.
Polygon turned(const Polygon& polygon, double angle);

// Smallest and largest x.
std::array<double, 2> span(const Polygon& polygon);
double half_width(const Polygon& polygon);

// The x of the vertical line in which a convex polygon is its own mirror image, to `tolerance` of its half width.
inline constexpr double mirror_tolerance = 1e-9;
std::optional<double> mirror_axis(const Polygon& polygon, double tolerance = mirror_tolerance);

// The right half of a body of revolution, x >= 0, completed by its mirror image in x = 0. Throws std::invalid_argument where
// it has no side on x = 0, or the whole is not convex.
Polygon mirrored_whole(const Polygon& right_half);

// Integrals over a solid of density 1 and unit thickness (prism), or per radian (body of revolution).
struct SolidBody {
  double measure = 0;              // area; volume per radian
  std::array<double, 2> centre{};  // of mass; on the axis for a body of revolution
  double inertia =
      0;  // about an axis through the centre: normal to the plane (prism), or across the axis of revolution
};

// Of a convex anticlockwise polygon.
SolidBody prism(const Polygon& polygon);
// Only the part at x >= 0 is used.
SolidBody body_of_revolution(const Polygon& polygon);

}  // namespace percal
