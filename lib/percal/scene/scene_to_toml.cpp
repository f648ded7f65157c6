#include <fmt/format.h>

#include <algorithm>
#include <string_view>

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
  void word(const char* key, std::string_view value) { lines_ += fmt::format("{} = {}\n", key, text(value)); }
  void quantity(const char* key, double si_value, const char* unit) {
    lines_ += fmt::format("{} = \"{} {}\"\n", key, si_value, unit);
  }
  void number(const char* key, double value) { lines_ += fmt::format("{} = {}\n", key, value); }
  void integer(const char* key, int value) { lines_ += fmt::format("{} = {}\n", key, value); }
  void flag(const char* key, bool value) { lines_ += fmt::format("{} = {}\n", key, value); }
  const std::string& all() const { return lines_; }

 private:
  std::string lines_;
};

void write_particle(Lines& lines, const SphereScene& particle) {
  lines.table("particle");
  lines.word("shape", "sphere");
  lines.word("name", particle.name);
  lines.quantity("radius", particle.radius, "m");
  lines.quantity("density", particle.density, "kg/m3");
  lines.quantity("speed", particle.speed, "m/s");
  if (particle.youngs_modulus) lines.quantity("youngs_modulus", *particle.youngs_modulus, "Pa");
}

void write_target(Lines& lines, const LayerScene& target) {
  lines.table("target");
  lines.word("name", target.name);
  lines.quantity("density", target.density, "kg/m3");
  lines.quantity("mu", target.mu_as_given, "Pa");
  lines.word("convention", word(target.convention));
  lines.number("alpha", target.alpha);
  if (const auto* poisson = std::get_if<PoissonRatio>(&target.volumetric)) lines.number("nu", poisson->nu);
  if (const auto* bulk = std::get_if<BulkToShear>(&target.volumetric)) lines.number("bulk_to_shear", bulk->ratio);
  lines.quantity("depth", target.depth, "m");
  lines.quantity("width", target.width, "m");
  lines.word("bottom", target.bottom == Bottom::free ? "free" : "fixed");
  if (const auto* erosion = std::get_if<StrainErosion>(&target.erosion)) {
    lines.table("target.erosion");
    lines.number("strain", erosion->limit);
    lines.word("measure", word(erosion->measure));
  }
}

void write_mesh(Lines& lines, const MeshScene& mesh) {
  lines.table("mesh");
  lines.integer("elements_per_radius", mesh.elements_per_radius);
  lines.number("fine_width", mesh.fine_width);
  if (mesh.graded_columns) lines.integer("graded_columns", *mesh.graded_columns);
}

void write_solver(Lines& lines, const SolverScene& solver) {
  lines.table("solver");
  lines.number("contact_stiffness", solver.contact_stiffness);
  lines.number("hourglass", solver.hourglass);
  lines.number("linear_viscosity", solver.linear_viscosity);
  lines.number("quadratic_viscosity", solver.quadratic_viscosity);
  lines.number("time_step_factor", solver.time_step_factor);
  lines.word("arithmetic", solver.arithmetic == Arithmetic::single_precision ? "single" : "double");
  if (solver.end_time) lines.quantity("end_time", *solver.end_time, "s");
}

}  // namespace

std::string scene_to_toml(const Scene& scene, const std::string& comment) {
  Lines lines;
  lines.comment(comment);
  lines.integer("replicates", scene.replicates);
  write_particle(lines, scene.particle);
  write_target(lines, scene.target);
  write_mesh(lines, scene.mesh);
  write_solver(lines, scene.solver);
  lines.table("output");
  lines.flag("history", scene.output.history);
  return lines.all();
}

}  // namespace percal
