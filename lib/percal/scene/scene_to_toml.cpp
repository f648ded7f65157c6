#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "percal/math/polygon.hpp"
#include "percal/math/polyhedron.hpp"
#include "percal/scene/erosion_length.hpp"
#include "percal/scene/read_scene.hpp"
#include "percal/scene/scene_toml.hpp"

namespace percal {
namespace {

// A basic string of TOML.
std::string text(std::string_view value) {
  std::string result = "\"";
  for (const char c : value) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') result += '\\';
    if (code < 0x20 || code == 0x7f)
      result += fmt::format("\\u{:04x}", code);
    else
      result += c;
  }
  return result + '"';
}

// Lines of one table. fmt prints a double as the shortest decimal that reads back as the same bits.
class Lines {
 public:
  void comment(std::string_view text) {
    while (!text.empty()) {
      const std::string_view line = text.substr(0, text.find('\n'));
      text.remove_prefix(std::min(line.size() + 1, text.size()));
      std::string shown;
      for (const char c : line) shown += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? ' ' : c;
      lines_ += fmt::format("#{}{}\n", shown.empty() ? "" : " ", shown);
    }
  }
  void table(const char* name) { lines_ += fmt::format("{}[{}]\n", lines_.empty() ? "" : "\n", name); }
  void element(const char* name) { lines_ += fmt::format("\n[[{}]]\n", name); }
  void word(const char* key, std::string_view value) { lines_ += fmt::format("{} = {}\n", key, text(value)); }
  void quantity(const char* key, double si_value, const char* unit) {
    lines_ += fmt::format("{} = \"{} {}\"\n", key, si_value, unit);
  }
  void number(const char* key, double value) { lines_ += fmt::format("{} = {}\n", key, value); }
  template <class Choice>
  void choice(const char* key, const std::vector<std::string>& words, Choice chosen) {
    word(key, words.at(static_cast<std::size_t>(chosen)));
  }
  void pairs(const char* key, const Polygon& points, const char* unit) {
    std::vector<std::string> written;
    for (const auto& [x, y] : points) written.push_back(fmt::format("[\"{0} {2}\", \"{1} {2}\"]", x, y, unit));
    lines_ += fmt::format("{} = [{}]\n", key, fmt::join(written, ", "));
  }
  void triples(const char* key, const Vertices& points, const char* unit) {
    std::vector<std::string> written;
    for (const auto& [x, y, z] : points)
      written.push_back(fmt::format("[\"{0} {3}\", \"{1} {3}\", \"{2} {3}\"]", x, y, z, unit));
    lines_ += fmt::format("{} = [{}]\n", key, fmt::join(written, ", "));
  }
  void integer(const char* key, int value) { lines_ += fmt::format("{} = {}\n", key, value); }
  void flag(const char* key, bool value) { lines_ += fmt::format("{} = {}\n", key, value); }
  const std::string& all() const { return lines_; }

