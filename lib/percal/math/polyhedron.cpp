#include "percal/math/polyhedron.hpp"

#include <fmt/core.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace percal {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d vector_of(const std::array<double, 3>& point) { return {point[0], point[1], point[2]}; }
std::array<double, 3> array_of(const Vector3d& v) { return {v[0], v[1], v[2]}; }

double size_of(const Vertices& points) {
  double size = 0;
  for (const auto& point : points) size = std::max(size, (vector_of(point) - vector_of(points.front())).norm());
  return size;
}

// A hull by gift wrapping: a face's plane is tilted about each of its edges until it meets the next points.
class Wrapping {
 public:
  explicit Wrapping(const Vertices& points) : flat_(flatness * size_of(points)) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!vector_of(points[i]).allFinite()) throw NotAPolyhedron("a point that is not finite", i);
      const Vector3d point = vector_of(points[i]);
      const auto near = [&](const Vector3d& other) { return (point - other).norm() <= flat_; };
      if (std::ranges::any_of(at_, near)) continue;
      at_.push_back(point);
      given_.push_back(i);
      if (at_.size() > most_vertices) throw NotAPolyhedron(fmt::format("more than {} different points", most_vertices));
    }
    if (at_.size() < 4) throw NotAPolyhedron("fewer than four different points");
  }

  Polyhedron hull() {
    add_face(first_plane());
    for (std::size_t k = 0; k < faces_.size(); ++k)
      for (std::size_t e = 0; e < faces_[k].size(); ++e) {
        const int a = faces_[k][e], b = faces_[k][(e + 1) % faces_[k].size()];
        if (edges_.contains({b, a})) continue;
        add_face({at_[a], tilted(at_[a], (at_[b] - at_[a]).normalized(), normals_[k])});
        if (!edges_.contains({b, a})) refuse_as_too_near();
      }
    return corners_only();
  }

 private:
  struct Plane {
    Vector3d through, normal;
  };

  [[noreturn]] static void refuse_as_too_near() {
    throw NotAPolyhedron("points too near to each other, or to one line or plane, to tell its faces apart");
  }

  // The normal of the plane through the line (a, along) that lies at `normal` beside the body, tilted until it touches it.
  Vector3d tilted(const Vector3d& a, const Vector3d& along, const Vector3d& normal) const {
    const Vector3d inward = normal.cross(along);
    double most = -std::numeric_limits<double>::infinity();
    for (const Vector3d& point : at_) {
      const double u = inward.dot(point - a), w = normal.dot(point - a);
      if (std::hypot(u, w) > flat_) most = std::max(most, std::atan2(std::max(0.0, -w), u));
    }
    const Vector3d towards = std::cos(most) * inward - std::sin(most) * normal;
    return towards.cross(along).normalized();
  }

  // Beside the point of least x stands a plane; it is tilted twice.
  Plane first_plane() const {
    const auto before = [](const Vector3d& a, const Vector3d& b) {
      return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
    };
    const Vector3d a = *std::ranges::min_element(at_, before), along = Vector3d::UnitY();
    const Vector3d normal = tilted(a, along, -Vector3d::UnitX());
    Vector3d edge = Vector3d::Zero();
    for (const Vector3d& point : at_)
      if (std::abs(normal.dot(point - a)) <= flat_ && (point - a).norm() > edge.norm()) edge = point - a;
    if (edge.norm() <= flat_) refuse_as_too_near();
    // Seen along `edge` all points lie to one side of a plane in which it is an edge; at first the one just found.
    const Vector3d direction = edge.normalized(), plane = (normal - normal.dot(direction) * direction).normalized();
    return {a, tilted(a, direction, plane)};
  }

  // Corners in one plane, anticlockwise about its normal.
  std::vector<int> polygon_in(const Plane& plane) const {
    const Vector3d right = plane.normal.unitOrthogonal(), up = plane.normal.cross(right);
    struct Corner {
      double x, y;
      int index;
    };
    std::vector<Corner> corners;
    for (int i = 0; i < std::ssize(at_); ++i) {
      const Vector3d from = at_[i] - plane.through;
      const double beyond = plane.normal.dot(from);
      if (beyond > flat_) refuse_as_too_near();
      if (beyond >= -flat_) corners.push_back({right.dot(from), up.dot(from), i});
    }
    std::ranges::sort(corners,
                      [](const Corner& a, const Corner& b) { return std::pair(a.x, a.y) < std::pair(b.x, b.y); });
    // b between a and c is a corner where it lies to the right of the line from a to c.
    const auto is_none = [this](const Corner& a, const Corner& b, const Corner& c) {
      const double cross = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
      return cross <= flat_ * std::hypot(c.x - a.x, c.y - a.y);
    };
    std::vector<int> polygon;
    const auto add_chain = [&](auto begin, auto end) {
      std::vector<Corner> chain;
      for (auto next = begin; next != end; ++next) {
        while (chain.size() >= 2 && is_none(chain[chain.size() - 2], chain.back(), *next)) chain.pop_back();
        chain.push_back(*next);
      }
      for (std::size_t k = 0; k + 1 < chain.size(); ++k) polygon.push_back(chain[k].index);
    };
    add_chain(corners.begin(), corners.end());
    add_chain(corners.rbegin(), corners.rend());
    return polygon;
  }

  void add_face(const Plane& plane) {
    const std::vector<int> polygon = polygon_in(plane);
    if (polygon.size() < 3) throw NotAPolyhedron("points on one line");
    if (faces_.size() == 1 && std::ranges::is_permutation(polygon, faces_.front()))
      throw NotAPolyhedron("points in one plane");
    for (std::size_t e = 0; e < polygon.size(); ++e)
      if (!edges_.emplace(std::pair(polygon[e], polygon[(e + 1) % polygon.size()]), faces_.size()).second)
        refuse_as_too_near();
    faces_.push_back(polygon);
    normals_.push_back(plane.normal);
  }

  // Whoever is in no face is a point on one, or lies inside.
  Polyhedron corners_only() const {
    std::vector<int> place(at_.size(), -1);
    Polyhedron body;
    for (const auto& face : faces_)
      for (const int corner : face) place[corner] = 0;
    for (std::size_t i = 0; i < at_.size(); ++i) {
      if (place[i] == 0) {
        place[i] = static_cast<int>(body.vertices.size());
        body.vertices.push_back(array_of(at_[i]));
        continue;
      }
      double depth = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k < faces_.size(); ++k)
        depth = std::min(depth, normals_[k].dot(at_[faces_[k].front()] - at_[i]));
      if (depth > flat_) throw NotAPolyhedron("a point inside the convex hull of the others", given_[i]);
    }
    for (auto face : faces_) {
      for (int& corner : face) corner = place[corner];
      body.faces.push_back(std::move(face));
    }
    if (2 * (body.vertices.size() + body.faces.size() - 2) != edges_.size()) refuse_as_too_near();  // Euler
    return body;
  }

  const double flat_;
  std::vector<Vector3d> at_;        // different points
  std::vector<std::size_t> given_;  // which they were
  std::vector<std::vector<int>> faces_;
  std::vector<Vector3d> normals_;
  std::map<std::pair<int, int>, std::size_t> edges_;  // from corner to corner, with their faces
};

