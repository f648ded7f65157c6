#include "percal/scene/scene_toml.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "percal/scene/block_toml.hpp"
#include "percal/scene/document_kind.hpp"
#include "percal/scene/erosion_length.hpp"
#include "percal/scene/erosion_toml.hpp"
#include "percal/scene/profile.hpp"
#include "percal/scene/read_scene.hpp"
#include "percal/scene/width.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double smallest_alpha = 1e-3;  // the solver divides by alpha
const Range initial_stretches{.low = 0.5, .high = 3, .words = "a stretch from 0.5 to 3; 1: none"};

std::optional<double> stretch_across_from(const TomlTable& layer, Geometry geometry) {
  refuse_elsewhere(layer, "stretch_across", geometry);
  return layer.optional_number("stretch_across", initial_stretches);
}

Relaxation read_relaxation(const TomlTable& target) {
  const auto tables = target.tables("relaxation");
  if (tables.empty()) return NoRelaxation{};
  if (tables.size() > most_relaxation_terms)
    target.refuse("relaxation", fmt::format("{} terms", tables.size()), "up to 3 terms, each a [[target.relaxation]]");
  PronySeries series;
  double sum = 0;
  for (const TomlTable& table : tables) {
    const Range share{
        .low = 0, .high = 1, .low_open = true, .high_open = true, .words = "a number between 0 and 1, both excluded"};
    series.terms.push_back({table.number("share", share), table.quantity("time", dimension::time, positive("time"))});
    sum += series.terms.back().share;
    if (!(sum < 1))
      table.refuse("share", fmt::format("{}, which makes the shares' sum {}", series.terms.back().share, sum),
                   "shares with a sum below 1, so that some stiffness is left");
  }
  return series;
}

Fibres read_fibres(const TomlTable& layer, Geometry geometry) {
  const auto table = layer.optional_table("fibres");
  if (!table) return NoFibres{};
  if (geometry == Geometry::block && table->has("angle")) return fibre_families_from(*table);
  refuse_elsewhere(*table, "angle", geometry);
  const Range dispersion{
      .low = 1.0 / 3, .high = 0.5, .words = "a number from 1/3 (in all directions) to 1/2 (in the layer's plane)"};
  PlanarFibres fibres{.k1 = table->quantity("k1", dimension::pressure, positive("pressure")),
                      .k2 = table->number("k2", positive())};
  fibres.kappa = table->number("kappa", dispersion, fibres.kappa);
  return fibres;
}

struct OgdenAsGiven {
  double mu;  // Pa, meant as the convention says
  double alpha;
};

OgdenAsGiven read_ogden(const TomlTable& table, ModulusConvention convention) {
  const double alpha = table.number("alpha", any_number());
  if (std::abs(alpha) < smallest_alpha) {
    table.refuse("alpha", fmt::format("{}", alpha),
                 "a number from 0.001 up or from -0.001 down; alpha = 0 is not solved so far");
  }
  const double mu_as_given = table.quantity("mu", dimension::pressure, any_number());
  const double mu = true_modulus(mu_as_given, alpha, convention);
  if (mu > 0 && std::isfinite(mu)) return {mu_as_given, alpha};
  const std::string found = fmt::format("{} Pa", mu_as_given);
  if (convention == ModulusConvention::true_shear) table.refuse("mu", found, "a positive pressure");
  table.refuse("mu", fmt::format("{}, which makes the true shear modulus mu alpha/2 = {} Pa", found, mu),
               fmt::format("a {} pressure where convention = \"mu/alpha\" and alpha = {}",
                           alpha > 0 ? "positive" : "negative", alpha));
}

// "a length above the particle's radius of 1 um".
Range length_above(double low, const std::string& of_what) {
  return {.low = low,
          .high = infinity,
          .low_open = true,
          .words = "a length above the particle's " + of_what + " of " + format_quantity(low, dimension::length),
          .in_general = "a length above the particle's " + of_what};
}

// The first layer; the particle decides how wide it must be, `depth` how deep.
LayerScene target_from(const TomlTable& table, const ParticleScene& particle, Geometry geometry, const Range& depth) {
  LayerScene target;
  target.name = table.text("name", target.name);
  target.density = table.quantity("density", dimension::density, positive("density"));
  target.convention = static_cast<ModulusConvention>(
      table.word("convention", {word(ModulusConvention::true_shear), word(ModulusConvention::mu_over_alpha)}, 0));
  const auto [mu, alpha] = read_ogden(table, target.convention);
  target.mu_as_given = mu;
  target.alpha = alpha;
  target.volumetric = volumetric_from(table);
  target.depth = table.quantity("depth", dimension::length, depth);
  const double widest = reach(particle, geometry);
  target.width = table.optional_quantity(
      "width", dimension::length,
      length_above(widest, widest == particle.radius ? "radius" : "largest distance from its middle line"));
  target.bottom = static_cast<Bottom>(table.word("bottom", {"free", "fixed"}, static_cast<int>(target.bottom)));
  target.stretch = table.number("stretch", initial_stretches, target.stretch);
  target.stretch_across = stretch_across_from(table, geometry);
  target.fibres = read_fibres(table, geometry);
  read_erosion(table, particle, target);
  target.relaxation = read_relaxation(table);
  return target;
}

