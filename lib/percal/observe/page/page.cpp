// The page of `percal impact`.
#include "percal/observe/page/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>

#include "percal/observe/page/depth_error.hpp"
#include "percal/observe/page/field_measures.hpp"
#include "percal/observe/page/over_time.hpp"
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
  if (at(result, "outcome").is_null()) return "Not run. " + text(at(result, "accuracy"), "why_not");
  if (number(result, "depth_m")) return "Depth " + depth_words(result) + final_words(result);
  if (number(result, "depth_at_least_m"))
    return fmt::format("The particle passed through the target: deeper than {}{}.",
                       length(number(result, "depth_at_least_m")), exit_words(result));
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
  add_scene_rows(target, toml, "target", "");
  add_scene_rows(target, toml, "target.erosion", "erosion ");
  if (scene_values(toml, "target.erosion").empty()) target.rows.push_back({"erosion", "none"});
  target.notes = {
      "mu true is the small-strain shear modulus of W = (2 mu/alpha^2) (sum lambda^alpha - 3); 2 mu/alpha is the "
      "number that LS-DYNA and others call MU1 or mu."};
  add(section, target);
  Table mesh{.caption = "Mesh and solver", .rows = {{"", ""}}, .notes = {}};
  add_scene_rows(mesh, toml, "mesh", "");
  add_scene_rows(mesh, toml, "solver", "");
  add(section, mesh);
  return section;
}

Table runs_table(const Json& result) {
  Table table{
      .caption = "",
      .rows = {{"per radius", "speed", "outcome", "depth", "steps", "eroded", "J", "step", "energy", "CPU, s",
                "stored"}},
      .notes = {
          "Replicates walk through the phase of the mesh (elements per radius) and differ by a part in a thousand "
          "of the speed: what they differ by is the mesh phase and the scatter of erosion. J and step: the smallest, "
          "the step over the first. Energy: the sum of its terms "
          "less 1. Stored: taken from the store."}};
  for (const Json& run : list(result, "runs"))
    table.rows.push_back({shown(number(run, "elements_per_radius"), 4), shown(number(run, "speed_factor"), 6),
                          text(run, "outcome"), length(number(run, "depth_m")), shown(number(run, "steps"), 9),
                          shown(number(run, "eroded"), 9), shown(number(run, "smallest_jacobian"), 3),
                          shown(number(run, "smallest_step_over_first"), 3), percent(number(run, "energy_closure"), 2),
                          shown(number(run, "cpu_s"), 3), yes(run, "reused") ? "yes" : "no"});
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
    const double mesh = number_or(run, "elements_per_radius", NAN);
    add_point(runs, mesh, number_or(run, "depth_m", NAN) / unit.size);
    low = std::min(low, mesh);
    high = std::max(high, mesh);
  }
  if (runs.x.size() < 2 || !std::isfinite(mean)) return figure;
  for (const double x : {low, high}) {
    add_point(line, x, mean);
    if (std::isfinite(error)) add_bar(band, x, mean, mean - error, mean + error);
  }
  figure.chart.title = "Mesh phase and noise: depth of each run";
  figure.chart.x.label = "elements per radius";
  figure.chart.y.label = "depth, " + unit.name;
  add(figure.chart, band);
  add(figure.chart, line);
  add(figure.chart, runs);
  figure.caption = fmt::format(
      "Runs over one period of the mesh phase, each at a slightly different speed, scatter by {} of the depth.",
      percent(number_or(result, "depth_spread_m", NAN) / number_or(result, "depth_m", NAN), 2));
  figure.alt = fmt::format("Depths of {} runs over elements per radius. {}", runs.x.size(), figure.caption);
  return figure;
}

std::string source_words(const Json& accuracy) {
  return text(accuracy, "from") == "the study" ? "the scene's study" : text(accuracy, "from");
}

// " The atlas expects 26.8 um, one run in 95 of 100 between 24.9 um and 28.7 um (its wall at 20 radii)."
std::string atlas_words(const Json& result) {
  const Json& atlas = at(at(result, "accuracy"), "atlas");
  if (atlas.is_null()) return "";
  const auto width = number(atlas, "width_over_radius");
  const bool same_wall = width == number(at(result, "mesh"), "width_over_radius");
  return fmt::format(" The atlas expects {}, of 100 single runs 95 between {} and {}{}.",
                     length(number(atlas, "depth_m"), 3), length(number(atlas, "low_m"), 3),
                     length(number(atlas, "high_m"), 3),
                     same_wall ? "" : fmt::format(" (its wall at {} radii)", shown(width, 4)));
}

