#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "percal/scene/block_toml.hpp"
#include "percal/scene/polyhedron_toml.hpp"
#include "percal/scene/profile.hpp"
#include "percal/scene/read_scene.hpp"
#include "percal/scene/sphere_toml.hpp"
#include "percal/text/csv.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

constexpr double right_angle = std::numbers::pi / 2;

// "45 deg" or "0.5 rad" in rad. nullopt where the text is something else.
std::optional<double> angle_of(std::string_view text) {
  double factor = 0;
  for (const auto& [unit, rad] : {std::pair{"deg", right_angle / 90}, {"\u00b0", right_angle / 90}, {"rad", 1.0}}) {
    if (!text.ends_with(unit)) continue;
    text.remove_suffix(std::string_view(unit).size());
    factor = rad;
    break;
  }
  if (factor == 0) return std::nullopt;
  try {
    const Quantity number = parse_quantity(text);
    if (number.dimension == dimension::none) return number.value * factor;
  } catch (const std::invalid_argument&) {
  }
  return std::nullopt;
}

}  // namespace

double angle_from(const TomlTable& table, const std::string& key, const Range& range) {
  table.describe(key, {"angle", range.words, ""});
  const std::string text = table.text(key);
  const auto value = angle_of(text);
  if (!value || !contains(range, *value)) table.refuse(key, in_quotes(text), range.words);
  return *value;
}

