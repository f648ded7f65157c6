// The text of a problem. Every part of it is read again by problem_of_key.cpp.
#include <fmt/format.h>

#include <string>
#include <vector>

#include "percal/base/version.hpp"
#include "percal/problem/problem.hpp"

namespace percal {
namespace {

// Each part of the text begins with a word of its own, and lists are in brackets, so that no two problems share a text.
// Choices are left out where they are what they are in the plainest problem.

struct ParticleText {
  std::string operator()(const RigidSphere&) const { return "sphere"; }
  std::string operator()(const ElasticSphere& sphere) const {
    return fmt::format("elastic-sphere={:.12g},{:.12g}", sphere.youngs_modulus, sphere.poisson_ratio);
  }
  std::string operator()(const RigidPolygon& profile) const {
    std::string vertices;
    for (const auto& [x, y] : profile.vertices) vertices += fmt::format("({:.12g},{:.12g})", x, y);
    std::string text = fmt::format("profile=[{}] mass={:.12g} inertia={:.12g} rotation={}", vertices, profile.mass,
                                   profile.inertia, profile.free_rotation ? "free" : "fixed");
    if (profile.half_thickness != 0) text += fmt::format(" half-thickness={:.12g}", profile.half_thickness);
    return text;
  }
  std::string operator()(const RigidPolyhedron& body) const {
    std::string vertices;
    for (const auto& [x, y, z] : body.vertices) vertices += fmt::format("({:.12g},{:.12g},{:.12g})", x, y, z);
    return fmt::format("polyhedron=[{}] mass={:.12g} rotation={}", vertices, body.mass,
                       body.free_rotation ? "free" : "fixed");
  }
};

struct ErosionText {
  std::string operator()(const NoErosion&) const { return "none"; }
  std::string operator()(const StrainErosion& erosion) const {
    return fmt::format("{}:{:.12g}", word(erosion.measure), erosion.limit);
  }
  std::string operator()(const StressErosion& erosion) const { return fmt::format("stress:{:.12g}", erosion.limit); }
  std::string operator()(const EnergyErosion& erosion) const { return fmt::format("energy:{:.12g}", erosion.limit); }
};

std::string below_text(const std::vector<LowerLayer>& below) {
  if (below.empty()) return "";
  std::string layers;
  for (const LowerLayer& layer : below)
    layers += fmt::format("({:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g})", layer.depth, layer.density, layer.mu,
                          layer.alpha, layer.bulk_ratio, layer.erosion_limit);
  return " below=[" + layers + "]";
}

std::string limits_text(const FurtherErosion& further) {
  std::string text;
  if (further.stress) text += fmt::format("stress:{:.12g};", *further.stress);
  if (further.energy) text += fmt::format("energy:{:.12g};", *further.energy);
  return text;
}

std::string further_erosion_text(const Problem& p) {
  if (p.further_erosion.is_empty()) return "";
  std::string text = " further-erosion=[" + limits_text(p.further_erosion);
  for (const LowerLayer& layer : p.below) text += "(" + limits_text(layer.further_erosion) + ")";
  return text + "]";
}

// Of all layers, where one is stretched.
std::string stretch_text(const Problem& p) {
  std::string text = fmt::format("{:.12g}", p.stretch);
  bool stretched = p.stretch != 1;
  for (const LowerLayer& layer : p.below) {
    text += fmt::format(",{:.12g}", layer.stretch);
    stretched |= layer.stretch != 1;
  }
  return stretched ? " stretch=[" + text + "]" : "";
}

// The same across, where one has a stretch of its own there.
std::string across_text(const Problem& p) {
  const auto one = [](const std::optional<double>& across) { return across ? fmt::format("{:.12g}", *across) : "-"; };
  std::string text = one(p.stretch_across);
  bool some = p.stretch_across.has_value();
  for (const LowerLayer& layer : p.below) {
    text += "," + one(layer.stretch_across);
    some |= layer.stretch_across.has_value();
  }
  return some ? " across=[" + text + "]" : "";
}

std::string fibre_text(const Fibres& fibres) {
  if (const auto* families = std::get_if<FibreFamilies>(&fibres))
    return fmt::format("({:.12g},{:.12g},{:.12g},{:.12g})", families->k1, families->k2, families->kappa,
                       families->angle);
  const auto* planar = std::get_if<PlanarFibres>(&fibres);
  return planar ? fmt::format("({:.12g},{:.12g},{:.12g})", planar->k1, planar->k2, planar->kappa) : "()";
}

// Of all layers, where one has fibres.
std::string fibres_text(const Problem& p) {
  std::string text = fibre_text(p.fibres);
  bool some = !std::holds_alternative<NoFibres>(p.fibres);
  for (const LowerLayer& layer : p.below) {
    text += fibre_text(layer.fibres);
    some |= !std::holds_alternative<NoFibres>(layer.fibres);
  }
  return some ? " fibres=[" + text + "]" : "";
}

std::string relaxation_text(const Relaxation& relaxation) {
  const auto* series = std::get_if<PronySeries>(&relaxation);
  if (!series) return "";
  std::string terms;
  for (const PronyTerm& term : series->terms) terms += fmt::format("({:.12g},{:.12g})", term.share, term.time);
  return " relaxation=[" + terms + "]";
}

std::string choices_text(const Problem& p) {
  std::string text;
  if (p.geometry == Geometry::plane_strain) text += " plane-strain";
  if (p.geometry == Geometry::block)
    text += fmt::format(" block={:.12g},{:.12g},{:.12g},{:.12g}", p.block.fine_thickness, p.block.fine_depth,
                        p.block.growth, p.block.angle);
  if (p.whole) text += " whole";
  if (p.block.whole_across) text += " whole-across";
  if (p.hourglass_form == HourglassForm::viscosity) text += " hourglass-viscosity";
  if (p.volumetric_law == VolumetricLaw::quadratic) text += " volumetric=quadratic";
  if (p.volumetric_law == VolumetricLaw::logarithmic) text += " volumetric=logarithmic";
  if (p.eroded_nodes == ErodedNodes::in_contact) text += " eroded-nodes-in-contact";
  if (const auto* average = std::get_if<AverageWithin>(&p.erosion_average))
    text += fmt::format(" length={:.12g}", average->length);
  if (const double coefficient = friction_coefficient(p); coefficient > 0)
    text += fmt::format(" friction={:.12g}", coefficient);
  if (p.rates != 2) text += fmt::format(" rates={}", p.rates);
  if (p.until == RunUntil::passage) text += " until-passage";
  if (p.until == RunUntil::rest) text += " until-rest";
  return text;
}

// Blocks have a solver of their own, whose version leaves the others' evaluations what they are.
std::string solver_text(const Problem& p) {
  return p.geometry == Geometry::block ? fmt::format("solid-{}", solid_version) : fmt::format("{}", solver_version);
}

}  // namespace

std::string sphere_key_prefix(const std::string& instruction_level) {
  return fmt::format("{} solver={} level={} ", ParticleText{}(RigidSphere{}), solver_version, instruction_level);
}

std::string evaluation_key(const Problem& p, const std::string& instruction_level) {
  return fmt::format(
             "{} solver={} level={} arithmetic={} pi4={:.12g} density_ratio={:.12g} alpha={:.12g} bulk_ratio={:.12g} "
             "depth={:.12g} width={:.12g} bottom={} erosion={} mesh={:.12g},{:.12g},{} hourglass={:.12g} "
             "viscosity={:.12g},{:.12g} step={:.12g} end={:.12g} speed={:.12g}",
             std::visit(ParticleText{}, p.particle), solver_text(p), instruction_level,
             p.arithmetic == Arithmetic::single_precision ? "single" : "double", p.pi4, p.density_ratio, p.alpha,
             p.bulk_ratio, p.depth, p.width, p.bottom == Bottom::free ? "free" : "fixed",
             std::visit(ErosionText{}, p.erosion), p.elements_per_radius, p.fine_width, p.graded_columns, p.hourglass,
             p.linear_viscosity, p.quadratic_viscosity, p.time_step_factor, p.end_time, p.speed_factor) +
         choices_text(p) + below_text(p.below) + further_erosion_text(p) + stretch_text(p) + across_text(p) +
         fibres_text(p) + relaxation_text(p.relaxation);
}

}  // namespace percal
