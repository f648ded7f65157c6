// [shots.body]: prisms and polyhedra that were shot in place of spheres.     docs/formats/calibrate.md
#include <algorithm>
#include <cmath>

#include "percal/calibrate/job/read_job.hpp"
#include "percal/scene/block_toml.hpp"
#include "percal/scene/profile.hpp"
#include "percal/scene/read_scene.hpp"
#include "percal/scene/scene_toml.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

// Of the deepest measured depth: so deep are the cubes of a block.
constexpr double cubes_to = 1.2;

bool is_other_than_0(const MaterialNumber& number) {
  return std::holds_alternative<SharedParameter>(number) || std::get<double>(number) != 0;
}

// What the runs of blocks, or the emulators of their depths, do not have.
void refuse_what_bodies_lack(const TomlTable& block, const CalibrationJob& job, const CalibrationTarget& target) {
  const CalibrationMaterial& material = job.materials[target.material];
  const auto refuse_if = [&](bool has, const std::string& what) {
    if (has) block.refuse("body", "this into " + target.name + ", which has " + what, "spheres, or a material without");
  };
  refuse_if(!target.covers.empty(), "layers on top");
  refuse_if(material.erosion_length.has_value(), "an erosion length");
  refuse_if(!material.relaxation.empty(), "relaxation");
  refuse_if(is_other_than_0(material.rate_exponent), "a rate_exponent");
  refuse_if(is_other_than_0(material.size_exponent), "a size_exponent");
  refuse_if(material.cell > 0, "a cell");
}

Scene scene_of_body(const TomlTable& table) {
  Scene scene;
  scene.geometry = Geometry::block;
  if (!table.has("shape")) table.refuse("shape", "no such key", "\"rhombus\", \"profile\" or \"polyhedron\"");
  scene.particle = body_from(table, scene.geometry);
  if (std::holds_alternative<RoundShape>(scene.particle.shape))
    table.refuse("shape", "\"sphere\"",
                 "a prism or a polyhedron; of spheres the block has particle_density and radius");
  scene.particle.density = particle_density(scene);
  if (auto* prism = std::get_if<ProfileShape>(&scene.particle.shape)) prism->mass.reset();
  if (auto* solid = std::get_if<PolyhedronShape>(&scene.particle.shape)) solid->mass.reset();
  scene.mesh = usual_mesh(scene);
  scene.mesh.whole = needs_both_halves(scene.particle);
  scene.mesh.whole_across = needs_both_sides_across(scene.particle);
  scene.solver = usual_solver(scene.geometry);
  return scene;
}

}  // namespace

std::shared_ptr<const ShotBody> body_of_block(const TomlTable& block, CalibrationJob& job) {
  block.knows("body");
  const auto table = block.optional_table("body");
  if (!table) return nullptr;
  for (const char* key : {"particle", "particle_column", "particle_density", "particle_density_column", "particle_mass",
                          "particle_mass_column", "particle_sectional_density", "particle_sectional_density_column",
                          "radius", "radius_column", "diameter", "diameter_column"})
    if (block.has(key))
      block.refuse(key, "this beside [shots.body]", "the size, mass and name of the body in [shots.body]");
  const Scene scene = scene_of_body(*table);
  for (const auto& known : job.bodies) {
    if (known->scene == scene) return known;
    if (known->name() == scene.particle.name)
      table->refuse("name", in_quotes(known->name()) + " again, of another body", "a name of its own");
  }
  job.bodies.push_back(std::make_shared<ShotBody>(ShotBody{static_cast<int>(job.bodies.size()) + 1, scene}));
  return job.bodies.back();
}

void check_body(const TomlTable& block, const CalibrationJob& job, const MeasuredShot& shot) {
  refuse_what_bodies_lack(block, job, job.targets[shot.target]);
  if (shot.number != RunNumber::depth || is_of_passage(shot.datum))
    block.refuse("body", "this beside " + seen_words(shot) + " of the shot " + in_quotes(shot.label),
                 "depths, or bounds of depths, of what is no sphere");
}

void settle_bodies(const TomlTable& root, CalibrationJob& job) {
  if (learns_passage(job))
    for (const TomlTable& block : root.tables("shots"))
      if (block.has("body"))
        block.refuse("body", "this in a job that learns passing, by its shots or by training.passage",
                     "spheres alone there");
  for (auto& body : job.bodies) {
    double deepest = 0;
    for (const MeasuredShot& shot : job.shots)
      if (shot.body == body && shot.datum != ShotDatum::none) deepest = std::max(deepest, shot.depth / shot.radius);
    ShotBody settled = *body;
    if (deepest > 0) settled.scene.mesh.fine_depth = cubes_to * deepest;
    const auto before = body;
    body = std::make_shared<const ShotBody>(std::move(settled));
    for (MeasuredShot& shot : job.shots)
      if (shot.body == before) shot.body = body;
  }
}

}  // namespace percal