 private:
  std::string lines_;
};

void write_profile(Lines& lines, const ParticleScene& particle, const ProfileShape& profile, Geometry geometry) {
  lines.word("shape", "profile");
  lines.word("name", particle.name);
  lines.pairs("vertices", profile.vertices, "m");
  lines.quantity("orientation", profile.orientation, "rad");
  lines.word("rotation", profile.free_rotation ? "free" : "fixed");
  if (geometry == Geometry::block) lines.quantity("thickness", profile.thickness, "m");
  if (!profile.mass) {
    lines.quantity("density", particle.density, "kg/m3");
    return;
  }
  lines.quantity("mass", *profile.mass * (geometry == Geometry::block ? profile.thickness : 1), "kg");
  if (geometry == Geometry::plane_strain) lines.quantity("thickness", 1, "m");
}

void write_polyhedron(Lines& lines, const ParticleScene& particle, const PolyhedronShape& body) {
  lines.word("shape", "polyhedron");
  lines.word("name", particle.name);
  lines.triples("vertices", body.vertices, "m");
  lines.quantity("orientation", body.orientation, "rad");
  lines.word("rotation", body.free_rotation ? "free" : "fixed");
  if (body.mass)
    lines.quantity("mass", *body.mass, "kg");
  else
    lines.quantity("density", particle.density, "kg/m3");
}

void write_particle(Lines& lines, const ParticleScene& particle, Geometry geometry) {
  lines.table("particle");
  if (const auto* profile = std::get_if<ProfileShape>(&particle.shape)) {
    write_profile(lines, particle, *profile, geometry);
  } else if (const auto* body = std::get_if<PolyhedronShape>(&particle.shape)) {
    write_polyhedron(lines, particle, *body);
  } else {
    lines.word("shape", geometry == Geometry::plane_strain ? "cylinder" : "sphere");
    lines.word("name", particle.name);
    lines.quantity("radius", particle.radius, "m");
    lines.quantity("density", particle.density, "kg/m3");
  }
  lines.quantity("speed", particle.speed, "m/s");
  if (particle.angle != 0) lines.quantity("angle", particle.angle, "rad");
  if (particle.youngs_modulus) lines.quantity("youngs_modulus", *particle.youngs_modulus, "Pa");
  lines.number("poisson_ratio", particle.poisson_ratio);
  lines.choice("elasticity", elasticity_words(), particle.elasticity);
  if (const auto* coulomb = std::get_if<CoulombFriction>(&particle.friction))
    lines.number("friction", coulomb->coefficient);
}

void write_volumetric(Lines& lines, const VolumetricChoice& volumetric) {
  if (const auto* poisson = std::get_if<PoissonRatio>(&volumetric)) lines.number("nu", poisson->nu);
  if (const auto* bulk = std::get_if<BulkToShear>(&volumetric)) lines.number("bulk_to_shear", bulk->ratio);
}

void write_fibres(Lines& lines, const char* table, const Fibres& fibres) {
  if (const auto* families = std::get_if<FibreFamilies>(&fibres)) {
    lines.table(table);
    lines.quantity("k1", families->k1, "Pa");
    lines.number("k2", families->k2);
    lines.number("kappa", families->kappa);
    lines.quantity("angle", families->angle, "rad");
  }
  const auto* planar = std::get_if<PlanarFibres>(&fibres);
  if (!planar) return;
  lines.table(table);
  lines.quantity("k1", planar->k1, "Pa");
  lines.number("k2", planar->k2);
  lines.number("kappa", planar->kappa);
}

// One line of an erosion table, in the unit that the criterion has.
struct WriteLimit {
  Lines& lines;
  double limit;
  void operator()(const NoErosion&) const {}
  void operator()(const StrainErosion&) const { lines.number("strain", limit); }
  void operator()(const StressErosion&) const { lines.quantity("stress", limit, "Pa"); }
  void operator()(const EnergyErosion&) const { lines.quantity("energy", limit, "J/m3"); }
};

void write_further(Lines& lines, const FurtherErosion& further) {
  if (further.stress) lines.quantity("stress", *further.stress, "Pa");
  if (further.energy) lines.quantity("energy", *further.energy, "J/m3");
}

void write_by_size(Lines& lines, const ErosionBySize& by_size) {
  const auto* small = std::get_if<SmallerThanCell>(&by_size);
  if (!small) return;
  lines.number("strain_below", small->strain);
  lines.quantity("cell", small->cell, "m");
}

struct LimitOf {
  double operator()(const NoErosion&) const { return 0; }
  template <class Criterion>
  double operator()(const Criterion& criterion) const {
    return criterion.limit;
  }
};

void write_target(Lines& lines, const LayerScene& target) {
  lines.table("target");
  lines.word("name", target.name);
  lines.quantity("density", target.density, "kg/m3");
  lines.quantity("mu", target.mu_as_given, "Pa");
  lines.word("convention", word(target.convention));
  lines.number("alpha", target.alpha);
  write_volumetric(lines, target.volumetric);
  lines.quantity("depth", target.depth, "m");
  if (target.width) lines.quantity("width", *target.width, "m");
  if (target.stretch != 1) lines.number("stretch", target.stretch);
  if (target.stretch_across) lines.number("stretch_across", *target.stretch_across);
  lines.word("bottom", target.bottom == Bottom::free ? "free" : "fixed");
  write_fibres(lines, "target.fibres", target.fibres);
  if (!std::holds_alternative<NoErosion>(target.erosion)) {
    lines.table("target.erosion");
    std::visit(WriteLimit{lines, std::visit(LimitOf{}, target.erosion)}, target.erosion);
    if (const auto* strain = std::get_if<StrainErosion>(&target.erosion)) lines.word("measure", word(strain->measure));
    write_further(lines, target.further_erosion);
    write_by_size(lines, target.erosion_by_size);
    if (const auto length = erosion_length(target)) lines.quantity("length", *length, "m");
  }
  if (const auto* series = std::get_if<PronySeries>(&target.relaxation)) {
    for (const PronyTerm& term : series->terms) {
      lines.element("target.relaxation");
      lines.number("share", term.share);
      lines.quantity("time", term.time, "s");
    }
  }
}

void write_below(Lines& lines, const std::vector<LowerLayerScene>& below, const Erosion& erosion) {
  for (const LowerLayerScene& layer : below) {
    lines.element("below");
    lines.word("name", layer.name);
    lines.quantity("density", layer.density, "kg/m3");
    lines.quantity("mu", layer.mu_as_given, "Pa");
    lines.number("alpha", layer.alpha);
    write_volumetric(lines, layer.volumetric);
    lines.quantity("depth", layer.depth, "m");
    if (layer.stretch != 1) lines.number("stretch", layer.stretch);
    if (layer.stretch_across) lines.number("stretch_across", *layer.stretch_across);
    write_fibres(lines, "below.fibres", layer.fibres);
    if (!layer.erosion_limit && layer.further_erosion.is_empty()) continue;
    lines.table("below.erosion");
    if (layer.erosion_limit) std::visit(WriteLimit{lines, *layer.erosion_limit}, erosion);
    write_further(lines, layer.further_erosion);
    write_by_size(lines, layer.erosion_by_size);
  }
}

void write_mesh(Lines& lines, const MeshScene& mesh, Geometry geometry) {
  lines.table("mesh");
  lines.number("elements_per_radius", mesh.elements_per_radius);
  lines.number("fine_width", mesh.fine_width);
  if (mesh.graded_columns) lines.integer("graded_columns", *mesh.graded_columns);
  lines.flag("whole", mesh.whole);
  if (geometry != Geometry::block) return;
  lines.number("fine_thickness", mesh.fine_thickness);
  if (mesh.fine_depth) lines.number("fine_depth", *mesh.fine_depth);
  lines.number("growth", mesh.growth);
  lines.flag("whole_across", mesh.whole_across);
}

void write_solver(Lines& lines, const SolverScene& solver) {
  lines.table("solver");
  lines.number("hourglass", solver.hourglass);
  lines.choice("hourglass_form", hourglass_words(), solver.hourglass_form);
  lines.choice("volumetric_law", volumetric_words(), solver.volumetric_law);
  lines.choice("eroded_nodes", eroded_node_words(), solver.eroded_nodes);
  lines.number("linear_viscosity", solver.linear_viscosity);
  lines.number("quadratic_viscosity", solver.quadratic_viscosity);
  lines.number("time_step_factor", solver.time_step_factor);
  lines.integer("rates", solver.rates);
  lines.flag("stiffen_supersonic", solver.stiffen_supersonic);
  lines.word("arithmetic", solver.arithmetic == Arithmetic::single_precision ? "single" : "double");
  if (solver.end_time) lines.quantity("end_time", *solver.end_time, "s");
}

}  // namespace

std::string scene_to_toml(const Scene& scene, const std::string& comment) {
  Lines lines;
  lines.comment(comment);
  lines.choice("geometry", geometry_words(), scene.geometry);
  lines.integer("replicates", scene.replicates);
  write_particle(lines, scene.particle, scene.geometry);
  write_target(lines, scene.target);
  write_below(lines, scene.below, scene.target.erosion);
  write_mesh(lines, scene.mesh, scene.geometry);
  write_solver(lines, scene.solver);
  lines.table("output");
  lines.flag("history", scene.output.history);
  lines.choice("after", run_until_words(), scene.output.after);
  lines.flag("channel", scene.output.channel);
  return lines.all();
}

}  // namespace percal