// Calls of(a, b, c) with triangles that make up the surface, anticlockwise seen from outside.
template <class Of>
void each_triangle(const Polyhedron& body, const Of& of) {
  for (const auto& face : body.faces)
    for (std::size_t k = 1; k + 1 < face.size(); ++k)
      of(vector_of(body.vertices[face[0]]), vector_of(body.vertices[face[k]]), vector_of(body.vertices[face[k + 1]]));
}

// Calls with(a, b) for the ends of each edge, once.
template <class With>
void each_edge(const Polyhedron& body, const With& with) {
  for (const auto& face : body.faces)
    for (std::size_t k = 0; k < face.size(); ++k)
      if (const int a = face[k], b = face[(k + 1) % face.size()]; a < b) with(body.vertices[a], body.vertices[b]);
}

std::array<double, 3> crossing(const std::array<double, 3>& a, const std::array<double, 3>& b, int axis) {
  const double share = a[axis] / (a[axis] - b[axis]);
  std::array<double, 3> point{};
  for (int d = 0; d < 3; ++d) point[d] = d == axis ? 0 : a[d] + (b[d] - a[d]) * share;
  return point;
}

std::array<double, 3> image_of(std::array<double, 3> point, int axis, double plane) {
  point[axis] = 2 * plane - point[axis];
  return point;
}

// Index of the point that is nearest to another.
std::size_t nearest_to(const std::array<double, 3>& place, const Vertices& points) {
  const auto distance = [&](const auto& point) { return (vector_of(point) - vector_of(place)).squaredNorm(); };
  return std::ranges::min_element(points, {}, distance) - points.begin();
}

}  // namespace

Polyhedron convex_polyhedron(const Vertices& points) {
  if (points.empty()) throw NotAPolyhedron("no points");
  return Wrapping(points).hull();
}

std::vector<FacePlane> face_planes(const Polyhedron& body) {
  std::vector<FacePlane> planes;
  for (const auto& face : body.faces) {
    Vector3d area = Vector3d::Zero();
    const Vector3d first = vector_of(body.vertices[face[0]]);
    for (std::size_t k = 1; k + 1 < face.size(); ++k)
      area += (vector_of(body.vertices[face[k]]) - first).cross(vector_of(body.vertices[face[k + 1]]) - first);
    const Vector3d normal = area.normalized();
    double offset = -std::numeric_limits<double>::infinity();
    for (const auto& vertex : body.vertices) offset = std::max(offset, normal.dot(vector_of(vertex)));
    planes.push_back({array_of(normal), offset});
  }
  return planes;
}

