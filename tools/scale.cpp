// percal scale JOB: the ten groups of two systems, the model's missing values, and the similar scene.

#include "pages.hpp"
#include "percal/scaling/page/page.hpp"
#include "percal/text/file.hpp"

namespace percal::tools {
namespace {

ScaleJob read_job(const ScaleArguments& arguments) {
  ScaleJob job = read_scale_job(arguments.job);
  if (!arguments.write_scene.empty()) job.output_scene = arguments.write_scene;
  check_output_scene(job);
  return job;
}

}  // namespace

Exit run_scale(const ScaleArguments& arguments, const Common& common) {
  const ScaleJob job = read_job(arguments);
  const Completion completion = complete(job.prototype.system, job.model.system);
  const std::string scene = job.output_scene.empty() ? "" : similar_scene_text(job, completion);
  if (common.check)
    return say_valid(arguments.job + ": a job that can be run", {{"command", "scale"}, {"job", arguments.job}}, common);
  const std::string folder = out_folder(arguments.job, common);
  if (!scene.empty()) write_file(job.output_scene, scene);
  deliver(scale_to_json(job, completion, job.output_scene), folder, common);
  return Exit::done;
}

}  // namespace percal::tools
