#include "percal/scene/block_toml.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <numbers>

#include "percal/scene/profile.hpp"
#include "percal/scene/read_scene.hpp"
#include "percal/scene/width.hpp"

namespace percal {
namespace {

constexpr double usual_elements = usual_elements_on_smaller_half;
constexpr double beside_a_body = 0.15;  // radii of cubes beside the sides and beyond the ends of what is no sphere
constexpr double steepest_angle = std::numbers::pi * 80 / 180;
const Range growths{.low = 1, .high = 2, .words = "a number from 1 to 2"};

}  // namespace

MeshScene usual_mesh(const Scene& scene) {
  MeshScene mesh;
  if (scene.geometry != Geometry::block) return mesh;
  mesh.elements_per_radius = usual_elements;
  const double radius = scene.particle.radius;
  const auto lay = [&](double half_thickness, double sideways, double along) {
    mesh.elements_per_radius = usual_elements / std::min(1.0, half_thickness / radius);
    mesh.fine_width = sideways / radius + beside_a_body;
    mesh.fine_thickness = along / radius + beside_a_body;
  };
  if (const auto* prism = std::get_if<ProfileShape>(&scene.particle.shape))
    lay(prism->thickness / 2, reach(scene.particle, scene.geometry), prism->thickness / 2);
  if (const auto* body = std::get_if<PolyhedronShape>(&scene.particle.shape)) {
    const auto [low, high] = extent(body->vertices, 1);
    const bool rolls = body->free_rotation && needs_both_sides_across(scene.particle);
    lay((high - low) / 2, body->free_rotation ? reach_around(*body) : reach_along(*body, 0),
        rolls ? reach_around(*body) : reach_along(*body, 1));
  }
  return mesh;
}

void read_block_mesh(const TomlTable& table, const Scene& scene, MeshScene& mesh) {
  for (const std::string key : {"fine_thickness", "fine_depth", "growth", "whole_across"})
    refuse_elsewhere(table, key, scene.geometry);
  if (scene.geometry != Geometry::block) return;
  if (table.has("graded_columns"))
    table.refuse("graded_columns", "this in geometry \"block\"",
                 "growth: what each cell is larger than the one before, at most");
  const double radii = width_of(scene) / scene.particle.radius;
  constexpr double rounding = 1 + 1e-12;
  const Range within{.low = 0,
                     .high = radii * rounding,
                     .low_open = true,
                     .words = fmt::format("a number of radii above 0 and up to the target's width, {:.4g}", radii),
                     .in_general = "a number of radii above 0 and up to the target's width"};
  mesh.fine_thickness = table.number("fine_thickness", within, mesh.fine_thickness);
  mesh.fine_depth = table.optional_number("fine_depth", positive());
  mesh.growth = table.number("growth", growths, mesh.growth);
  mesh.whole_across = table.flag("whole_across", mesh.whole_across);
  if (mesh.whole_across && !std::holds_alternative<PolyhedronShape>(scene.particle.shape))
    table.refuse("whole_across", "true of a sphere or a prism, which is its own mirror image in y = 0",
                 "false, or nothing; a prism that may turn about all axes is a polyhedron of its corners");
  if (table.has("whole_across") && !mesh.whole_across && needs_both_sides_across(scene.particle))
    table.refuse("whole_across", "false for a particle that is not its own mirror image in y = 0", "true, or nothing");
}

void refuse_elsewhere(const TomlTable& table, const std::string& key, Geometry geometry) {
  if (geometry == Geometry::block) return;
  if (table.has(key))
    table.refuse(key, "this in a scene of two dimensions", "the key only beside geometry = \"block\"");
  table.knows(key);
}

FibreFamilies fibre_families_from(const TomlTable& table) {
  const Range dispersion{
      .low = 0, .high = 1.0 / 3, .words = "a number from 0 (all along the family) to 1/3 (in all directions)"};
  FibreFamilies fibres{.k1 = table.quantity("k1", dimension::pressure, positive("pressure")),
                       .k2 = table.number("k2", positive())};
  fibres.kappa = table.number("kappa", dispersion, fibres.kappa);
  fibres.angle = angle_from(
      table, "angle",
      {.low = 0, .high = std::numbers::pi / 2, .words = "an angle from 0 to 90 deg with its unit, such as \"30 deg\""});
  return fibres;
}

void read_angle(const TomlTable& table, Geometry geometry, ParticleScene& particle) {
  if (!table.has("angle")) return table.knows("angle");
  if (geometry != Geometry::block)
    table.refuse("angle", "this in a scene of two dimensions", "geometry = \"block\" for a particle that comes aslant");
  const auto is_held = [&](const auto* body) { return body && !body->free_rotation; };
  if (is_held(std::get_if<ProfileShape>(&particle.shape)) || is_held(std::get_if<PolyhedronShape>(&particle.shape)))
    table.refuse("angle", "this beside rotation = \"fixed\"",
                 "rotation = \"free\": a particle that comes aslant is not held");
  particle.angle = angle_from(
      table, "angle",
      {.low = 0, .high = steepest_angle, .words = "an angle from 0 to 80 deg with its unit, such as \"30 deg\""});
}

void refuse_what_a_block_lacks(const TomlTable& root, const Scene& scene) {
  const auto need_none = [](const TomlTable& table, bool is_there, const std::string& key, const std::string& found,
                            const std::string& accepted) {
    if (is_there) table.refuse(key, found + " in geometry \"block\"", accepted);
  };
  const TomlTable target = root.table("target");
  const LayerScene& layer = scene.target;
  need_none(target, !std::holds_alternative<NoRelaxation>(layer.relaxation), "relaxation", "relaxation",
            "no relaxation");
  need_none(target, !std::holds_alternative<NoAverage>(layer.erosion_average), "erosion",
            "a limit judged over a length", "limits that each element is judged by alone");
  if (const auto solver = root.optional_table("solver")) {
    const SolverScene& asked = scene.solver;
    need_none(*solver, asked.rates != 1, "rates", "2", "1");
    need_none(*solver, asked.hourglass_form != HourglassForm::stiffness, "hourglass_form", "\"viscosity\"",
              "\"stiffness\"");
    need_none(*solver, asked.volumetric_law != VolumetricLaw::log_quadratic, "volumetric_law", "another law",
              "\"log-quadratic\"");
    need_none(*solver, asked.eroded_nodes != ErodedNodes::released, "eroded_nodes", "\"in contact\"", "\"released\"");
  }
  if (const auto output = root.optional_table("output"))
    need_none(*output, scene.output.channel, "channel", "the radius of the channel", "false");
}

}  // namespace percal
