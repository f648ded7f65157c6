#include "percal/math/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace percal {
namespace {

constexpr double straight =
    1e-9;  // sine of the turn below which a corner is none; share of the size below which points are one

using Point = Polygon::value_type;

Point from_to(const Point& a, const Point& b) { return {b[0] - a[0], b[1] - a[1]}; }
double cross(const Point& a, const Point& b) { return a[0] * b[1] - a[1] * b[0]; }
double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1]; }
double length(const Point& a) { return std::hypot(a[0], a[1]); }

// Of corner i, which of its neighbours.
const Point& before(const Polygon& polygon, std::size_t i) {
  return polygon[(i + polygon.size() - 1) % polygon.size()];
}
const Point& after(const Polygon& polygon, std::size_t i) { return polygon[(i + 1) % polygon.size()]; }

double size_of(const Polygon& polygon) {
  double size = 0;
  for (const Point& point : polygon) size = std::max(size, length(from_to(polygon.front(), point)));
  return size;
}

Polygon without_repeated_points(const Polygon& polygon) {
  const double near = straight * size_of(polygon);
  Polygon kept;
  for (const Point& point : polygon)
    if (kept.empty() || length(from_to(kept.back(), point)) > near) kept.push_back(point);
  while (kept.size() > 1 && length(from_to(kept.back(), kept.front())) <= near) kept.pop_back();
  return kept;
}

// Angle by which the outline turns at corner i, anticlockwise positive, in (-pi, pi].
double turn(const Polygon& polygon, std::size_t i) {
  const Point in = from_to(before(polygon, i), polygon[i]), out = from_to(polygon[i], after(polygon, i));
  return std::atan2(cross(in, out), dot(in, out));
}

Polygon without_straight_corners(const Polygon& polygon) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    if (std::abs(turn(polygon, i)) > straight) kept.push_back(polygon[i]);
  return kept;
}

// Integral of f(x, y), exact for polynomials of third degree, over a convex polygon: the rule of four points on the triangles
// of its first corner.
template <class Function>
double integral(const Polygon& polygon, Function&& f) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const Point &a = polygon[0], &b = polygon[i], &c = polygon[i + 1];
    const double area = cross(from_to(a, b), from_to(a, c)) / 2;
    const auto at = [&](double u, double v, double w) {
      return f(u * a[0] + v * b[0] + w * c[0], u * a[1] + v * b[1] + w * c[1]);
    };
    constexpr double third = 1.0 / 3;
    sum += area * (25.0 / 48 * (at(0.6, 0.2, 0.2) + at(0.2, 0.6, 0.2) + at(0.2, 0.2, 0.6)) -
                   27.0 / 48 * at(third, third, third));
  }
  return sum;
}

Polygon right_half(const Polygon& polygon) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &a = polygon[i], &b = after(polygon, i);
    if (a[0] >= 0) kept.push_back(a);
    if ((a[0] < 0) != (b[0] < 0)) kept.push_back({0, a[1] + (b[1] - a[1]) * (a[0] / (a[0] - b[0]))});
  }
  return kept;
}

}  // namespace

Polygon convex_polygon(const Polygon& points) {
  for (const Point& point : points)
    if (!std::isfinite(point[0]) || !std::isfinite(point[1])) throw std::invalid_argument("a point that is not finite");
  if (points.empty()) throw std::invalid_argument("no points");
  Polygon polygon = without_repeated_points(points);
  if (polygon.size() < 3) throw std::invalid_argument("fewer than three different points");
  double whole_turn = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) whole_turn += turn(polygon, i);
  if (whole_turn < 0) {
    std::reverse(polygon.begin() + 1, polygon.end());  // the first point stays the first
    whole_turn = -whole_turn;
  }
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const double angle = turn(polygon, i);
    if (!(angle > -straight && angle < std::numbers::pi - straight))
      throw std::invalid_argument("a polygon that is not convex");
  }
  if (!(std::abs(whole_turn - 2 * std::numbers::pi) < 1e-6))
    throw std::invalid_argument("a polygon that crosses itself");
  polygon = without_straight_corners(polygon);
  if (polygon.size() < 3) throw std::invalid_argument("points on one line");
  return polygon;
}

Polygon turned(const Polygon& polygon, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  Polygon result;
  for (const auto& [x, y] : polygon) result.push_back({c * x - s * y, s * x + c * y});
  return result;
}

std::array<double, 2> span(const Polygon& polygon) {
  const auto by_x = [](const Point& a, const Point& b) { return a[0] < b[0]; };
  const auto [low, high] = std::minmax_element(polygon.begin(), polygon.end(), by_x);
  return {(*low)[0], (*high)[0]};
}

double half_width(const Polygon& polygon) {
  const auto [low, high] = span(polygon);
  return (high - low) / 2;
}

std::optional<double> mirror_axis(const Polygon& polygon, double tolerance) {
  const auto [low, high] = span(polygon);
  const double axis = low + (high - low) / 2, near = tolerance * (high - low) / 2;
  const bool symmetric = std::all_of(polygon.begin(), polygon.end(), [&](const Point& point) {
    const Point image{2 * axis - point[0], point[1]};
    return std::any_of(polygon.begin(), polygon.end(),
                       [&](const Point& other) { return length(from_to(image, other)) <= near; });
  });
  return symmetric ? std::optional(axis) : std::nullopt;
}

Polygon mirrored_whole(const Polygon& half) {
  Polygon polygon = convex_polygon(half);
  const double near = straight * size_of(polygon);
  const auto on_axis = [near](const Point& point) { return std::abs(point[0]) <= near; };
  if (std::count_if(polygon.begin(), polygon.end(), on_axis) != 2)
    throw std::invalid_argument("a half that has no side on the axis x = 0");
  for (Point& point : polygon)
    if (on_axis(point)) point[0] = 0;
  // Anticlockwise the axis is passed downwards: the first corner after it is the lower one.
  while (!(on_axis(polygon.front()) && on_axis(polygon.back())))
    std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
  for (std::size_t i = polygon.size() - 2; i >= 1; --i) polygon.push_back({-polygon[i][0], polygon[i][1]});
  return convex_polygon(polygon);
}

SolidBody prism(const Polygon& polygon) {
  SolidBody body;
  body.measure = integral(polygon, [](double, double) { return 1; });
  const auto [x0, y0] = polygon.front();
  body.centre = {x0 + integral(polygon, [x0 = x0](double x, double) { return x - x0; }) / body.measure,
                 y0 + integral(polygon, [y0 = y0](double, double y) { return y - y0; }) / body.measure};
  const auto [xc, yc] = body.centre;
  body.inertia =
      integral(polygon, [xc = xc, yc = yc](double x, double y) { return (x - xc) * (x - xc) + (y - yc) * (y - yc); });
  return body;
}

SolidBody body_of_revolution(const Polygon& polygon) {
  const Polygon half = right_half(polygon);
  SolidBody body;
  body.measure = integral(half, [](double r, double) { return r; });
  const double y0 = half.front()[1];
  body.centre = {0, y0 + integral(half, [y0](double r, double y) { return r * (y - y0); }) / body.measure};
  const double yc = body.centre[1];
  body.inertia = integral(half, [yc](double r, double y) { return r * (r * r / 2 + (y - yc) * (y - yc)); });
  return body;
}

}  // namespace percal