namespace {

double half_tip_angle(const TomlTable& table) {
  return angle_from(
             table, "tip_angle",
             {.low = 0,
              .high = 2 * right_angle,
              .low_open = true,
              .high_open = true,
              .words = "the full angle of the tip with its unit, such as \"60 deg\", above 0 and below 180 deg"}) /
         2;
}

Polygon rhombus(const TomlTable& table) {
  const double side = table.quantity("side", dimension::length, positive("length")), half = half_tip_angle(table);
  const double x = side * std::sin(half), y = side * std::cos(half);
  return {{0, 0}, {x, y}, {0, 2 * y}, {-x, y}};
}

Polygon cone(const TomlTable& table) {
  const double radius = radius_from(table);
  const double height = radius / std::tan(half_tip_angle(table));
  return {{0, 0}, {radius, height}, {-radius, height}};
}

Polygon points_from(const TomlTable& table, std::string& file) {
  if (table.is_array("vertices")) return table.quantity_pairs("vertices", dimension::length, any_number());
  if (!table.has("vertices"))
    table.refuse("vertices", "no such key",
                 "the name of a CSV with columns x and y, or an array of pairs [[\"0 mm\", \"0 mm\"], ...]");
  file = table.path("vertices");
  const CsvTable csv = read_csv(file);
  const auto x = csv.numbers("x", dimension::length), y = csv.numbers("y", dimension::length);
  Polygon points;
  for (std::size_t i = 0; i < x.size(); ++i) points.push_back({x[i], y[i]});
  return points;
}

// The whole convex outline, and in an axisymmetric scene a symmetric one: a right half is completed.
void set_outline(const TomlTable& table, const std::string& key, const Polygon& points, Geometry geometry,
                 ProfileShape& profile) {
  const std::string accepted = geometry == Geometry::axisymmetric
                                   ? "the corners of a convex polygon that as it stands is its own mirror image in x = "
                                     "0, or its right half with a side on x = 0"
                                   : "the corners of a convex polygon in their order";
  try {
    profile.vertices = convex_polygon(points);
    if (geometry != Geometry::axisymmetric || is_symmetric_about_the_axis(profile)) return;
    const double left = span(profile.vertices)[0];
    if (left < -mirror_tolerance * half_width(profile.vertices))
      throw std::invalid_argument("a profile that as it stands is not its own mirror image in x = 0");
    profile.vertices = mirrored_whole(profile.vertices);
    if (!is_symmetric_about_the_axis(profile))
      throw std::invalid_argument("a profile that as it is turned is not its own mirror image in x = 0");
  } catch (const std::invalid_argument& error) {
    table.refuse(key, error.what(), accepted);
  }
}

// rad; 0 where the table gives none.
double orientation_from(const TomlTable& table) {
  if (table.has("orientation"))
    return angle_from(table, "orientation",
                      {.low = -4 * right_angle,
                       .high = 4 * right_angle,
                       .words = "an angle from -360 to 360 deg with its unit, such as \"45 deg\" or \"0.5 rad\""});
  table.knows("orientation");
  return 0;
}

bool may_turn(const TomlTable& table) { return table.word("rotation", {"fixed", "free"}, 0) == 1; }

// m
std::optional<double> thickness_from(const TomlTable& table) {
  return table.optional_quantity("thickness", dimension::length, positive("length"));
}

// kg, or kg per metre of a prism.
std::optional<double> mass_from(const TomlTable& table, Geometry geometry) {
  const auto mass = table.optional_quantity("mass", dimension::mass, positive("mass"));
  const auto thickness = thickness_from(table);
  if (mass && table.has("density")) table.refuse("mass", "this beside density", "one of the two");
  if (thickness && geometry == Geometry::axisymmetric)
    table.refuse("thickness", "this in an axisymmetric scene", "no thickness: mass is that of the whole body");
  if (thickness && !mass && geometry == Geometry::plane_strain)
    table.refuse("thickness", "this without a mass", "mass beside it, or density alone");
  if (mass && !thickness && geometry == Geometry::plane_strain)
    table.refuse("mass", "this without a thickness", "thickness beside it: plane strain takes mass/thickness");
  return mass && thickness ? *mass / *thickness : mass;
}

// kg/m3: by the mass of a body of `per_density` m3, or m2 of a prism, or as the table says it.
double density_from(const TomlTable& table, std::optional<double> mass, double per_density) {
  if (!mass) return table.quantity("density", dimension::density, positive("density"));
  table.knows("density");
  const double density = *mass / per_density;
  if (!std::isnormal(density))
    table.refuse("mass", "a mass whose density is out of the range of numbers",
                 "a mass that fits the size of the particle");
  return density;
}

// Shapes other than round ones; `shape` is "profile", "rhombus" or "cone". Sets shape, radius and density.
void read_profile(const TomlTable& table, const std::string& shape, Geometry geometry, ParticleScene& particle) {
  if (shape == "cone" && geometry == Geometry::plane_strain)
    table.refuse("shape", "\"cone\" in plane strain",
                 "a prism: \"cylinder\", \"rhombus\" or \"profile\"; a wedge is a profile of three vertices");
  if (shape == "cone" && geometry == Geometry::block)
    table.refuse("shape", "\"cone\" in a block",
                 "a sphere, a prism (\"rhombus\" or \"profile\") or a polyhedron of many corners");
  ProfileShape profile;
  profile.orientation = orientation_from(table);
  const Polygon points = shape == "rhombus" ? rhombus(table)
                         : shape == "cone"  ? cone(table)
                                            : points_from(table, profile.vertices_file);
  const std::string outline_key = shape == "profile"         ? "vertices"
                                  : table.has("orientation") ? "orientation"
                                                             : "tip_angle";
  set_outline(table, outline_key, points, geometry, profile);

  profile.free_rotation = may_turn(table);
  if (profile.free_rotation && geometry == Geometry::axisymmetric)
    table.refuse(
        "rotation", "\"free\" in an axisymmetric scene",
        "\"fixed\"; a body of revolution that turns is no longer axisymmetric (geometry = \"plane strain\" lets it)");
  profile.mass = mass_from(table, geometry);
  if (geometry == Geometry::block) {
    const auto thickness = thickness_from(table);
    if (!thickness)
      table.refuse("thickness", "no such key", "the thickness of the prism, across the plane of its profile");
    profile.thickness = *thickness;
  }
  particle.radius = half_width(standing(profile));
  particle.density =
      density_from(table, profile.mass,
                   solid_body(profile, geometry).measure * (geometry == Geometry::axisymmetric ? 4 * right_angle : 1));
  particle.shape = std::move(profile);
}

// Sets shape, radius and density.
void read_polyhedron(const TomlTable& table, ParticleScene& particle) {
  PolyhedronShape body;
  body.vertices = polyhedron_from(table, body.vertices_file);
  body.orientation = orientation_from(table);
  body.free_rotation = may_turn(table);
  body.mass = mass_from(table, Geometry::block);
  const Vertices vertices = standing(body);
  const auto [left, right] = extent(vertices, 0);
  particle.radius = (right - left) / 2;
  particle.density = density_from(table, body.mass, mass_properties(convex_polyhedron(vertices)).volume);
  particle.shape = std::move(body);
}

// m3 of a sphere; m2 of a cylinder on its side, per metre of thickness.
double round_measure(double radius, Geometry geometry) {
  const double circle = std::numbers::pi * radius * radius;
  return geometry == Geometry::plane_strain ? circle : 4.0 / 3 * circle * radius;
}

// Keys that another shape has. They are known, and refused where they are given.
void refuse_keys(const TomlTable& table, const std::vector<std::string>& keys, const std::string& shape,
                 const std::string& accepted) {
  for (const std::string& key : keys) {
    if (table.has(key)) table.refuse(key, "this beside shape = " + in_quotes(shape), accepted);
    table.knows(key);
  }
}

void read_elasticity(const TomlTable& table, const std::string& shape, Geometry geometry, ParticleScene& particle) {
  particle.youngs_modulus = table.optional_quantity("youngs_modulus", dimension::pressure, positive("pressure"));
  const Range poisson{.low = -1,
                      .high = 0.5,
                      .low_open = true,
                      .high_open = true,
                      .words = "a number between -1 and 0.5, both excluded"};
  particle.poisson_ratio = table.number("poisson_ratio", poisson, particle.poisson_ratio);
  particle.elasticity =
      static_cast<Elasticity>(table.word("elasticity", elasticity_words(), static_cast<int>(particle.elasticity)));
  if (particle.elasticity != Elasticity::elastic) return;
  if (shape != "sphere" || geometry != Geometry::axisymmetric)
    table.refuse("elasticity",
                 "\"elastic\" for a " + shape + " in " + geometry_words()[static_cast<int>(geometry)] + " geometry",
                 "\"automatic\" or \"rigid\"; only a sphere in an axisymmetric scene can be elastic");
  if (!particle.youngs_modulus)
    table.refuse("elasticity", "\"elastic\" without a youngs_modulus", "youngs_modulus beside it, or \"rigid\"");
}

std::string shape_from(const TomlTable& table) {
  const std::vector<std::string> shapes{"sphere", "cylinder", "profile", "rhombus", "cone", "polyhedron"};
  return shapes[table.word("shape", shapes, 0)];
}

}  // namespace

