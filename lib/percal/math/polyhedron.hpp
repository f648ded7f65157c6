// Convex polyhedra, and the bodies they stand for. Vertices are (x, y, z); lengths in any unit.
#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace percal {

using Vertices = std::vector<std::array<double, 3>>;

struct Polyhedron {
  Vertices vertices;
  std::vector<std::vector<int>> faces;  // polygons of vertices, anticlockwise seen from outside
};

// What convex_polyhedron() cannot make a body of.
class NotAPolyhedron : public std::invalid_argument {
 public:
  explicit NotAPolyhedron(const std::string& found, std::optional<std::size_t> which = std::nullopt)
      : std::invalid_argument(found), point(which) {}
  std::optional<std::size_t> point;  // that is at fault, where it is one
};

// Share of a body's size within which points are one, lie on one line or in one plane: what is left of a body in files of six digits.
inline constexpr double flatness = 1e-6;
inline constexpr std::size_t most_vertices = 500;

// The convex hull of points that all lie on it, with faces that are whole: vertices in the order of the points, without repeated ones and
// those that are no corner. Throws NotAPolyhedron, whose message says what was found: a point inside, points in one plane, too many.
Polyhedron convex_polyhedron(const Vertices& points);

// A plane in which a face lies: normal . x = offset, and nothing of the body is beyond.
struct FacePlane {
  std::array<double, 3> normal;  // outward, of length 1
  double offset;
};
std::vector<FacePlane> face_planes(const Polyhedron&);

double surface_area(const Polyhedron&);
// Of its shadow along z.
double shadow_area(const Polyhedron&);
// Whether all these points lie in the plane of one face.
bool lie_in_a_face(const Polyhedron&, const std::array<std::array<double, 3>, 3>& points);

// Of density 1; exact.     docs/theory/solid.md (14)
struct MassProperties {
  double volume = 0;
  std::array<double, 3> centre{};                  // of mass
  std::array<std::array<double, 3>, 3> inertia{};  // about the centre
};
MassProperties mass_properties(const Polyhedron&);

// Turned about the y axis, anticlockwise where x points to the right, z upwards and y away.
Vertices turned_about_y(const Vertices& points, double angle);

// Least and greatest coordinate along an axis.
std::array<double, 2> extent(const Vertices& points, int axis);
// The greatest distance from the origin.
double greatest_distance(const Vertices& points);

// The coordinate of the plane across an axis in which the points are their own mirror image, to `flatness` of their extent along it.
std::optional<double> mirror_plane(const Vertices& points, int axis);
// The same points, mirror images of each other in the planes across an axis to the last bit; the plane at 0.
Vertices exactly_mirrored(const Vertices& points, int axis);

// What of a body has this coordinate at or above 0; it must have something there.
Polyhedron upper_part(const Polyhedron&, int axis);
// The polygon that the plane y = 0 cuts out of it, anticlockwise as turned_about_y() sees it; empty where it cuts nothing.
Vertices middle_section(const Polyhedron&);

}  // namespace percal
