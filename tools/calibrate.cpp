// percal calibrate: curves and depths together; result.json and the figures of its page in one folder.
#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "colour.hpp"
#include "commands.hpp"
#include "pages.hpp"
#include "percal/calibrate/best_scenes.hpp"
#include "percal/calibrate/calibration.hpp"
#include "percal/calibrate/job_fit.hpp"
#include "percal/calibrate/page/page.hpp"
#include "percal/calibrate/run_sizes.hpp"
#include "percal/calibrate/verdict.hpp"
#include "percal/impact/kernel/kernel.hpp"
#include "percal/page/figures.hpp"
#include "percal/text/range.hpp"
#include "percal/units/words.hpp"

namespace percal::tools {
namespace {

// "60s", "5 min", "2 h": seconds.
std::optional<double> parse_budget(const std::string& text) {
  if (text.empty()) return std::nullopt;
  const auto refuse = [&](const std::string& found) {
    throw BadInput(Place{.file = "", .line = 0, .key = "--budget"}, found,
                   "a positive time with its unit: 60s, \"5 min\", 2h");
  };
  Quantity quantity{0, dimension::none};
  try {
    quantity = parse_quantity(text);
  } catch (const std::invalid_argument& error) {
    refuse(in_quotes(text) + ": " + error.what());
  }
  if (!(quantity.dimension == dimension::time) || !contains(positive(), quantity.value)) refuse(in_quotes(text));
  return quantity.value;
}

std::string valid_words(const CalibrationJob& job, const RunSize& largest) {
  return fmt::format("a job that can be run: {} parameters, {} shots ({} fitted), {} curves, {} hypotheses; {}",
                     job.parameters.size(), job.shots.size(), used_shots(job).size(), job.curves.size(),
                     job.hypotheses.size(),
                     job.shots.empty() ? "nothing is shot" : "the largest run has " + in_words(largest));
}

}  // namespace

Exit run_calibrate(const CalibrateArguments& arguments, const Common& common) {
  CalibrationLimits limits;  // the clock starts here
  limits.budget_seconds = parse_budget(arguments.budget);
  const CalibrationJob job = read_calibration_job(arguments.job);
  const RunSize largest = largest_run(job);  // throws where it cannot be run
  if (common.check)
    return say_valid(arguments.job + ": " + valid_words(job, largest),
                     {{"command", "calibrate"}, {"job", arguments.job}}, common, largest);
  const std::string folder = out_folder(arguments.job, common);
  Store store(common.store.empty() ? default_store_path() : common.store);
  Campaign campaign(&store, common.threads);
  CalibrationResult result = calibrate(job, store, campaign, limits, [&](const std::string& sentence) {
    if (!common.talks()) return;
    print(sentence + "\n");
    std::fflush(stdout);
  });
  if (common.talks()) fmt::print("\n");
  result.cost.instruction_level = instruction_level();
  const page::Json json = calibration_to_json(job, result);
  deliver(json, folder, common);
  if (!folder.empty() && !page::write_figures(calibrate_page(json), folder, page::Pictures::svg) && common.talks())
    fmt::print("figures were not drawn, since gnuplot is not there or failed; the CSV files have their points\n");
  for (const BestScene& best : best_scenes(job, result))
    write_scene(best.scene,
                "A shot of " + job.title + " at what percal calibrate found, on the mesh of its fresh runs.", best.name,
                folder);
  if (result.hypotheses.empty()) return Exit::outcome_not_reached;
  return least_contradicted(result.hypotheses) == DataAgreement::disagrees ? Exit::check_failed : Exit::done;
}

}  // namespace percal::tools
