#include "percal/scene/scene_toml.hpp"

#include <fmt/format.h>

#include "percal/scene/profile.hpp"
#include "percal/scene/read_scene.hpp"

namespace percal {
namespace {

constexpr double largest_time_step = 1.2;  // beyond it nothing is stable; docs/formats/scene.md
constexpr int most_elements_per_radius = 1000;
constexpr int most_graded_columns = 10000;
constexpr int most_replicates = 1000;

template <class Choice>
Choice choice(const TomlTable& table, const char* key, const std::vector<std::string>& words, Choice fallback) {
  return static_cast<Choice>(table.word(key, words, static_cast<int>(fallback)));
}

MeshScene read_mesh(const TomlTable& table, const Scene& scene) {
  MeshScene mesh;
  mesh.elements_per_radius =
      table.integer("elements_per_radius", 1, most_elements_per_radius, mesh.elements_per_radius);
  const double width_in_radii = scene.target.width / scene.particle.radius;
  constexpr double rounding = 1 + 1e-12;  // of width/radius
  const Range within_target{
      .low = 0,
      .high = width_in_radii * rounding,
      .low_open = true,
      .words = fmt::format("a number of radii above 0 and up to the target's width, {:.4g}", width_in_radii),
      .in_general = "a number of radii above 0 and up to the target's width"};
  mesh.fine_width = table.number("fine_width", within_target, mesh.fine_width);
  mesh.graded_columns = table.optional_integer("graded_columns", 1, most_graded_columns);
  mesh.whole = table.flag("whole", mesh.whole);
  if (mesh.whole && scene.geometry == Geometry::axisymmetric)
    table.refuse("whole", "true in an axisymmetric scene", "false; geometry = \"plane strain\" has two halves");
  if (table.has("whole") && !mesh.whole && needs_both_halves(scene.particle))
    table.refuse("whole", "false for a particle that may turn or is not its own mirror image in a vertical line",
                 "true, or nothing; rotation = \"fixed\" and a symmetric profile for a half model");
  return mesh;
}

// The first layer may be thinner than the particle; all of them may not.
std::vector<LowerLayerScene> read_below(const TomlTable& root, const TomlTable& target_table, const Scene& scene) {
  auto below = below_from(root.tables("below"), scene.target);
  double depth = scene.target.depth;
  for (const auto& layer : below) depth += layer.depth;
  if (!(depth > scene.particle.radius))
    target_table.refuse("depth", format_quantity(depth, dimension::length) + " with the layers below",
                        length_above(scene.particle.radius, "radius").words + ", all layers together");
  return below;
}

}  // namespace

const std::vector<std::string>& geometry_words() {
  static const std::vector<std::string> words{"axisymmetric", "plane strain"};
  return words;
}
const std::vector<std::string>& elasticity_words() {
  static const std::vector<std::string> words{"automatic", "rigid", "elastic"};
  return words;
}
const std::vector<std::string>& hourglass_words() {
  static const std::vector<std::string> words{"stiffness", "viscosity"};
  return words;
}
const std::vector<std::string>& volumetric_words() {
  static const std::vector<std::string> words{"log-quadratic", "quadratic", "logarithmic"};
  return words;
}
const std::vector<std::string>& eroded_node_words() {
  static const std::vector<std::string> words{"released", "in contact"};
  return words;
}

SolverScene solver_from(const TomlTable& table) {
  SolverScene solver;
  const auto share = [&table](const char* key, double fallback) { return table.number(key, not_negative(), fallback); };
  solver.contact_stiffness = table.number("contact_stiffness", positive(), solver.contact_stiffness);
  solver.hourglass = share("hourglass", solver.hourglass);
  solver.hourglass_form = choice(table, "hourglass_form", hourglass_words(), solver.hourglass_form);
  solver.volumetric_law = choice(table, "volumetric_law", volumetric_words(), solver.volumetric_law);
  solver.eroded_nodes = choice(table, "eroded_nodes", eroded_node_words(), solver.eroded_nodes);
  solver.linear_viscosity = share("linear_viscosity", solver.linear_viscosity);
  solver.quadratic_viscosity = share("quadratic_viscosity", solver.quadratic_viscosity);
  const Range stable{.low = 0, .high = largest_time_step, .low_open = true, .words = "a number above 0 and up to 1.2"};
  solver.time_step_factor = table.number("time_step_factor", stable, solver.time_step_factor);
  solver.rates = table.integer("rates", 1, 2, solver.rates);
  solver.stiffen_supersonic = table.flag("stiffen_supersonic", solver.stiffen_supersonic);
  solver.arithmetic = choice(table, "arithmetic", {"single", "double"}, solver.arithmetic);
  solver.end_time = table.optional_quantity("end_time", dimension::time, positive("time"));
  return solver;
}

Scene scene_from(const TomlTable& table) {
  Scene scene;
  scene.source = table.place("particle").file;
  scene.geometry = choice(table, "geometry", geometry_words(), scene.geometry);
  scene.particle = particle_from(table.table("particle"), scene.geometry);
  const TomlTable target = table.table("target");
  const bool layered = !table.tables("below").empty();
  scene.target = target_from(target, scene.particle, scene.geometry,
                             layered ? positive("length") : length_above(scene.particle.radius, "radius"));
  scene.below = read_below(table, target, scene);
  if (const auto mesh = table.optional_table("mesh")) scene.mesh = read_mesh(*mesh, scene);
  if (scene.geometry == Geometry::plane_strain && needs_both_halves(scene.particle)) scene.mesh.whole = true;
  if (const auto solver = table.optional_table("solver")) scene.solver = solver_from(*solver);
  if (const auto output = table.optional_table("output"))
    scene.output.history = output->flag("history", scene.output.history);
  scene.replicates = table.integer("replicates", 1, most_replicates, scene.replicates);
  return scene;
}

Scene read_scene(const std::string& path) {
  const TomlTable root = read_toml(path);
  Scene scene = scene_from(root);
  root.finish();
  return scene;
}

Scene parse_scene(const std::string& text, const std::string& name) {
  const TomlTable root = parse_toml(text, name);
  Scene scene = scene_from(root);
  root.finish();
  return scene;
}

}  // namespace percal
