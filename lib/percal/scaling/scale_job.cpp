#include "percal/scaling/scale_job.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "percal/scaling/similar_scene.hpp"
#include "percal/scene/document_kind.hpp"
#include "percal/scene/scene_toml.hpp"
#include "percal/text/file.hpp"
#include "percal/text/toml.hpp"

namespace percal {
namespace {

SystemInput read_side(const TomlTable& table, const SystemInput& otherwise, std::optional<Scene>& scene) {
  auto path = table.optional_path("scene");
  if (!path) return read_system(table, otherwise);
  scene = read_scene(*path);
  auto input = system_of(*scene);
  read_response(table, input.system);
  return input;
}

ScaleJob job_from(const TomlTable& root) {
  ScaleJob job;
  job.tolerance = root.number("tolerance", not_negative("tolerance of a group's agreement"), default_tolerance);
  job.prototype = read_side(root.table("prototype"), {}, job.prototype_scene);
  std::optional<Scene> model_scene;
  job.model = read_side(root.table("model"), job.prototype, model_scene);
  if (auto output = root.optional_table("output")) job.output_scene = output->path("scene");
  root.finish();
  return job;
}

}  // namespace

ScaleJob parse_scale_job(const std::string& text, const std::string& name) {
  const TomlTable root = parse_toml(text, name);
  need_kind(root, DocumentKind::scale);
  ScaleJob job = job_from(root);
  job.file = name;
  job.text = text;
  return job;
}

ScaleJob read_scale_job(const std::string& path) {
  return parse_scale_job(read_file(path), path);
}

void check_output_scene(const ScaleJob& job) {
  if (job.output_scene.empty()) return;
  if (!job.prototype_scene)
    throw BadInput({job.file, 0, "prototype.scene"}, "no scene to scale",
                   "prototype.scene = \"FILE.toml\" where a similar scene is to be written");
  if (job.model.system.erosion_strain && !job.prototype.system.erosion_strain)
    throw BadInput({job.file, 0, "model.erosion_strain"},
                   "an erosion strain where the prototype's scene has no erosion", "none, or a prototype with erosion");
}

std::string similar_scene_text(const ScaleJob& job, const Completion& completion) {
  require_similar(completion, job.file);
  const std::string comment = fmt::format(
      "{} made similar to {} ({}).\n"
      "Written by percal scale; every group that decides the run is equal in both, so both are one dimensionless "
      "problem.",
      title(completion.model), title(job.prototype.system),
      std::filesystem::path(job.prototype_scene->source).filename().string());
  return scene_to_toml(similar_scene(*job.prototype_scene, job.prototype.system, completion.model), comment);
}

}  // namespace percal