double surface_area(const Polyhedron& body) {
  double area = 0;
  each_triangle(body, [&](const auto& a, const auto& b, const auto& c) { area += 0.5 * (b - a).cross(c - a).norm(); });
  return area;
}

double shadow_area(const Polyhedron& body) {
  double area = 0;
  each_triangle(body, [&](const auto& a, const auto& b, const auto& c) {
    area += 0.25 * std::abs((b - a).cross(c - a)[2]);  // the body has two sides
  });
  return area;
}

bool lie_in_a_face(const Polyhedron& body, const std::array<std::array<double, 3>, 3>& points) {
  const double near = 2 * flatness * size_of(body.vertices);
  return std::ranges::any_of(face_planes(body), [&](const FacePlane& plane) {
    return std::ranges::all_of(points, [&](const auto& point) {
      return std::abs(vector_of(plane.normal).dot(vector_of(point)) - plane.offset) <= near;
    });
  });
}

// Tetrahedra of the first vertex and the triangles of the surface: V/4 (sum of vertices), V/20 (sum of v v^T + s s^T), s their sum.
MassProperties mass_properties(const Polyhedron& body) {
  const Vector3d origin = vector_of(body.vertices.front());
  double volume = 0;
  Vector3d first = Vector3d::Zero();
  Matrix3d second = Matrix3d::Zero();
  each_triangle(body, [&](const Vector3d& p, const Vector3d& q, const Vector3d& r) {
    const Vector3d a = p - origin, b = q - origin, c = r - origin, sum = a + b + c;
    const double part = a.dot(b.cross(c)) / 6;
    volume += part;
    first += part / 4 * sum;
    second += part / 20 * (a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose());
  });
  const Vector3d centre = first / volume;
  second -= volume * centre * centre.transpose();
  const Matrix3d inertia = second.trace() * Matrix3d::Identity() - second;
  MassProperties found{.volume = volume, .centre = array_of(origin + centre)};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) found.inertia[i][j] = inertia(i, j);
  return found;
}

Vertices turned_about_y(const Vertices& points, double angle) {
  if (angle == 0) return points;
  const double c = std::cos(angle), s = std::sin(angle);
  Vertices turned;
  for (const auto& [x, y, z] : points) turned.push_back({c * x - s * z, y, s * x + c * z});
  return turned;
}

std::array<double, 2> extent(const Vertices& points, int axis) {
  const auto [low, high] = std::ranges::minmax_element(points, {}, [axis](const auto& point) { return point[axis]; });
  return {(*low)[axis], (*high)[axis]};
}

double greatest_distance(const Vertices& points) {
  double distance = 0;
  for (const auto& point : points) distance = std::max(distance, vector_of(point).norm());
  return distance;
}

std::optional<double> mirror_plane(const Vertices& points, int axis) {
  const auto [low, high] = extent(points, axis);
  const double plane = low + (high - low) / 2, near = flatness * (high - low) / 2;
  const bool mirrored = std::ranges::all_of(points, [&](const auto& point) {
    const auto image = image_of(point, axis, plane);
    return (vector_of(points[nearest_to(image, points)]) - vector_of(image)).norm() <= near;
  });
  return mirrored ? std::optional(plane) : std::nullopt;
}

Vertices exactly_mirrored(const Vertices& points, int axis) {
  const auto [low, high] = extent(points, axis);
  const double plane = low + (high - low) / 2;
  Vertices exact = points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t j = nearest_to(image_of(points[i], axis, plane), points);
    for (int d = 0; d < 3; ++d)
      exact[i][d] = d == axis ? 0.5 * (points[i][d] - points[j][d]) : 0.5 * (points[i][d] + points[j][d]);
  }
  return exact;
}

Polyhedron upper_part(const Polyhedron& body, int axis) {
  Vertices points;
  for (const auto& vertex : body.vertices)
    if (vertex[axis] >= 0) points.push_back(vertex);
  each_edge(body, [&](const auto& a, const auto& b) {
    if (a[axis] * b[axis] < 0) points.push_back(crossing(a, b, axis));
  });
  return convex_polyhedron(points);
}

Vertices middle_section(const Polyhedron& body) {
  Vertices corners;
  for (const auto& vertex : body.vertices)
    if (vertex[1] == 0) corners.push_back(vertex);
  each_edge(body, [&](const auto& a, const auto& b) {
    if (a[1] * b[1] < 0) corners.push_back(crossing(a, b, 1));
  });
  if (corners.size() < 3) return {};
  double x = 0, z = 0;
  for (const auto& corner : corners) {
    x += corner[0] / static_cast<double>(corners.size());
    z += corner[2] / static_cast<double>(corners.size());
  }
  std::ranges::sort(corners, {}, [&](const auto& corner) { return std::atan2(corner[2] - z, corner[0] - x); });
  return corners;
}

}  // namespace percal
