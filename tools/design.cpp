// percal design JOB: which particle and speed put most of a powder where it is wanted, by a finished calibration.
#include <chrono>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "pages.hpp"
#include "percal/powder/page/page.hpp"
#include "percal/text/file.hpp"

namespace percal::tools {

Exit run_design(const PowderArguments& arguments, const Common& common) {
  const auto start = std::chrono::steady_clock::now();
  const PowderJob job = read_powder_job(arguments.job);
  need_design(job);
  const NamedResult result = read_json_result(job.calibration.text);
  const ShotModel calibration = of_spheres(kept_shot_model(result.json, result.file), result.file);
  powder_model(job, calibration);  // throws where the two do not fit
  if (common.check)
    return say_valid(arguments.job + ": a job that can be run", {{"command", "design"}, {"job", arguments.job}},
                     common);
  const std::string folder = out_folder(arguments.job, common);
  DesignAnswer answer = answer_design(job, calibration);
  answer.cost.wall_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const page::Json json = design_to_json(job, answer);
  deliver(json, folder, common);
  if (!folder.empty()) write_file(folder + "/map.csv", design_to_csv(answer));
  write_page_figures(design_page(json), folder, common);
  return answer.design.best ? Exit::done : Exit::outcome_not_reached;
}

}  // namespace percal::tools
