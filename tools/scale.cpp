// percal scale JOB: the ten groups of two systems, the model's missing values, and the similar scene.
#include <filesystem>

#include "pages.hpp"
#include "percal/scaling/page/page.hpp"
#include "percal/scene/scene_toml.hpp"
#include "percal/text/file.hpp"
#include "percal/units/words.hpp"

namespace percal::tools {
namespace {

namespace fs = std::filesystem;

fs::path without_links(const fs::path& path) {
  std::error_code error;
  const fs::path found = fs::weakly_canonical(fs::absolute(path, error), error);
  return error ? path.lexically_normal() : found;
}

bool is_within(const fs::path& path, const fs::path& folder) {
  const fs::path beyond = without_links(path).lexically_relative(without_links(folder));
  return !beyond.empty() && *beyond.begin() != "..";
}

bool is_scene(const std::string& file) {
  try {
    parse_scene(read_output(file), file);
    return true;
  } catch (const BadInput&) {
    return false;
  }
}

// A job may come from anybody: what it says may write a scene beside itself or with the results, over no other kind of file.
void check_place_of_scene(const ScaleJob& job, const std::string& result_folder) {
  const fs::path beside = fs::path(job.file).parent_path();
  const Place place{job.file, 0, "output.scene"};
  const bool is_beside = is_within(job.output_scene, beside.empty() ? "." : beside);
  if (!is_beside && (result_folder.empty() || !is_within(job.output_scene, result_folder)))
    throw BadInput(place, in_quotes(job.output_scene),
                   "a file in the job's folder or in that of the results; --write-scene for another one");
  std::error_code no_matter;
  if (fs::exists(job.output_scene, no_matter) && !is_scene(job.output_scene))
    throw BadInput(place, in_quotes(job.output_scene) + ", which is there and is no scene",
                   "the name of a new file, or of a scene to be replaced");
}

ScaleJob read_job(const ScaleArguments& arguments, const Common& common) {
  ScaleJob job = read_scale_job(arguments.job);
  if (!arguments.write_scene.empty())
    job.output_scene = arguments.write_scene;
  else if (!job.output_scene.empty())
    check_place_of_scene(job, folder_named(arguments.job, common));
  check_output_scene(job);
  return job;
}

}  // namespace

Exit run_scale(const ScaleArguments& arguments, const Common& common) {
  const ScaleJob job = read_job(arguments, common);
  const Completion completion = complete(job.prototype.system, job.model.system);
  const std::string scene = job.output_scene.empty() ? "" : similar_scene_text(job, completion);
  if (common.check)
    return say_valid(arguments.job + ": a job that can be run", {{"command", "scale"}, {"job", arguments.job}}, common);
  if (!scene.empty()) ensure_writable_file(job.output_scene);
  const std::string folder = out_folder(arguments.job, common);
  if (!scene.empty()) write_file(job.output_scene, scene);
  deliver(scale_to_json(job, completion, job.output_scene), folder, common);
  return Exit::done;
}

}  // namespace percal::tools
