// The page of `percal impact`.
#include "percal/observe/page/page.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "percal/observe/page/parts.hpp"
#include "percal/observe/page/scene_words.hpp"
#include "percal/page/numbers.hpp"

namespace percal {

using namespace page;

namespace {

std::string toml_of(const Json& result) { return text(at(result, "input"), "toml"); }

std::string title_of(const Json& result) {
  const std::string pair = scene_title(toml_of(result));
  const std::string file = std::filesystem::path(text(at(result, "input"), "scene")).filename().string();
  return "Impact: " + (pair.empty() ? file : pair);
}

std::string summary_of(const Json& result) {
  const std::size_t runs = list(result, "runs").size();
  if (at(result, "outcome").is_null()) return "Not run: " + text(at(result, "accuracy"), "why_not");
  if (const auto depth = number(result, "depth_m")) {
    std::string summary = fmt::format("Depth {}", length(depth));
    if (number(result, "depth_standard_error_m"))
      summary += fmt::format(", standard error {} (a single run scatters by {}, {} runs)",
                             length(number(result, "depth_standard_error_m"), 2),
                             length(number(result, "depth_spread_m"), 2), runs);
    return summary + "; the particle stopped in every run.";
  }
  if (number(result, "depth_at_least_m"))
    return fmt::format("The particle passed through the layer: deeper than {}.",
                       length(number(result, "depth_at_least_m")));
  return "The run ended as: " + text(result, "outcome") + ". There is no depth.";
}

// 2 mu/alpha, whichever way the scene says its modulus.
std::optional<double> mu1_of(const Json& result) {
  if (text(result, "convention") == "mu/alpha") return number(result, "mu_as_given_Pa");
  const auto mu = number(result, "mu_true_Pa"), alpha = scene_number(toml_of(result), "target", "alpha");
  return mu && alpha && *alpha != 0 ? std::optional(2 * *mu / *alpha) : std::nullopt;
}

// Every value of a part of the scene: its keys are words.
void add_scene_rows(Table& table, const std::string& toml, const std::string& part, const std::string& prefix) {
  for (const auto& [key, value] : scene_values(toml, part)) {
    std::string words = prefix + key;
    std::replace(words.begin(), words.end(), '_', ' ');
    if (key != "mu" && key != "convention") table.rows.push_back({words, value});
  }
}

Section asked_section(const Json& result) {
  Section section{.id = "asked", .title = "What was asked", .blocks = {}};
  const std::string toml = toml_of(result);
  Table particle{.caption = "The particle", .rows = {{"", ""}}, .notes = {}};
  add_scene_rows(particle, toml, "particle", "");
  add(section, particle);
  Table target{.caption = "The target", .rows = {{"", ""}}, .notes = {}};
  const auto row = [&](const char* what, const std::string& value) {
    if (!value.empty() && value != "-") target.rows.push_back({what, value});
  };
  row("mu, true", pressure(number(result, "mu_true_Pa")));
  row("2 mu/alpha", pressure(mu1_of(result)));
  row("the scene gives", text(result, "convention") == "mu/alpha" ? "2 mu/alpha" : "mu, true");
  row("bulk modulus K", pressure(number(result, "bulk_modulus_Pa")) +
                            (yes(result, "bulk_was_chosen") ? ", chosen by the program" : ", given"));
  row("Mach number", shown(number(result, "mach"), 3));
  add_scene_rows(target, toml, "target", "");
  add_scene_rows(target, toml, "target.erosion", "erosion ");
  if (scene_values(toml, "target.erosion").empty()) row("erosion", "none");
  target.notes = {
      "mu true is the small-strain shear modulus of W = (2 mu/alpha^2) (sum lambda^alpha - 3); 2 mu/alpha is the "
      "number "
      "that LS-DYNA and others call MU1 or mu."};
  add(section, target);
  Table mesh{.caption = "Mesh and solver", .rows = {{"", ""}}, .notes = {}};
  add_scene_rows(mesh, toml, "mesh", "");
  add_scene_rows(mesh, toml, "solver", "");
  add(section, mesh);
  return section;
}

Table runs_table(const Json& result) {
  Table table{
      .caption = "The runs",
      .rows = {{"speed factor", "outcome", "depth", "steps", "eroded", "smallest J", "smallest step", "energy error",
                "CPU time", "from the store"}},
      .notes = {"Replicates differ by a part in a thousand of the speed: what they differ by beyond that is the "
                "scatter of erosion. The smallest step is over the first."}};
  for (const Json& run : list(result, "runs"))
    table.rows.push_back({shown(number(run, "speed_factor"), 6), text(run, "outcome"), length(number(run, "depth_m")),
                          shown(number(run, "steps"), 9), shown(number(run, "eroded"), 9),
                          shown(number(run, "smallest_jacobian"), 3), shown(number(run, "smallest_step_over_first"), 3),
                          percent(number(run, "energy_closure"), 3), shown(number(run, "cpu_s"), 3) + " s",
                          yes(run, "reused") ? "yes" : "no"});
  return table;
}

Figure scatter_figure(const Json& result) {
  Figure figure;
  figure.name = "replicates";
  const ShownUnit unit = length_unit(number_or(result, "depth_m", 0));
  const double mean = number_or(result, "depth_m", NAN) / unit.size,
               error = number_or(result, "depth_standard_error_m", NAN) / unit.size;
  Series runs = series("runs", Mark::points, 1), line = series("mean", Mark::line, 0),
         band = series("its standard error", Mark::band, 0);
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const Json& run : list(result, "runs")) {
    const double factor = number_or(run, "speed_factor", NAN), change = 100 * (factor - 1);
    add_point(runs, change, number_or(run, "depth_m", NAN) / unit.size);
    low = std::min(low, change);
    high = std::max(high, change);
  }
  if (runs.x.size() < 2 || !std::isfinite(mean)) return figure;
  for (const double x : {low, high}) {
    add_point(line, x, mean);
    if (std::isfinite(error)) add_bar(band, x, mean, mean - error, mean + error);
  }
  figure.chart.title = "The noise: depth of each run";
  figure.chart.x.label = "change of the impact speed, %";
  figure.chart.y.label = "depth, " + unit.name;
  add(figure.chart, band);
  add(figure.chart, line);
  add(figure.chart, runs);
  figure.caption =
      fmt::format("Runs that differ by a part in a thousand of the speed scatter by {} of the depth.",
                  percent(number_or(result, "depth_spread_m", NAN) / number_or(result, "depth_m", NAN), 2));
  figure.alt =
      fmt::format("Depths of {} runs over small changes of the impact speed. {}", runs.x.size(), figure.caption);
  return figure;
}

void add_accuracy(Section& section, const Json& result) {
  const Json& accuracy = at(result, "accuracy");
  if (!accuracy.is_object()) {
    add_sentence(
        section,
        "Where the error comes from: the standard error above is the noise of erosion alone. The error of the mesh "
        "is not in it and is not known from these runs; `percal study SCENE --error-vs-time` measures it, and "
        "`percal impact SCENE --accuracy 2%` chooses mesh and replicates by it.");
    return;
  }
  Table table{.caption = "Where the error comes from, by the scene's study", .rows = {{"", ""}}, .notes = {}};
  table.rows.push_back({"asked for", percent(number(accuracy, "target_error"))});
  table.rows.push_back({"mesh", percent(number(accuracy, "discretisation_error"))});
  table.rows.push_back({"noise of erosion", percent(number(accuracy, "noise_error"))});
  table.rows.push_back({"both", percent(number(accuracy, "error"))});
  table.rows.push_back({"elements per radius", shown(number(accuracy, "elements_per_radius"))});
  table.rows.push_back({"replicates", shown(number(accuracy, "replicates"))});
  if (yes(accuracy, "cost_estimated")) table.notes.push_back("Extrapolated: no mesh of the study reaches this error.");
  if (const std::string why = text(accuracy, "why_not"); !why.empty()) table.notes.push_back(why);
  section.blocks.push_back(table);
}

Section result_section(const Json& result) {
  Section section{.id = "result", .title = "What came out", .blocks = {}};
  Table table{.caption = "Penetration", .rows = {{"", ""}}, .notes = {}};
  const auto row = [&](const char* what, const std::string& value) {
    if (!value.empty() && value != "-") table.rows.push_back({what, value});
  };
  row("outcome", text(result, "outcome"));
  row("depth, mean of the runs", length(number(result, "depth_m"), 5));
  row("standard error of the mean", length(number(result, "depth_standard_error_m"), 3));
  row("spread of a run", length(number(result, "depth_spread_m"), 3));
  row("deeper than", length(number(result, "depth_at_least_m"), 5));
  row("elements", shown(number(result, "elements"), 9));
  row("steps", shown(number(result, "steps"), 9));
  add(section, table);
  add_accuracy(section, result);
  if (const auto warnings = texts(at(result, "warnings")); !warnings.empty()) section.blocks.push_back(List{warnings});
  add(section, scatter_figure(result));
  add(section, runs_table(result));
  return section;
}

}  // namespace

page::Page impact_page(const page::Json& result) {
  Page page;
  page.title = title_of(result);
  page.summary = summary_of(result);
  for (auto section : {asked_section, result_section, history_section, energy_section, left_out_section,
                       provenance_section, input_section})
    add(page, section(result));
  return page;
}

}  // namespace percal
