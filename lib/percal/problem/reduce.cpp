#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "percal/problem/domain.hpp"
#include "percal/problem/particle.hpp"
#include "percal/problem/problem.hpp"
#include "percal/scene/erosion_length.hpp"
#include "percal/scene/erosion_size.hpp"
#include "percal/scene/profile.hpp"
#include "percal/scene/width.hpp"

namespace percal {
namespace {

constexpr int usual_history_samples = 400;
constexpr double longest_sensible_average = 1;  // radii

struct BulkRatio {
  double pi4;
  double operator()(const ChooseBulk&) const { return std::max(least_bulk_ratio, subsonic_bulk_ratio(pi4)); }
  double operator()(const PoissonRatio& given) const { return bulk_to_shear(given.nu); }
  double operator()(const BulkToShear& given) const { return given.ratio; }
};

// K/mu of a layer with this rho v^2/mu. One that makes the impact supersonic is raised where the scene asks for that.
double bulk_ratio(const VolumetricChoice& volumetric, double pi4, const std::string& layer, const SolverScene& solver,
                  Reduction& reduction) {
  const double given = round_to_12_digits(std::visit(BulkRatio{pi4}, volumetric));
  const double mach = std::sqrt(pi4 / (given + 4.0 / 3));
  if (!solver.stiffen_supersonic || mach < 1) return given;
  const double raised = round_to_12_digits(subsonic_bulk_ratio(pi4));
  reduction.warnings.push_back(
      fmt::format("{}: K/mu = {:.4g} makes the impact supersonic (Mach number {:.3g}); raised to {:.4g}, as "
                  "stiffen_supersonic asks, for a Mach number of {}",
                  layer, given, mach, raised, recommended_mach));
  return raised;
}

// Limits without dimensions.
struct ReducedErosion {
  double stress;  // rho_t v^2, Pa
  Erosion operator()(const NoErosion&) const { return NoErosion{}; }
  Erosion operator()(const StrainErosion& strain) const {
    return StrainErosion{round_to_12_digits(strain.limit), strain.measure};
  }
  Erosion operator()(const StressErosion& erosion) const {
    return StressErosion{round_to_12_digits(erosion.limit / stress)};
  }
  Erosion operator()(const EnergyErosion& erosion) const {
    return EnergyErosion{round_to_12_digits(erosion.limit / stress)};
  }
};

// Throws BadInput where the particle is elastic: its outline takes no impulse along itself.
Friction reduced_friction(const Scene& scene) {
  const auto* coulomb = std::get_if<CoulombFriction>(&scene.particle.friction);
  if (!coulomb) return NoFriction{};
  if (is_elastic(scene))
    throw BadInput({.file = scene.source, .line = 0, .key = "particle.friction"},
                   fmt::format("{} of a particle that is elastic", coulomb->coefficient),
                   "friction of a rigid particle: elasticity = \"rigid\" beside it, or no friction");
  return CoulombFriction{round_to_12_digits(coulomb->coefficient)};
}

// Limits of stress and energy over `stress`, rho_t v^2 in Pa.
FurtherErosion reduced_further(const FurtherErosion& further, double stress) {
  const auto over = [stress](const std::optional<double>& limit) {
    return limit ? std::optional(round_to_12_digits(*limit / stress)) : std::nullopt;
  };
  return {over(further.stress), over(further.energy)};
}

Fibres reduced_fibres(const Fibres& fibres, double stress) {
  if (const auto* families = std::get_if<FibreFamilies>(&fibres))
    return FibreFamilies{round_to_12_digits(families->k1 / stress), round_to_12_digits(families->k2),
                         round_to_12_digits(families->kappa), round_to_12_digits(families->angle)};
  const auto* planar = std::get_if<PlanarFibres>(&fibres);
  if (!planar) return NoFibres{};
  return PlanarFibres{round_to_12_digits(planar->k1 / stress), round_to_12_digits(planar->k2),
                      round_to_12_digits(planar->kappa)};
}

// The average where something erodes, in radii. Throws BadInput where the mesh is too coarse for it.
ErosionAverage reduced_average(const Scene& scene, Reduction& reduction) {
  const auto length = erosion_length(scene.target);
  if (!length || std::holds_alternative<NoErosion>(scene.target.erosion)) return NoAverage{};
  need_elements_in_erosion_length(scene, {.file = scene.source, .line = 0, .key = "target.erosion.length"});
  const double radii = round_to_12_digits(*length / scene.particle.radius);
  if (radii > longest_sensible_average)
    reduction.warnings.push_back(
        fmt::format("erosion is judged over {:.3g} radii: over more than one, the average hardly tells the tip of the "
                    "channel from its wall",
                    radii));
  return AverageWithin{radii};
}

// The limit of a layer below, as the first one's is meant.
double lower_limit(const LowerLayerScene& layer, const Scene& scene, double stress) {
  const Erosion& first = scene.target.erosion;
  if (!layer.erosion_limit || std::holds_alternative<NoErosion>(first)) return std::numeric_limits<double>::infinity();
  if (std::holds_alternative<StrainErosion>(first))
    return round_to_12_digits(strain_limit(*layer.erosion_limit, layer.erosion_by_size, scene.particle));
  return round_to_12_digits(*layer.erosion_limit / stress);
}

std::optional<double> reduced_stretch(const std::optional<double>& stretch) {
  return stretch ? std::optional(round_to_12_digits(*stretch)) : std::nullopt;
}

std::vector<LowerLayer> layers_below(const Scene& scene, double stress, Reduction& reduction) {
  std::vector<LowerLayer> below;
  for (const LowerLayerScene& layer : scene.below) {
    const double mu = true_modulus(layer.mu_as_given, layer.alpha, scene.target.convention);
    LowerLayer reduced;
    reduced.depth = round_to_12_digits(layer.depth / scene.particle.radius);
    reduced.density = round_to_12_digits(layer.density / scene.target.density);
    reduced.mu = round_to_12_digits(mu / stress);
    reduced.alpha = round_to_12_digits(layer.alpha);
    reduced.bulk_ratio =
        bulk_ratio(layer.volumetric, reduced.density / reduced.mu, layer.name, scene.solver, reduction);
    reduced.erosion_limit = lower_limit(layer, scene, stress);
    reduced.further_erosion = reduced_further(layer.further_erosion, stress);
    reduced.stretch = round_to_12_digits(layer.stretch);
    reduced.stretch_across = reduced_stretch(layer.stretch_across);
    reduced.fibres = reduced_fibres(layer.fibres, stress);
    below.push_back(reduced);
  }
  return below;
}

// Throws BadInput where a layer's own stretch is beyond its limit of strain.
void need_whole_layers(const Scene& scene, const Problem& p) {
  const auto* strain = std::get_if<StrainErosion>(&p.erosion);
  if (!strain) return;
  const auto check = [&](double stretch, double limit, const std::string& key) {
    if (!std::isfinite(limit) || stretch == 1 || stretch < stretch_at(limit, strain->measure)) return;
    throw BadInput({.file = scene.source, .line = 0, .key = key},
                   fmt::format("{}, which reaches the erosion strain of {} before the impact", stretch, limit),
                   fmt::format("a stretch below {:.6g}", stretch_at(limit, strain->measure)));
  };
  const auto check_both = [&](const auto& layer, double limit, const std::string& table) {
    check(layer.stretch, limit, table + ".stretch");
    check(layer.stretch_across.value_or(1), limit, table + ".stretch_across");
  };
  check_both(p, strain->limit, "target");
  for (std::size_t k = 0; k < p.below.size(); ++k)
    check_both(p.below[k], p.below[k].erosion_limit, fmt::format("below[{}]", k + 1));
}

Relaxation reduced_relaxation(const Scene& scene) {
  const auto* series = std::get_if<PronySeries>(&scene.target.relaxation);
  if (!series) return NoRelaxation{};
  PronySeries reduced;
  for (const PronyTerm& term : series->terms)
    reduced.terms.push_back(
        {round_to_12_digits(term.share), round_to_12_digits(term.time * scene.particle.speed / scene.particle.radius)});
  return reduced;
}

void take_block(const Scene& scene, Problem& p) {
  p.whole |= scene.particle.angle != 0;
  p.graded_columns = 0;
  p.block = {
      .fine_thickness = round_to_12_digits(scene.mesh.fine_thickness),
      .fine_depth = std::min(p.whole_depth(), round_to_12_digits(scene.mesh.fine_depth.value_or(p.whole_depth()))),
      .growth = round_to_12_digits(scene.mesh.growth),
      .angle = round_to_12_digits(scene.particle.angle),
      .whole_across = scene.mesh.whole_across || needs_both_sides_across(scene.particle)};
}

void take_mesh(const Scene& scene, Problem& p) {
  p.elements_per_radius = round_to_12_digits(scene.mesh.elements_per_radius);
  p.fine_width = round_to_12_digits(scene.mesh.fine_width);
  p.whole = scene.geometry != Geometry::axisymmetric && (scene.mesh.whole || needs_both_halves(scene.particle));
  if (scene.geometry == Geometry::block) return take_block(scene, p);
  p.graded_columns = scene.mesh.graded_columns ? *scene.mesh.graded_columns : usual_graded_columns(p);
}

void take_solver(const Scene& scene, Problem& p) {
  const SolverScene& solver = scene.solver;
  p.hourglass = round_to_12_digits(solver.hourglass);
  p.hourglass_form = solver.hourglass_form;
  p.volumetric_law = solver.volumetric_law;
  p.eroded_nodes = solver.eroded_nodes;
  p.linear_viscosity = round_to_12_digits(solver.linear_viscosity);
  p.quadratic_viscosity = round_to_12_digits(solver.quadratic_viscosity);
  p.time_step_factor = round_to_12_digits(solver.time_step_factor);
  p.rates = solver.rates;
  p.arithmetic = solver.arithmetic;
  if (solver.end_time) p.end_time = round_to_12_digits(*solver.end_time * scene.particle.speed / scene.particle.radius);
}

void warn_of_the_particle(const Scene& scene, Reduction& reduction) {
  const auto ratio = stress_over_particle_stiffness(scene);
  if (!ratio || *ratio < rigid_below || is_elastic(scene)) return;
  reduction.warnings.push_back(fmt::format(
      "(rho_t v^2 + 10 mu)/E = {:.2g} is not below {}: the particle's elasticity, left out here, may matter", *ratio,
      rigid_below));
}

void warn_of_the_mach_number(Reduction& reduction) {
  if (reduction.mach >= 1)
    reduction.warnings.push_back(fmt::format(
        "Mach number {:.3g}: the impact is faster than the target's waves; it runs with shock viscosity and a "
        "smaller step, and the depth depends on K",
        reduction.mach));
  else if (reduction.mach > recommended_mach)
    reduction.warnings.push_back(
        fmt::format("Mach number {:.3g} is above {}: the depth may depend on K", reduction.mach, recommended_mach));
}

}  // namespace

Reduction reduce(const Scene& scene) {
  const auto& particle = scene.particle;
  const auto& target = scene.target;
  Reduction reduction;
  reduction.scales = {particle.radius, particle.speed, target.density};
  reduction.mu_true = true_modulus(target.mu_as_given, target.alpha, target.convention);
  const double stress = target.density * particle.speed * particle.speed;

  Problem& p = reduction.problem;
  p.pi4 = round_to_12_digits(stress / reduction.mu_true);
  p.density_ratio = round_to_12_digits(particle_density(scene) / target.density);
  p.alpha = round_to_12_digits(target.alpha);
  p.bulk_ratio = bulk_ratio(target.volumetric, p.pi4, target.name, scene.solver, reduction);
  p.depth = round_to_12_digits(target.depth / particle.radius);
  p.width = round_to_12_digits(width_of(scene) / particle.radius);
  p.bottom = target.bottom;
  p.geometry = scene.geometry;
  p.particle = reduced_particle(scene, p.density_ratio);
  p.friction = reduced_friction(scene);
  p.below = layers_below(scene, stress, reduction);
  p.erosion = std::visit(ReducedErosion{stress}, erosion_in_force(scene));
  p.further_erosion = reduced_further(target.further_erosion, stress);
  p.erosion_average = reduced_average(scene, reduction);
  p.stretch = round_to_12_digits(target.stretch);
  p.stretch_across = reduced_stretch(target.stretch_across);
  p.fibres = reduced_fibres(target.fibres, stress);
  need_whole_layers(scene, p);
  p.relaxation = reduced_relaxation(scene);
  take_mesh(scene, p);
  take_solver(scene, p);
  if (scene.output.history) p.history_samples = usual_history_samples;
  p.channel = scene.output.channel;
  p.half_speed_depth = scene.output.half_speed_depth;
  p.until = scene.output.after;

  reduction.bulk_modulus = p.bulk_ratio * reduction.mu_true;
  reduction.mach = mach_number(p);
  reduction.bulk_was_chosen = std::holds_alternative<ChooseBulk>(target.volumetric);
  reduction.left_out = list_what_is_left_out(scene, p);
  if (scene.solver.contact_stiffness_was_given) reduction.warnings.emplace_back(contact_stiffness_warning);
  warn_of_the_particle(scene, reduction);
  warn_of_the_mach_number(reduction);
  reduction.mesh = mesh_choice(scene, p);
  for (std::string& warning : mesh_warnings(scene, p)) reduction.warnings.push_back(std::move(warning));
  return reduction;
}

double Problem::whole_depth() const {
  double sum = depth;
  for (const LowerLayer& layer : below) sum += layer.depth;
  return sum;
}

std::vector<double> Problem::lower_faces() const {
  std::vector<double> faces{depth};
  for (const LowerLayer& layer : below) faces.push_back(faces.back() + layer.depth);
  return faces;
}

double computed_share(const Problem& problem) {
  return (problem.whole ? 1 : 0.5) * (problem.block.whole_across ? 1 : 0.5);
}

double friction_coefficient(const Problem& problem) {
  const auto* coulomb = std::get_if<CoulombFriction>(&problem.friction);
  return coulomb ? coulomb->coefficient : 0;
}

int rates_of(const Problem& problem) { return std::holds_alternative<NoErosion>(problem.erosion) ? 1 : problem.rates; }

double mach_number(const Problem& problem) {
  double largest = std::sqrt(problem.pi4 / (problem.bulk_ratio + 4.0 / 3));
  for (const LowerLayer& layer : problem.below)
    largest = std::max(largest, std::sqrt(layer.density / layer.mu / (layer.bulk_ratio + 4.0 / 3)));
  return largest;
}

double subsonic_bulk_ratio(double pi4) { return 1.01 * pi4 / (recommended_mach * recommended_mach) - 4.0 / 3; }

double round_to_12_digits(double x) { return std::strtod(fmt::format("{:.11e}", x).c_str(), nullptr); }

}  // namespace percal