// What to do about the parts of the error that these runs do not show.
std::string error_words(const Json& result) {
  const Json& accuracy = at(result, "accuracy");
  if (list(result, "runs").empty()) return "";
  if (accuracy.is_null()) {
    std::vector<std::string> advice;
    if (rules_are_in(result))
      advice.push_back("`--measure-errors` measures what wall, time step and K cost this depth.");
    if (at(result, "extrapolation").is_null())
      advice.push_back(
          "`percal study SCENE --error-vs-time` measures the element size, `--accuracy 2%` chooses mesh and replicates "
          "by it.");
    return fmt::format("{}", fmt::join(advice, " "));
  }
  if (!number(accuracy, "discretisation_error"))
    return fmt::format(
        "Estimated error of the depth {}: mesh phase and noise alone, from {}. The depth belongs to its elements.{}",
        rough_percent(number(accuracy, "error")), source_words(accuracy), atlas_words(result));
  return fmt::format(
      "Estimated error of the depth {} (element size {}, mesh phase and noise {}), from the scene's study{}.",
      rough_percent(number(accuracy, "error")), rough_percent(number(accuracy, "discretisation_error")),
      rough_percent(number(accuracy, "noise_error")),
      yes(accuracy, "cost_estimated") ? ", by extrapolation beyond its meshes" : "");
}

// "5 over the mesh phase: standard error 120 nm, a single run scatters by 270 nm"
std::string runs_words(const Json& result) {
  const auto runs = list(result, "runs").size();
  if (!number(result, "depth_standard_error_m")) return shown(static_cast<double>(runs));
  return fmt::format("{} over the mesh phase{}: standard error {}, a single run scatters by {}", runs,
                     text(result, "depth_from") == "runs and atlas" ? ", joined with the atlas" : "",
                     length(number(result, "depth_standard_error_m"), 3), length(number(result, "depth_spread_m"), 3));
}

std::string with_words(const std::string& value, const std::string& words) {
  return value == absent ? absent : value + ", " + words;
}

// "812 by strain, 31 by stress, 2 by distortion": means of the runs.
std::string eroded_words(const Json& result) {
  std::map<std::string, double> sums;
  const auto& runs = list(result, "runs");
  for (const Json& run : runs)
    for (const auto& [criterion, count] : at(run, "eroded_by").items()) sums[criterion] += count.get<double>();
  std::vector<std::string> words;
  for (const char* criterion : {"strain", "stress", "energy", "distortion"})
    if (sums.contains(criterion))
      words.push_back(fmt::format("{:.0f} by {}", sums[criterion] / static_cast<double>(runs.size()), criterion));
  return fmt::format("{}", fmt::join(words, ", "));
}

// "29 of them graded (chosen by the program), each 1.2 times the last"; of a block, whose cells grow along all axes, how many across.
std::string columns_words(const Json& mesh) {
  const std::string growth = shown(number(mesh, "growth"), 3);
  if (number_or(mesh, "graded_columns", 0) == 0 && number_or(mesh, "growth", 1) > 1)
    return fmt::format("from wall to wall of what is computed, each at most {} times the last", growth);
  return fmt::format("{} of them graded ({}), each {} times the last", shown(number(mesh, "graded_columns")),
                     yes(mesh, "graded_columns_were_chosen") ? "chosen by the program" : "given", growth);
}

// "a quarter": of a block, what its planes of symmetry leave to compute.
std::string computed_words(const Json& mesh) {
  const auto share = number(mesh, "computed_share");
  if (!share) return "";
  return *share == 1 ? "all of the block" : *share == 0.5 ? "a half" : "a quarter";
}

constexpr double degree = std::numbers::pi / 180;

// "1.2 mm to the front, turned by 12 deg about (0.1, -0.9, 0.4)": means of runs that turn about all axes.
std::string path_in_space_words(const Json& runs) {
  double across = 0;
  std::array<double, 3> turn{};  // angle times axis
  for (const Json& run : runs) {
    const double share = 1 / static_cast<double>(runs.size()), angle = number_or(run, "turn_rad", 0);
    across += number_or(run, "across_m", 0) * share;
    const auto& axis = list(run, "turn_axis");
    for (std::size_t d = 0; d < std::min<std::size_t>(3, axis.size()); ++d)
      if (axis[d].is_number()) turn[d] += axis[d].get<double>() * angle * share;
  }
  const double angle = std::hypot(turn[0], turn[1], turn[2]);
  std::string words = length(std::abs(across), 3) + (across < 0 ? " to the front" : " to the back");
  if (angle != 0)
    words += fmt::format(", turned by {:.3g} deg about ({:.2g}, {:.2g}, {:.2g})", angle / degree, turn[0] / angle,
                         turn[1] / angle, turn[2] / angle);
  return words;
}

