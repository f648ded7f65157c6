#include "percal/study/page/error_vs_time.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "percal/page/numbers.hpp"
#include "percal/page/sections.hpp"

namespace percal {

using namespace page;

namespace {

std::string bounded(const std::string& low, const std::optional<double>& high, const std::string& high_words) {
  return low + " to " + (high ? high_words : "no bound");
}

bool has_limit(const Json& result) { return text(at(result, "convergence"), "outcome") != "no limit"; }

std::string band_words(const Json& band) {
  const auto low = number(band, "low"), high = number(band, "high");
  return low ? bounded(fmt::format("{:+.1f}", 100 * *low), high, fmt::format("{:+.1f}", 100 * high.value_or(NAN)))
             : absent;
}

// Where a depth belongs to its mesh.
Table distance_table(const Json& result) {
  Table table{
      .caption = "",
      .rows = {{"mesh", "depth", "standard error", "from the finest", "interval, %", "time"}},
      .notes = {"Mesh: elements per radius. From the finest: the depth over the finest mesh's, less 1; it holds "
                "the noise of both. Time: of the processor, for one run."}};
  for (const Json& mesh : list(result, "meshes")) {
    const Json& distance = at(mesh, "from_finest");
    const bool is_there = !distance.is_null() && &mesh != &list(result, "meshes").back();
    table.rows.push_back({shown(number(mesh, "elements_per_radius")), depth_or_outcome(mesh),
                          length(number(mesh, "depth_standard_error_m"), 2),
                          is_there ? signed_percent(number(distance, "value")) : absent,
                          is_there ? band_words(distance) : absent, cpu_time(number(mesh, "cpu_s"))});
  }
  return table;
}

Table worth_table(const Json& result) {
  Table table{
      .caption = "",
      .rows = {{"mesh", "depth", "error", "interval, %"}},
      .notes = {"Mesh: elements per radius. Error: against the extrapolated depth; then with the noise of one run "
                "or of a mean of so many. Time: of the processor, for one run."}};
  std::vector<std::string>& header = table.rows.front();
  for (const int count : replicate_counts) header.push_back(counted(count, "run"));
  header.emplace_back("time");
  for (const Json& mesh : list(result, "meshes")) {
    const Json& error = at(mesh, "error");
    table.rows.push_back({shown(number(mesh, "elements_per_radius")), depth_or_outcome(mesh),
                          signed_percent(number(error, "value")), band_words(error)});
    for (const int count : replicate_counts)
      table.rows.back().push_back(
          rough_percent(number(at(at(mesh, "error_of_mean_of"), std::to_string(count)), "value")));
    table.rows.back().push_back(cpu_time(number(mesh, "cpu_s")));
  }
  return table;
}

Table advice_table(const Json& result) {
  const bool of_mesh = has_limit(result);
  Table table{.caption = of_mesh ? "The cheapest setting for an error" : "Runs on the scene's own mesh for an error",
              .rows = {{"error", "mesh", "runs", of_mesh ? "its error (mesh, noise)" : "its error, noise alone", "time",
                        "interval"}},
              .notes = {}};
  for (const Json& one : list(result, "advice")) {
    const std::string target = percent(number(one, "target_error"), 0);
    const auto error = [&](const char* key) { return rough_percent(number(one, key)); };
    const auto low = number(one, "cpu_low_s"), high = number(one, "cpu_high_s");
    const std::string interval = low ? bounded(cpu_time(low), high, cpu_time(high)) : absent;
    if (yes(one, "found"))
      table.rows.push_back(
          {target, shown(number(one, "elements_per_radius")), shown(number(one, "replicates")),
           of_mesh ? fmt::format("{} ({}, {})", error("error"), error("discretisation_error"), error("noise_error"))
                   : error("noise_error"),
           cpu_time(number(one, "cpu_s")), interval});
    else
      table.rows.push_back({target, "none", absent, absent, absent, interval});
    const std::string note = !yes(one, "found")            ? "None: " + text(one, "why_not") + "."
                             : !yes(one, "cost_estimated") ? ""
                             : of_mesh ? target + " is extrapolated: no mesh of the ladder reaches it."
                                       : "Times are estimates: the scene's mesh is none of the ladder's.";
    if (!note.empty() && std::ranges::find(table.notes, note) == table.notes.end()) table.notes.push_back(note);
  }
  return table;
}

std::string what_next(const Json& result) {
  const auto is_found = [](const Json& one) { return yes(one, "found"); };
  const Json& advice = list(result, "advice");
  if (std::any_of(advice.begin(), advice.end(), is_found))
    return fmt::format("`percal impact SCENE --accuracy 2%` runs {} for an error: this ladder is kept for it.",
                       has_limit(result) ? "the cheapest setting" : "so many on the scene's own mesh");
  return "Finer meshes (--meshes) and more runs on each (--replicates) may tell more; finished runs are not repeated.";
}

Section answer_section(const Json& result) {
  Section section{.id = "answer", .title = "What each mesh is worth", .blocks = {}, .detail = Detail::answer};
  std::vector<std::string> meshes;
  for (const double n : numbers(at(at(result, "ladder"), "elements_per_radius"))) meshes.push_back(shown(n));
  add_sentence(section, fmt::format("{} elements per radius, {} runs on each, time step factor {}.", joined(meshes),
                                    shown(number(at(result, "ladder"), "replicates")),
                                    shown(number(at(result, "ladder"), "time_step_factor"))));
  if (const auto judged_over = number(at(result, "ladder"), "erosion_length_m"))
    add_sentence(section,
                 fmt::format("Erosion is judged over {}, which stays while the elements shrink: errors are against the "
                             "depth of this length with elements of size zero.",
                             length(judged_over)));
  add(section, has_limit(result) ? worth_table(result) : distance_table(result));
  add(section, advice_table(result));
  add_sentence(section, what_next(result));
  return section;
}

Table run_table(const Json& result) {
  Table table{.caption = "The runs: a mesh, half the time step, double precision",
              .rows = {{"mesh", "elements", "time step", "arithmetic", "outcome", "depth", "spread", "standard error",
                        "steps", "element-steps", "time of a run"}},
              .notes = {}};
  const auto row = [&](const Json& rung) {
    std::vector<std::string> outcomes;
    for (const std::string& outcome : texts(at(rung, "outcomes")))
      if (std::ranges::find(outcomes, outcome) == outcomes.end()) outcomes.push_back(outcome);
    table.rows.push_back({shown(number(rung, "elements_per_radius")), shown(number(rung, "elements"), 9),
                          shown(number(rung, "time_step_factor"), 3), text(rung, "arithmetic"), joined(outcomes),
                          length(number(rung, "depth_m")), length(number(rung, "depth_spread_m"), 2),
                          length(number(rung, "depth_standard_error_m"), 2),
                          fmt::format("{:.0f}", number_or(rung, "steps", 0)), shown(number(rung, "element_steps"), 3),
                          cpu_time(number(rung, "cpu_s"))});
  };
  for (const char* rungs : {"meshes", "half_steps"})
    for (const Json& rung : list(result, rungs)) row(rung);
  row(at(result, "double_precision"));
  return table;
}

Table change_table(const Json& result) {
  Table table{.caption = "What time step and arithmetic are worth",
              .rows = {{"", "mesh", "change of the depth", "standard error", "significant", "time ratio"}},
              .notes = {"No change where one of the two did not stop."}};
  const auto row = [&](const char* what, const Json& change) {
    table.rows.push_back({what, shown(number(change, "elements_per_radius")),
                          signed_percent(number(change, "share"), 2), percent(number(change, "standard_error"), 2),
                          yes(change, "is_significant") ? "yes" : "no", shown(number(change, "cost_ratio"), 3)});
  };
  for (const Json& change : list(result, "change_by_half_the_step")) row("half the time step", change);
  row("double precision", at(result, "change_by_double_precision"));
  return table;
}

std::string summary(const Json& result) {
  const Json& found = at(result, "convergence");
  const std::string spread = spread_words(result);
  if (spread.empty()) return "No error can be given: " + text(found, "outcome") + ".";
  if (has_limit(result))
    return fmt::format("Extrapolated depth {} ({} to {}). {}.", length(number(found, "extrapolated_depth_m")),
                       length(number(found, "extrapolated_depth_low_m")),
                       length(number(found, "extrapolated_depth_high_m")), spread);
  const Json& meshes = list(result, "meshes");
  const Json& first = *std::ranges::find_if(meshes, [](const Json& m) { return !at(m, "from_finest").is_null(); });
  return fmt::format("Depth {} on {} elements per radius, {} on {}: no limit, each depth belongs to its mesh. {}.",
                     length(number(first, "depth_m")), shown(number(first, "elements_per_radius")),
                     length(number(meshes.back(), "depth_m")), shown(number(meshes.back(), "elements_per_radius")),
                     spread);
}

Section time_section(const Json& result) {
  Section section{.id = "time", .title = "Error against run time", .blocks = {}};
  add(section, error_against_time(result));
  return section;
}

Section mesh_section(const Json& result) {
  Section section{.id = "mesh", .title = "Mesh and noise", .blocks = {}};
  const Json& found = at(result, "convergence");
  add(section, depth_against_element_size(result));
  if (number(found, "extrapolated_depth_m"))
    add_sentence(
        section,
        fmt::format(
            "Where the error comes from: the mesh (error {}, fitted from {} elements per radius, observed order "
            "{}), and the mesh phase. {}. Scatter about the fit {}, from mesh to mesh {} beyond the noise.",
            text(found, "form"), shown(number(found, "fitted_from_elements_per_radius")),
            shown(number(found, "observed_order"), 2), spread_words(result),
            length(number(found, "standard_deviation_m"), 2), rough_percent(number(found, "irregularity"))));
  add(section, run_table(result));
  add(section, change_table(result));
  return section;
}

}  // namespace

std::string spread_words(const Json& result) {
  const Json& found = at(result, "convergence");
  const auto share = number(found, "spread_of_a_run");
  if (!share) return "";
  const std::string words = "A run scatters by " + percent(share, 2);
  return number(found, "spread_order") == 0 ? words : words + " on 10 elements per radius, in proportion to their size";
}

Page error_vs_time_page(const Json& result) {
  Page page;
  page.title = "Error against run time: " + studied_scene(result);
  page.summary = summary(result);
  for (auto section : {answer_section, findings_section, time_section, mesh_section, provenance_section, input_section})
    add(page, section(result));
  return page;
}

}  // namespace percal
