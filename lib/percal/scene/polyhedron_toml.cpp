#include "percal/scene/polyhedron_toml.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <map>

#include "percal/text/csv.hpp"
#include "percal/text/stl.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

const std::string accepted_corners =
    fmt::format("the corners of a convex polyhedron, 4 to {} of them, each on its hull", most_vertices);
constexpr double covered_exactly = 1e-4;  // share of the surface that triangles may miss, or cover twice

// Points with where each stands.
struct GivenPoints {
  Vertices points;
  std::vector<Place> places;
};

// Throws BadInput at the place of the point that is at fault, else at `whole`.
Polyhedron checked_hull(const GivenPoints& given, const Place& whole) {
  try {
    return convex_polyhedron(given.points);
  } catch (const NotAPolyhedron& error) {
    throw BadInput(error.point && *error.point < given.places.size() ? given.places[*error.point] : whole, error.what(),
                   accepted_corners);
  }
}

Place place_in(const std::string& file, int line) { return {.file = file, .line = line, .key = "particle.vertices"}; }

Vertices from_csv(const std::string& file) {
  const CsvTable csv = read_csv(file);
  const auto x = csv.numbers("x", dimension::length), y = csv.numbers("y", dimension::length),
             z = csv.numbers("z", dimension::length);
  GivenPoints given;
  for (std::size_t i = 0; i < x.size(); ++i) {
    given.points.push_back({x[i], y[i], z[i]});
    given.places.push_back(place_in(file, csv.rows[i].line));
  }
  return checked_hull(given, place_in(file, 0)).vertices;
}

// Triangles must be the whole surface of their hull, once.
Vertices from_stl(const std::string& file, double unit) {
  const auto triangles = read_stl(file);
  GivenPoints given;
  std::map<std::array<double, 3>, std::size_t> seen;
  for (const StlTriangle& triangle : triangles)
    for (int k = 0; k < 3; ++k) {
      if (!seen.emplace(triangle.corners[k], given.points.size()).second) continue;
      given.points.push_back(triangle.corners[k]);
      given.places.push_back(place_in(file, triangle.lines[k]));
    }
  Polyhedron body = checked_hull(given, place_in(file, 0));
  double area = 0;
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    const auto& [a, b, c] = triangles[k].corners;
    if (!lie_in_a_face(body, triangles[k].corners))
      throw BadInput(place_in(file, triangles[k].lines[0]),
                     fmt::format("triangle {} inside the convex hull of all", k + 1),
                     "the surface of a convex polyhedron");
    area += surface_area({{a, b, c}, {{0, 1, 2}}});
  }
  const double covered = area / surface_area(body);
  if (std::abs(covered - 1) > covered_exactly)
    throw BadInput(place_in(file, 0),
                   fmt::format("triangles that cover {:.4g} % of their convex hull's surface", 100 * covered),
                   "the whole surface of a convex polyhedron, once");
  for (auto& vertex : body.vertices)
    for (double& coordinate : vertex) coordinate *= unit;
  return body.vertices;
}

bool is_stl(const std::string& file) {
  std::string end = std::filesystem::path(file).extension().string();
  std::ranges::transform(end, end.begin(), [](unsigned char c) { return std::tolower(c); });
  return end == ".stl";
}

}  // namespace

Vertices polyhedron_from(const TomlTable& table, std::string& file) {
  const bool array = table.is_array("vertices");
  if (!array && !table.has("vertices"))
    table.refuse("vertices", "no such key",
                 "the name of a CSV with columns x, y and z or of an STL file, or an array of triples "
                 "[[\"0 mm\", \"0 mm\", \"0 mm\"], ...]");
  if (!array) file = table.path("vertices");
  const bool stl = !array && is_stl(file);
  const auto unit = table.optional_quantity("stl_unit", dimension::length, positive("length"));
  if (unit && !stl)
    table.refuse("stl_unit", "this beside vertices with units of their own", "stl_unit only beside an STL file");
  if (stl && !unit)
    table.refuse("stl_unit", "no such key", "the length that 1 means in the STL file, which has no units: \"1 mm\"");
  if (stl) return from_stl(file, *unit);
  if (!array) return from_csv(file);
  GivenPoints given;
  given.points = table.quantity_triples("vertices", dimension::length, any_number());
  for (std::size_t k = 0; k < given.points.size(); ++k) {
    given.places.push_back(table.place("vertices"));
    given.places.back().key += fmt::format("[{}]", k + 1);
  }
  return checked_hull(given, table.place("vertices")).vertices;
}

}  // namespace percal