// "3.2 mm to the right, turned by 12 deg anticlockwise": means of the runs; nothing of a particle that went straight down.
std::string path_words(const Json& result) {
  double sideways = 0, turn = 0;
  const auto& runs = list(result, "runs");
  for (const Json& run : runs) {
    sideways += number_or(run, "sideways_m", 0) / static_cast<double>(runs.size());
    turn += number_or(run, "turn_rad", 0) / static_cast<double>(runs.size());
  }
  if (sideways == 0 && turn == 0) return "";
  std::string words = length(std::abs(sideways), 3) + (sideways < 0 ? " to the left" : " to the right");
  if (number(runs.front(), "across_m")) return words + ", " + path_in_space_words(runs);
  if (turn != 0)
    words +=
        fmt::format(", turned by {:.3g} deg {}", std::abs(turn) / degree, turn < 0 ? "clockwise" : "anticlockwise");
  return words;
}

Section result_section(const Json& result) {
  Section section{.id = "result", .title = "What it rests on", .blocks = {}, .detail = Detail::answer};
  Table table{.caption = "", .rows = {{"", ""}}, .notes = {}};
  const auto row = [&](const char* what, const std::string& value) {
    if (!value.empty() && value != absent) table.rows.push_back({what, value});
  };
  const bool as_mu1 = text(result, "convention") == "mu/alpha";
  const auto per_radius = scene_number(toml_of(result), "mesh", "elements_per_radius");
  row("runs", runs_words(result));
  row("mu, true", pressure(number(result, "mu_true_Pa")) + (as_mu1 ? "" : ", as the scene gives it"));
  row("2 mu/alpha", pressure(mu1_of(result)) + (as_mu1 ? ", as the scene gives it" : ""));
  row("bulk modulus K", pressure(number(result, "bulk_modulus_Pa")) +
                            (yes(result, "bulk_was_chosen") ? ", chosen by the program" : ", given"));
  row("Mach number", shown(number(result, "mach"), 3));
  row("elements", with_words(shown(number(result, "elements"), 9), shown(per_radius) + " per radius"));
  const Json& mesh = at(result, "mesh");
  row("width", with_words(shown(number(mesh, "width_over_radius"), 4),
                          std::string("radii to the wall, ") +
                              (yes(mesh, "width_was_chosen") ? "chosen by the program" : "given")));
  row("columns", with_words(shown(number(mesh, "columns"), 6), columns_words(mesh)));
  row("computed", computed_words(mesh));
  row("path", path_words(result));
  for (const auto& [what, value] : field_rows(result)) row(what.c_str(), value);
  row("extrapolated from", mesh_depths(result));
  row("elements taken out of a run", eroded_words(result));
  row("erosion judged over",
      with_words(length(number(result, "erosion_length_m")),
                 "elements of " + shown(number(result, "element_over_erosion_length"), 3) + " of it"));
  if (const Json& fields = at(result, "fields"); !fields.is_null())
    row("fields of the middle run",
        text(fields, "list") + ", " + counted(static_cast<long>(number_or(fields, "frames", 0)), "frame"));
  row("picture of the middle run", text(result, "picture"));
  add_sentence(section, bias_words(result));
  add(section, table);
  add_sentence(section, error_words(result));
  return section;
}

Table accuracy_table(const Json& result) {
  const Json& accuracy = at(result, "accuracy");
  if (accuracy.is_null()) return {};
  Table table{.caption = "Where the error comes from, by " + source_words(accuracy), .rows = {{"", ""}}, .notes = {}};
  const auto row = [&](const char* what, const std::string& value) {
    if (value != absent) table.rows.push_back({what, value});
  };
  row("asked for", percent(number(accuracy, "target_error")));
  row("element size", percent(number(accuracy, "discretisation_error")));
  row("mesh phase and noise", percent(number(accuracy, "noise_error")));
  row("both", percent(number(accuracy, "error")));
  row("elements per radius", shown(number(accuracy, "elements_per_radius")));
  row("replicates", shown(number(accuracy, "replicates")));
  row("processor time of the replicates", quantity(number(accuracy, "cpu_s"), dimension::time, 3));
  if (at(accuracy, "atlas").is_null())
    row("the study", yes(accuracy, "study_was_kept")
                         ? "kept in the store"
                         : "run for this, " + quantity(number(accuracy, "study_cpu_s"), dimension::time, 3));
  if (yes(accuracy, "cost_estimated") && number(accuracy, "discretisation_error"))
    table.notes.push_back("Extrapolated: no mesh of the study reaches this error.");
  return table;
}

Section runs_section(const Json& result) {
  Section section{.id = "runs", .title = "The runs", .blocks = {}};
  add(section, accuracy_table(result));
  add(section, scatter_figure(result));
  add(section, runs_table(result));
  return section;
}

}  // namespace

page::Page impact_page(const page::Json& result) {
  Page page;
  page.title = title_of(result);
  page.summary = summary_of(result);
  for (auto section :
       {result_section, findings_section, depth_error_section, channel_section, asked_section, runs_section,
        impact_history_section, impact_energy_section, left_out_section, provenance_section, input_section})
    add(page, section(result));
  return page;
}

}  // namespace percal
