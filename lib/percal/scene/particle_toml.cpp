#include "percal/scene/read_scene.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

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

}  // namespace

ParticleScene particle_from(const TomlTable& table, Geometry geometry) {
  const std::vector<std::string> shapes{"sphere", "cylinder", "profile", "rhombus", "cone"};
  const std::string shape = shapes[table.word("shape", shapes, 0)];
  if (shape == "cylinder" && geometry == Geometry::axisymmetric)
    table.refuse(
        "shape", "\"cylinder\" in an axisymmetric scene",
        "\"sphere\"; geometry = \"plane strain\" for a cylinder that lies on its side; shape = \"profile\" for one "
        "that stands");
  ParticleScene particle;
  particle.name = table.text("name", shape);
  if (shape == "sphere" || shape == "cylinder") {
    particle.radius = table.quantity("radius", dimension::length, positive("length"));
    particle.density = table.quantity("density", dimension::density, positive("density"));
    refuse_keys(table, {"vertices", "side", "tip_angle", "orientation", "rotation"}, shape,
                "the keys of a round particle: radius and density");
    refuse_keys(table, {"mass", "thickness"}, shape, "density; a mass is given with profiles only");
  } else {
    const bool cone = shape == "cone", profile = shape == "profile";
    if (!cone) refuse_keys(table, {"radius"}, shape, "no radius: it is half the width of the shape as it stands");
    if (shape != "rhombus") refuse_keys(table, {"side"}, shape, "side only of a rhombus");
    if (profile) refuse_keys(table, {"tip_angle"}, shape, "tip_angle only of a rhombus or a cone");
    if (!profile) refuse_keys(table, {"vertices"}, shape, "vertices only beside shape = \"profile\"");
    read_profile(table, shape, geometry, particle);
  }
  particle.speed = table.quantity("speed", dimension::speed, positive("speed"));
  read_elasticity(table, shape, geometry, particle);
  return particle;
}

}  // namespace percal