ParticleScene body_from(const TomlTable& table, Geometry geometry) {
  const std::string shape = shape_from(table);
  if (shape == "cylinder" && geometry == Geometry::block)
    table.refuse("shape", "\"cylinder\" in a block", "\"sphere\"; a cylinder on its side is a profile of many corners");
  if (shape == "polyhedron" && geometry != Geometry::block)
    table.refuse("shape", "\"polyhedron\" in a scene of two dimensions", "the shape only beside geometry = \"block\"");
  if (shape == "cylinder" && geometry == Geometry::axisymmetric)
    table.refuse(
        "shape", "\"cylinder\" in an axisymmetric scene",
        "\"sphere\"; geometry = \"plane strain\" for a cylinder that lies on its side; shape = \"profile\" for one "
        "that stands");
  ParticleScene particle;
  particle.name = table.text("name", shape);
  if (shape == "profile" || shape == "polyhedron")
    table.describe("vertices",
                   {"file or array of pairs or triples",
                    "the name of a CSV with columns x and y, or pairs of lengths; of a polyhedron with z as "
                    "well, or of an STL file, or triples",
                    ""});
  if (shape != "polyhedron") refuse_keys(table, {"stl_unit"}, shape, "stl_unit only of a polyhedron from an STL file");
  if (shape == "sphere" || shape == "cylinder") {
    particle.radius = radius_from(table);
    particle.density = density_from(table, mass_from(table, geometry), round_measure(particle.radius, geometry));
    if (geometry == Geometry::block) refuse_keys(table, {"thickness"}, shape, "no thickness of a sphere");
    refuse_keys(table, {"vertices", "side", "tip_angle", "orientation", "rotation"}, shape,
                "the keys of a round particle: radius or diameter, density or mass");
  } else if (shape == "polyhedron") {
    refuse_keys(table, {"radius", "diameter"}, shape, "no radius: it is half the width of the shape as it stands");
    refuse_keys(table, {"side", "tip_angle", "thickness"}, shape, "the corners of the whole body as vertices");
    read_polyhedron(table, particle);
  } else {
    const bool cone = shape == "cone", profile = shape == "profile";
    if (!cone)
      refuse_keys(table, {"radius", "diameter"}, shape, "no radius: it is half the width of the shape as it stands");
    if (shape != "rhombus") refuse_keys(table, {"side"}, shape, "side only of a rhombus");
    if (profile) refuse_keys(table, {"tip_angle"}, shape, "tip_angle only of a rhombus or a cone");
    if (!profile) refuse_keys(table, {"vertices"}, shape, "vertices only beside shape = \"profile\"");
    read_profile(table, shape, geometry, particle);
  }
  read_angle(table, geometry, particle);
  if (const double coefficient = table.number("friction", not_negative(), 0.0); coefficient > 0)
    particle.friction = CoulombFriction{coefficient};
  return particle;
}

ParticleScene particle_from(const TomlTable& table, Geometry geometry) {
  ParticleScene particle = body_from(table, geometry);
  particle.speed = table.quantity("speed", dimension::speed, positive("speed"));
  read_elasticity(table, shape_from(table), geometry, particle);
  return particle;
}

}  // namespace percal
