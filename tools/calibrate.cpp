// percal calibrate: curves and depths together, every reading in tables; result.json and plots in one folder.
#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "colour.hpp"
#include "commands.hpp"
#include "percal/base/progress.hpp"
#include "percal/calibrate/calibration.hpp"
#include "percal/calibrate/plots.hpp"
#include "percal/calibrate/result_json.hpp"
#include "percal/calibrate/result_text.hpp"
#include "percal/impact/kernel/kernel.hpp"
#include "percal/plot/gnuplot.hpp"
#include "percal/text/file.hpp"
#include "percal/text/range.hpp"
#include "percal/units/words.hpp"
#include "table.hpp"

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

void print(const TextTable& table) {
  if (!table.title.empty()) fmt::print("{}\n", table.title);
  if (table.rows.size() > 1) fmt::print("{}", aligned(table.rows));
  for (const std::string& note : table.notes) fmt::print("  {}\n", note);
  fmt::print("\n");
}

void print(const CalibrationJob& job, const CalibrationResult& result, ShotTables shots) {
  for (const ReadingResult& reading : result.readings) {
    fmt::print("=== {}: {}\n\n", reading.reading + 1, job.readings[reading.reading].name);
    for (const TextTable& table : reading_tables(job, result, reading, shots)) print(table);
  }
  fmt::print("=== all\n\n");
  if (result.readings.size() > 1) print(readings_side_by_side(job, result));
  if (result.dehn) print(dehn_table(job, *result.dehn));
  for (const TextTable& table : emulator_tables(result)) print(table);
  for (const std::string& finding : result.findings) fmt::print("{} {}\n", yellow("note:"), finding);
  for (const std::string& sentence : cost_sentences(result.cost)) fmt::print("{}\n", sentence);
}

// Whether all plots were drawn.
bool write_plots(const std::vector<Plot>& plots, const std::string& folder) {
  bool drawn = true;
  for (const Plot& plot : plots) {
    write_file(folder + "/" + plot.name + ".csv", plot.csv);
    if (plot.script.empty()) continue;
    if (const auto svg = gnuplot(plot.script))
      write_file(folder + "/" + plot.name + ".svg", *svg);
    else
      drawn = false;
  }
  return drawn;
}

Exit say_valid(const CalibrateArguments& arguments, const CalibrationJob& job, const Common& common) {
  int fitted = 0;
  for (const MeasuredShot& shot : job.shots) fitted += shot.used ? 1 : 0;
  if (common.json)
    fmt::print("{}\n", nlohmann::json{{"command", "calibrate"}, {"job", arguments.job}, {"valid", true}}.dump());
  else if (!common.quiet)
    fmt::print("{}: a job that can be run: {} parameters, {} shots ({} fitted), {} curves, {} readings\n",
               arguments.job, job.parameters.size(), job.shots.size(), fitted, job.curves.size(), job.readings.size());
  return Exit::done;
}

}  // namespace

Exit run_calibrate(const CalibrateArguments& arguments, const Common& common) {
  CalibrationLimits limits;  // the clock starts here
  limits.budget_seconds = parse_budget(arguments.budget);
  const CalibrationJob job = read_calibration_job(arguments.job);
  if (common.check) return say_valid(arguments, job, common);
  const std::string folder = out_folder(arguments.job, common);
  ensure_writable_folder(folder);
  Store store(common.store.empty() ? default_store_path() : common.store);
  Campaign campaign(&store, common.threads);
  const bool talk = !common.quiet && !common.json;
  if (talk) fmt::print("{}\n\n", job.title);
  CalibrationResult result = calibrate(job, store, campaign, limits, [&](const std::string& sentence) {
    if (!talk) return;
    fmt::print("{}\n", sentence);
    std::fflush(stdout);
  });
  result.cost.instruction_level = instruction_level();
  const std::string json =
      calibration_to_json(job, result).dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
  write_file(folder + "/result.json", json);
  const bool drawn = write_plots(calibration_plots(job, result), folder);
  if (common.json) fmt::print("{}", json);
  if (talk) {
    fmt::print("\n");
    print(job, result, arguments.details ? ShotTables::all : ShotTables::where_few);
    fmt::print("Results: {}{}\n", folder,
               drawn ? "" : " (plots were not drawn: no gnuplot; the CSV files have their points)");
  }
  return result.readings.empty() ? Exit::outcome_not_reached : Exit::done;
}

}  // namespace percal::tools
