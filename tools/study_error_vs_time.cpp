// percal study SCENE --error-vs-time: the ladder, its table, the advice; CSV, SVG and JSON in the folder of results.
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "pages.hpp"
#include "percal/base/progress.hpp"
#include "percal/base/version.hpp"
#include "percal/impact/kernel/kernel.hpp"
#include "percal/plot/gnuplot.hpp"
#include "percal/scene/scene_toml.hpp"
#include "percal/study/advice.hpp"
#include "percal/study/error_plot.hpp"
#include "percal/study/kept_ladder.hpp"
#include "percal/study/study_json.hpp"
#include "percal/text/file.hpp"
#include "percal/units/quantity.hpp"
#include "studies.hpp"

namespace percal::tools {
namespace {

using Json = nlohmann::json;

struct Findings {
  const Scene& scene;
  const Ladder& ladder;
  const ErrorVsTime& study;
  std::vector<AdvisedSetting> advice;
  CampaignCost cost;
  double wall_seconds;
};

std::string length(double metres) { return format_quantity(metres, dimension::length); }
std::string length(const std::optional<double>& metres) { return metres ? length(*metres) : "-"; }
std::string percent(double share) { return fmt::format("{:.2g} %", 100 * share); }
std::string signed_percent(double share) { return fmt::format("{:+.2f} %", 100 * share); }
std::string seconds(double value) { return fmt::format("{:.3g} s", value); }

std::vector<std::string> row_of(const Rung& rung, const RungError* error) {
  const auto& p = rung.penetration;
  std::vector<std::string> row{fmt::format("{}", rung.elements_per_radius),
                               fmt::format("{}", rung.elements),
                               fmt::format("{:.3g}", rung.time_step_factor),
                               rung.arithmetic == Arithmetic::single_precision ? "single" : "double",
                               p.depth ? length(*p.depth) : word(p.outcome),
                               length(p.spread),
                               length(p.standard_error)};
  if (error) {
    const auto& e = error->signed_error;
    row.push_back(signed_percent(e.value));
    row.push_back(fmt::format("{:+.1f} to {}", 100 * e.low,
                              std::isfinite(e.high) ? fmt::format("{:+.1f}", 100 * e.high) : "no bound"));
    for (const ErrorBand& mean : error->combined) row.push_back(percent(mean.value));
  } else {
    row.resize(row.size() + 2 + replicate_counts.size(), "-");
  }
  row.push_back(fmt::format("{:.0f}", rung.steps));
  row.push_back(fmt::format("{:.3g}", rung.element_steps));
  row.push_back(fmt::format("{:.3g}", rung.cpu_seconds));
  return row;
}

void print_table(const Ladder& ladder, const ErrorVsTime& study) {
  std::vector<std::string> header{"n",      "elements",  "step",  "arithmetic", "depth",
                                  "spread", "st. error", "error", "interval, %"};
  for (const int count : replicate_counts) header.push_back(count == 1 ? "one run" : fmt::format("mean of {}", count));
  header.insert(header.end(), {"steps", "element-steps", "CPU s a run"});
  std::vector<std::vector<std::string>> rows{header};
  for (std::size_t i = 0; i < ladder.meshes.size(); ++i) {
    const bool has_error = !study.errors.empty() && i >= study.first_used;
    rows.push_back(row_of(ladder.meshes[i], has_error ? &study.errors[i - study.first_used] : nullptr));
  }
  for (const Rung& rung : ladder.half_steps) rows.push_back(row_of(rung, nullptr));
  rows.push_back(row_of(ladder.double_precision, nullptr));
  fmt::print("{}", aligned(rows));
}

void print_change(const std::string& what, const Change& change) {
  if (change.share)
    fmt::print("  {} at {} elements per radius: depth {} +- {}, {:.2g} times the time\n", what,
               change.elements_per_radius, signed_percent(*change.share), percent(*change.standard_error),
               change.cost_ratio);
  else
    fmt::print("  {} at {} elements per radius: not both stopped, no comparison\n", what, change.elements_per_radius);
}

void print_advice(const AdvisedSetting& advice) {
  const auto bound = [](const std::optional<double>& s) { return s ? seconds(*s) : std::string("no bound"); };
  if (!advice.is_found) {
    fmt::print("  {:>4}: none. {}\n", percent(advice.target), advice.why_not);
    return;
  }
  fmt::print("  {:>4}: {} elements per radius, {} run{}, single precision: {} (mesh {}, noise {}), {} ({} to {}){}\n",
             percent(advice.target), advice.elements_per_radius, advice.replicates, advice.replicates == 1 ? "" : "s",
             percent(advice.error), percent(advice.discretisation_error), percent(advice.noise_error),
             seconds(advice.cpu_seconds), bound(advice.cpu_seconds_low), bound(advice.cpu_seconds_high),
             advice.cost_is_estimated ? "; extrapolated: no mesh of the ladder reaches it" : "");
}

void print(const Findings& f) {
  fmt::print("{} into {}: error against processor time\n", f.scene.particle.name, f.scene.target.name);
  print_table(f.ladder, f.study);
  const auto& found = f.study.convergence;
  if (f.study.is_fitted()) {
    fmt::print("  extrapolated depth {} ({} to {}), error {}, observed order {:.2g}, scatter about the fit {}\n",
               length(f.study.limit.value), length(f.study.limit.low), length(f.study.limit.high), word(found.fit.form),
               found.observed_order, percent(found.fit.standard_deviation / found.fit.limit));
    fmt::print("  a run scatters by {} of the depth\n", percent(f.study.model.noise));
  }
  for (const Change& half : f.study.half_step) print_change("half the time step", half);
  print_change("double precision", f.study.double_precision);
  fmt::print("  cheapest setting for an error of\n");
  for (const AdvisedSetting& one : f.advice) print_advice(one);
  for (const auto& finding : f.study.findings) fmt::print("  note: {}\n", finding);
  fmt::print("  {} runs, {} from the store, {:.1f} s of processor time, {:.1f} s in all, {}\n", f.cost.runs,
             f.cost.reused, f.cost.cpu_seconds, f.wall_seconds, instruction_level());
}

std::string result_text(const Findings& f) {
  Json json = error_vs_time_to_json(f.ladder, f.study, f.advice);
  json.update({{"schema", result_schema},
               {"percal", version()},
               {"command", "study"},
               {"study", "error vs time"},
               {"input", {{"scene", f.scene.source}, {"toml", scene_to_toml(f.scene, "")}}},
               {"ladder",
                {{"elements_per_radius", f.ladder.options.meshes},
                 {"replicates", f.ladder.options.replicates},
                 {"time_step_factor", *f.ladder.options.time_step_factor}}},
               {"runs", f.cost.runs},
               {"reused", f.cost.reused},
               {"cpu_s", f.cost.cpu_seconds},
               {"wall_s", f.wall_seconds},
               {"isa", instruction_level()}});
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

// Whether there is a plot.
bool write_results(const Findings& f, const std::string& folder, const std::string& result) {
  write_file(folder + "/result.json", result);
  write_file(folder + "/error_vs_time.csv", error_vs_time_csv(f.ladder, f.study));
  if (!f.study.is_fitted()) return false;
  const auto title = fmt::format("{} into {}", f.scene.particle.name, f.scene.target.name);
  const auto svg = gnuplot(error_plot_script(f.ladder, f.study, title));
  if (svg) write_file(folder + "/error_vs_time.svg", *svg);
  return svg.has_value();
}

}  // namespace

Exit study_error_vs_time(const StudyArguments& arguments, const Common& common) {
  const auto start = std::chrono::steady_clock::now();
  const Scene scene = read_scene(arguments.scene);
  LadderOptions options;
  if (!arguments.meshes.empty()) options.meshes = arguments.meshes;
  if (arguments.replicates) options.replicates = *arguments.replicates;
  options = checked(options, scene);
  if (common.check) {
    if (common.json)
      fmt::print("{}\n", Json{{"command", "study"}, {"scene", arguments.scene}, {"valid", true}}.dump());
    else if (!common.quiet)
      fmt::print("{}: a scene that can be studied, {} runs\n", arguments.scene, ladder_runs(options));
    return Exit::done;
  }
  const std::string folder = out_folder(arguments.scene, common);
  ensure_writable_folder(folder);
  Store store(common.store.empty() ? default_store_path() : common.store);
  Campaign campaign(&store, common.threads);
  const Ladder ladder = [&] {
    Progress progress("study", ladder_runs(options));
    return run_ladder(scene, options, campaign, &progress);
  }();
  keep_ladder(store, study_key(scene), ladder.options);
  const ErrorVsTime study = error_vs_time(ladder);
  std::vector<AdvisedSetting> advice;
  for (const double target : advised_errors) advice.push_back(advise(ladder, study, target));
  const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const Findings findings{scene, ladder, study, advice, campaign.cost(), wall};
  const std::string result = result_text(findings);
  const bool has_plot = write_results(findings, folder, result);
  if (common.json) {
    fmt::print("{}", result);
  } else if (!common.quiet) {
    print(findings);
    fmt::print(
        "  results: {}{}\n", folder,
        has_plot || !study.is_fitted() ? "" : " (the plot was not drawn: no gnuplot; error_vs_time.csv has its data)");
  }
  return study.is_fitted() ? Exit::done : Exit::outcome_not_reached;
}

}  // namespace percal::tools
