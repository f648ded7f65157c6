#include "percal/scene/scene_toml.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "percal/units/words.hpp"

namespace percal {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double smallest_alpha = 1e-3;    // the solver divides by alpha
constexpr double largest_time_step = 1.2;  // beyond it nothing is stable; docs/formats/scene.md
constexpr int most_elements_per_radius = 1000;
constexpr int most_graded_columns = 10000;
constexpr int most_replicates = 1000;

SphereScene read_particle(const TomlTable& table) {
  SphereScene particle;
  if (const auto shape = table.optional_text("shape"); shape && *shape != "sphere") {
    table.refuse("shape", in_quotes(*shape), "\"sphere\", the only shape there is so far");
  }
  particle.name = table.text("name", particle.name);
  particle.radius = table.quantity("radius", dimension::length, positive("length"));
  particle.density = table.quantity("density", dimension::density, positive("density"));
  particle.speed = table.quantity("speed", dimension::speed, positive("speed"));
  particle.youngs_modulus = table.optional_quantity("youngs_modulus", dimension::pressure, positive("pressure"));
  return particle;
}

Erosion read_erosion(const TomlTable& target) {
  const auto table = target.optional_table("erosion");
  if (!table) return NoErosion{};
  StrainErosion erosion;
  erosion.limit = table->number("strain", positive("strain"));
  erosion.measure = static_cast<StrainMeasure>(table->word(
      "measure",
      {word(StrainMeasure::engineering), word(StrainMeasure::true_strain), word(StrainMeasure::green_lagrange)}, 0));
  return erosion;
}

void read_ogden(const TomlTable& table, LayerScene& target) {
  target.convention = static_cast<ModulusConvention>(
      table.word("convention", {word(ModulusConvention::true_shear), word(ModulusConvention::mu_over_alpha)}, 0));
  target.alpha = table.number("alpha", any_number());
  if (std::abs(target.alpha) < smallest_alpha) {
    table.refuse("alpha", fmt::format("{}", target.alpha),
                 "a number from 0.001 up or from -0.001 down; alpha = 0 is not solved so far");
  }
  target.mu_as_given = table.quantity("mu", dimension::pressure, any_number());
  const double mu = true_modulus(target.mu_as_given, target.alpha, target.convention);
  if (mu > 0 && std::isfinite(mu)) return;
  const std::string found = fmt::format("{} Pa", target.mu_as_given);
  if (target.convention == ModulusConvention::true_shear) table.refuse("mu", found, "a positive pressure");
  table.refuse("mu", fmt::format("{}, which makes the true shear modulus mu alpha/2 = {} Pa", found, mu),
               fmt::format("a {} pressure where convention = \"mu/alpha\" and alpha = {}",
                           target.alpha > 0 ? "positive" : "negative", target.alpha));
}

Range larger_than_radius(const SphereScene& particle) {
  return {.low = particle.radius,
          .high = infinity,
          .low_open = true,
          .words = "a length above the particle's radius of " + format_quantity(particle.radius, dimension::length)};
}

LayerScene read_target(const TomlTable& table, const SphereScene& particle) {
  LayerScene target;
  target.name = table.text("name", target.name);
  target.density = table.quantity("density", dimension::density, positive("density"));
  read_ogden(table, target);
  target.volumetric = volumetric_from(table);
  target.depth = table.quantity("depth", dimension::length, larger_than_radius(particle));
  target.width = table.quantity("width", dimension::length, larger_than_radius(particle));
  target.bottom = static_cast<Bottom>(table.word("bottom", {"free", "fixed"}, static_cast<int>(target.bottom)));
  target.erosion = read_erosion(table);
  return target;
}

MeshScene read_mesh(const TomlTable& table, double width_in_radii) {
  MeshScene mesh;
  mesh.elements_per_radius =
      table.integer("elements_per_radius", 1, most_elements_per_radius, mesh.elements_per_radius);
  constexpr double rounding = 1 + 1e-12;  // of width/radius
  const Range within_target{
      .low = 0,
      .high = width_in_radii * rounding,
      .low_open = true,
      .words = fmt::format("a number of radii above 0 and up to the target's width, {:.4g}", width_in_radii)};
  mesh.fine_width = table.number("fine_width", within_target, mesh.fine_width);
  mesh.graded_columns = table.optional_integer("graded_columns", 1, most_graded_columns);
  return mesh;
}

}  // namespace

VolumetricChoice volumetric_from(const TomlTable& table) {
  const auto nu = table.optional_number("nu", {.low = -1,
                                               .high = 0.5,
                                               .low_open = true,
                                               .high_open = true,
                                               .words = "a number between -1 and 0.5, both excluded"});
  const auto ratio = table.optional_number("bulk_to_shear", positive("number (K/mu)"));
  if (nu && ratio) table.refuse("bulk_to_shear", "this beside nu", "one of the two, or neither (K is then chosen)");
  if (nu) return PoissonRatio{*nu};
  if (ratio) return BulkToShear{*ratio};
  return ChooseBulk{};
}

SolverScene solver_from(const TomlTable& table) {
  SolverScene solver;
  const auto share = [&table](const char* key, double fallback) { return table.number(key, not_negative(), fallback); };
  solver.contact_stiffness = table.number("contact_stiffness", positive(), solver.contact_stiffness);
  solver.hourglass = share("hourglass", solver.hourglass);
  solver.linear_viscosity = share("linear_viscosity", solver.linear_viscosity);
  solver.quadratic_viscosity = share("quadratic_viscosity", solver.quadratic_viscosity);
  const Range stable{.low = 0, .high = largest_time_step, .low_open = true, .words = "a number above 0 and up to 1.2"};
  solver.time_step_factor = table.number("time_step_factor", stable, solver.time_step_factor);
  solver.arithmetic =
      static_cast<Arithmetic>(table.word("arithmetic", {"single", "double"}, static_cast<int>(solver.arithmetic)));
  solver.end_time = table.optional_quantity("end_time", dimension::time, positive("time"));
  return solver;
}

Scene scene_from(const TomlTable& table) {
  Scene scene;
  scene.source = table.place("particle").file;
  scene.particle = read_particle(table.table("particle"));
  scene.target = read_target(table.table("target"), scene.particle);
  const double width_in_radii = scene.target.width / scene.particle.radius;
  if (const auto mesh = table.optional_table("mesh")) scene.mesh = read_mesh(*mesh, width_in_radii);
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
