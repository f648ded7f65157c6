// percal calibrate: curves and depths together; result.json and the figures of its page in one folder.
#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "cluster.hpp"
#include "colour.hpp"
#include "commands.hpp"
#include "pages.hpp"
#include "percal/calibrate/best_scenes.hpp"
#include "percal/calibrate/calibration.hpp"
#include "percal/calibrate/job_fit.hpp"
#include "percal/calibrate/page/page.hpp"
#include "percal/calibrate/run_sizes.hpp"
#include "percal/calibrate/verdict.hpp"
#include "percal/math/instruction_level.hpp"
#include "percal/text/one_value.hpp"

namespace percal::tools {
namespace {

std::string valid_words(const CalibrationJob& job, const RunSize& largest) {
  return fmt::format("a job that can be run: {} parameters, {} shots ({} fitted), {} curves, {} hypotheses; {}",
                     job.parameters.size(), job.shots.size(), used_shots(job).size(), job.curves.size(),
                     job.hypotheses.size(),
                     job.shots.empty() ? "nothing is shot" : "the largest run has " + in_words(largest));
}

}  // namespace

Exit run_calibrate(const CalibrateArguments& arguments, const Common& common) {
  CalibrationLimits limits;  // the clock starts here
  limits.budget_seconds = optional_quantity(arguments.budget, "--budget", dimension::time, positive("time"));
  const CalibrationJob job = read_calibration_job(arguments.job);
  const RunSize largest = largest_run(job);  // throws where it cannot be run
  if (common.check)
    return say_valid(arguments.job + ": " + valid_words(job, largest),
                     {{"command", "calibrate"}, {"job", arguments.job}}, common, largest);
  const std::string folder = out_folder(arguments.job, common);
  Runs runs(common, arguments.job);
  CalibrationResult result = calibrate(job, runs.store, runs.campaign, limits, [&](const std::string& sentence) {
    if (!common.talks()) return;
    print(sentence + "\n");
    std::fflush(stdout);
  });
  if (common.talks()) fmt::print("\n");
  result.cost.instruction_level = instruction_level();
  const page::Json json = calibration_to_json(job, result);
  deliver(json, folder, common);
  write_page_figures(calibrate_page(json), folder, common);
  for (const BestScene& best : best_scenes(job, result))
    write_scene(best.scene,
                "A shot of " + job.title + " at what percal calibrate found, on the mesh of its fresh runs.", best.name,
                folder);
  if (result.hypotheses.empty()) return Exit::outcome_not_reached;
  return least_contradicted(result.hypotheses) == DataAgreement::disagrees ? Exit::check_failed : Exit::done;
}

}  // namespace percal::tools