std::vector<LowerLayerScene> below_from(const std::vector<TomlTable>& tables, const LayerScene& first,
                                        Geometry geometry) {
  std::vector<LowerLayerScene> below;
  for (const TomlTable& table : tables) {
    LowerLayerScene layer;
    layer.name = table.text("name", layer.name);
    layer.density = table.quantity("density", dimension::density, positive("density"));
    const auto [mu, alpha] = read_ogden(table, first.convention);
    layer.mu_as_given = mu;
    layer.alpha = alpha;
    layer.volumetric = volumetric_from(table);
    layer.depth = table.quantity("depth", dimension::length, positive("length"));
    layer.stretch = table.number("stretch", initial_stretches, layer.stretch);
    layer.stretch_across = stretch_across_from(table, geometry);
    layer.fibres = read_fibres(table, geometry);
    read_lower_erosion(table, first, layer);
    below.push_back(layer);
  }
  return below;
}

constexpr double largest_time_step = 1.2;  // beyond it nothing is stable; docs/formats/scene.md
constexpr int most_graded_columns = 10000;
constexpr int most_replicates = 1000;

template <class Choice>
Choice choice(const TomlTable& table, const char* key, const std::vector<std::string>& words, Choice fallback) {
  return static_cast<Choice>(table.word(key, words, static_cast<int>(fallback)));
}

MeshScene read_mesh(const TomlTable& table, const Scene& scene) {
  MeshScene mesh = scene.mesh;
  mesh.elements_per_radius = table.number("elements_per_radius", elements_per_radius_range(), mesh.elements_per_radius);
  const double width_in_radii = width_of(scene) / scene.particle.radius;
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
  read_block_mesh(table, scene, mesh);
  if (mesh.whole && scene.geometry == Geometry::axisymmetric)
    table.refuse("whole", "true in an axisymmetric scene",
                 "false; geometry = \"plane strain\" or \"block\" has two halves");
  if (table.has("whole") && !mesh.whole && needs_both_halves(scene.particle))
    table.refuse("whole", "false for a particle that may turn or is not its own mirror image in a vertical line",
                 "true, or nothing; rotation = \"fixed\" and a symmetric profile for a half model");
  return mesh;
}

OutputScene read_output(const TomlTable& table) {
  OutputScene output;
  output.history = table.flag("history", output.history);
  output.after = choice(table, "after", run_until_words(), output.after);
  output.channel = table.flag("channel", output.channel);
  return output;
}

// The first layer may be thinner than the particle; all of them may not.
std::vector<LowerLayerScene> read_below(const TomlTable& root, const TomlTable& target_table, const Scene& scene) {
  auto below = below_from(root.tables("below"), scene.target, scene.geometry);
  double depth = scene.target.depth;
  for (const auto& layer : below) depth += layer.depth;
  if (!(depth > scene.particle.radius))
    target_table.refuse("depth", format_quantity(depth, dimension::length) + " with the layers below",
                        length_above(scene.particle.radius, "radius").words + ", all layers together");
  return below;
}

}  // namespace

const std::vector<std::string>& geometry_words() {
  static const std::vector<std::string> words{"axisymmetric", "plane strain", "block"};
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
const std::vector<std::string>& run_until_words() {
  static const std::vector<std::string> words{"deepest", "passage", "rest"};
  return words;
}

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

Range elements_per_radius_range() { return {.low = 1, .high = 1000, .words = "a number from 1 to 1000"}; }

// Bricks have twelve patterns to hold where a quad has two: docs/theory/solid.md (10).
double usual_hourglass(HourglassForm form, Geometry geometry) {
  if (form == HourglassForm::viscosity) return 0.02;
  return geometry == Geometry::block ? 2 : 0.5;
}

SolverScene usual_solver(Geometry geometry) {
  SolverScene solver;
  solver.hourglass = usual_hourglass(solver.hourglass_form, geometry);
  if (geometry == Geometry::block) solver.rates = 1;
  return solver;
}

SolverScene solver_from(const TomlTable& table, Geometry geometry) {
  SolverScene solver = usual_solver(geometry);
  const auto share = [&table](const char* key, double fallback) { return table.number(key, not_negative(), fallback); };
  if (table.has("contact_stiffness")) {  // of a scene of a time when contact had springs
    table.number("contact_stiffness", positive());
    solver.contact_stiffness_was_given = true;
  }
  solver.hourglass_form = choice(table, "hourglass_form", hourglass_words(), solver.hourglass_form);
  solver.hourglass = share("hourglass", usual_hourglass(solver.hourglass_form, geometry));
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
  scene.mesh = usual_mesh(scene);
  if (const auto mesh = table.optional_table("mesh")) scene.mesh = read_mesh(*mesh, scene);
  if (scene.geometry != Geometry::axisymmetric && needs_both_halves(scene.particle)) scene.mesh.whole = true;
  if (scene.geometry == Geometry::block && needs_both_sides_across(scene.particle)) scene.mesh.whole_across = true;
  if (erosion_length(scene.target)) {
    const TomlTable erosion = target.table("erosion");
    need_elements_in_erosion_length(scene, erosion.place(erosion_length_key(erosion)));
  }
  scene.solver = usual_solver(scene.geometry);
  if (const auto solver = table.optional_table("solver")) scene.solver = solver_from(*solver, scene.geometry);
  if (const auto output = table.optional_table("output")) scene.output = read_output(*output);
  scene.replicates = table.integer("replicates", 1, most_replicates, scene.replicates);
  if (scene.geometry == Geometry::block) refuse_what_a_block_lacks(table, scene);
  return scene;
}

Scene read_scene(const std::string& path) {
  const TomlTable root = read_toml(path);
  need_kind(root, DocumentKind::scene);
  Scene scene = scene_from(root);
  root.finish();
  return scene;
}

Scene parse_scene(const std::string& text, const std::string& name) {
  const TomlTable root = parse_toml(text, name);
  need_kind(root, DocumentKind::scene);
  Scene scene = scene_from(root);
  root.finish();
  return scene;
}

}  // namespace percal
