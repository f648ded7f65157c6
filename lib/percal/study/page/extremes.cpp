#include "percal/study/page/extremes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "percal/page/numbers.hpp"
#include "percal/page/sections.hpp"
#include "percal/scene/read_scene.hpp"

namespace percal {

using namespace page;

namespace {

// --- as JSON ------------------------------------------------------------------------------------------------------

std::string erosion_words(const Erosion& erosion) {
  if (const auto* strain = std::get_if<StrainErosion>(&erosion))
    return fmt::format("{} strain {:.6g}", word(strain->measure), strain->limit);
  if (const auto* stress = std::get_if<StressErosion>(&erosion))
    return fmt::format("stress {:.6g} rho v2", stress->limit);
  if (const auto* energy = std::get_if<EnergyErosion>(&erosion))
    return fmt::format("energy {:.6g} rho v2", energy->limit);
  return "none";
}

std::string further_words(const FurtherErosion& further) {
  std::string words;
  if (further.stress) words += fmt::format(" or stress {:.6g} rho v2", *further.stress);
  if (further.energy) words += fmt::format(" or energy {:.6g} rho v2", *further.energy);
  return words;
}

std::string particle_word(const Particle& particle) {
  return std::holds_alternative<RigidSphere>(particle)       ? "rigid sphere"
         : std::holds_alternative<RigidPolygon>(particle)    ? "rigid profile"
         : std::holds_alternative<RigidPolyhedron>(particle) ? "rigid polyhedron"
                                                             : "elastic sphere";
}

Json problem_to_json(const Problem& p) {
  return {{"particle", particle_word(p.particle)},
          {"geometry", geometry_words()[static_cast<int>(p.geometry)]},
          {"pi4", p.pi4},
          {"density_ratio", p.density_ratio},
          {"alpha", p.alpha},
          {"bulk_to_shear", p.bulk_ratio},
          {"erosion", erosion_words(p.erosion) + further_words(p.further_erosion)},
          {"layers", 1 + p.below.size()},
          {"depth_over_radius", p.whole_depth()},
          {"elements_per_radius", p.elements_per_radius},
          {"time_step_factor", p.time_step_factor}};
}

Json run_to_json(const RunCell& run) {
  const ImpactResult& r = run.evaluation.result;
  return {{"problem", problem_to_json(run.reduction.problem)},
          {"mach", finite(run.reduction.mach)},
          {"tip_over_radius", finite(r.depth)},
          {"end_time_over_radius_time", finite(r.end_time)},
          {"end_speed_ratio", finite(r.end_speed)},
          {"energy_closure", finite(r.energy.closure())},
          {"smallest_jacobian", finite(r.smallest_jacobian)},
          {"smallest_step", finite(r.smallest_step)},
          {"numerical_loss", finite(r.energy.numerical_loss())},
          {"elements", r.elements},
          {"eroded", r.eroded},
          {"distorted", r.distorted},
          {"steps", r.steps},
          {"element_steps", finite(r.element_steps)},
          {"cpu_s", run.evaluation.cpu_seconds},
          {"same_problem_as", run.same_problem_as},
          {"warnings", run.warnings}};
}

Json cell_to_json(const CellResult& result) {
  Json json = result.run ? run_to_json(*result.run) : emptied(run_to_json({}));
  json.update({{"group", result.cell.group},
               {"cell", result.cell.what},
               {"radius_m", result.cell.scene.particle.radius},
               {"speed_m_s", result.cell.scene.particle.speed},
               {"outcome", result.outcome()},
               {"reason", result.reason},
               {"troubles", result.troubles}});
  return json;
}

// Of the cells that ran and are not unstable.
Json summary_to_json(const std::vector<CellResult>& results) {
  double worst_closure = 0, smallest_jacobian = 1, smallest_step = 1;
  int with_troubles = 0;
  for (const auto& result : results) {
    with_troubles += !result.troubles.empty();
    if (!result.run || result.run->evaluation.result.outcome == Outcome::unstable) continue;
    const ImpactResult& r = result.run->evaluation.result;
    worst_closure = std::max(worst_closure, std::abs(r.energy.closure()));
    smallest_jacobian = std::min(smallest_jacobian, r.smallest_jacobian);
    smallest_step = std::min(smallest_step, r.smallest_step);
  }
  return {{"worst_closure", finite(worst_closure)},
          {"smallest_jacobian", finite(smallest_jacobian)},
          {"smallest_step", finite(smallest_step)},
          {"cells_with_troubles", with_troubles}};
}

// --- the page -----------------------------------------------------------------------------------------------------

std::string notes_of(const Json& cell) {
  std::vector<std::string> notes = texts(at(cell, "troubles"));
  if (!text(cell, "reason").empty()) notes.push_back(text(cell, "reason"));
  if (!text(cell, "same_problem_as").empty()) notes.push_back("the same problem as " + text(cell, "same_problem_as"));
  if (number_or(cell, "distorted", 0) > 0)
    notes.push_back(fmt::format("{} of {} eroded for distortion", shown(number(cell, "distorted"), 9),
                                shown(number(cell, "eroded"), 9)));
  return joined(notes, "; ");
}

Section endings_section(const Json& result) {
  Section section{.id = "outcomes", .title = "How the cells ended", .blocks = {}, .detail = Detail::answer};
  add_sentence(
      section,
      "Each cell is one run around a gold sphere into skin (radius 1 um, 651 m/s, true mu 63.75 MPa, alpha 8.5, "
      "K/mu 50, erosion strain 0.7) on 7 elements per radius in a layer of 40 radii, for 200 radii of time at "
      "most, with the one thing changed that its name says.");
  const Json& summary = at(result, "summary");
  Table table{.caption = "", .rows = {{"outcome", "cells"}}, .notes = {}};
  for (const auto& [outcome, count] : at(result, "outcomes").items())
    table.rows.push_back({outcome, shown(number(count), 9)});
  add(section, table);
  Table worst{.caption = "Of those that ran and are not unstable", .rows = {{"", ""}}, .notes = {}};
  worst.rows.push_back({"largest energy error", percent(number(summary, "worst_closure"), 3)});
  worst.rows.push_back({"smallest Jacobian of any element", shown(number(summary, "smallest_jacobian"), 3)});
  worst.rows.push_back({"smallest step over the first", shown(number(summary, "smallest_step"), 3)});
  section.blocks.emplace_back(worst);
  List troubles{.items = {}, .tone = Tone::warning};
  for (const Json& cell : list(result, "cells"))
    for (const std::string& trouble : texts(at(cell, "troubles")))
      troubles.items.push_back(text(cell, "group") + ", " + text(cell, "cell") + ": " + trouble);
  add(section, troubles);
  return section;
}

Figure closure_figure(const Json& result) {
  Figure figure;
  figure.name = "energy_errors";
  figure.chart.title = "Energy error of every cell";
  figure.chart.x.label = "number of the cell in the table";
  figure.chart.y = {.label = "energy error, %", .logarithmic = true, .low = {}, .high = {}, .tics = {}};
  std::map<std::string, Series> of;
  int number_of_cell = 0, colour = 0;
  for (const Json& cell : list(result, "cells")) {
    ++number_of_cell;
    const auto closure = number(cell, "energy_closure");
    if (!closure || *closure == 0) continue;
    const std::string outcome = text(cell, "outcome");
    if (!of.contains(outcome)) of[outcome] = series(outcome, Mark::points, colour++);
    add_point(of[outcome], number_of_cell, 100 * std::abs(*closure));
  }
  for (const auto& [outcome, drawn] : of) add(figure.chart, drawn);
  figure.caption = fmt::format(
      "How far each run's energy ledger is from closing. Above {:.0f} % a run must say that "
      "it is unstable.",
      100 * tolerated_closure);
  figure.alt = "Energy errors of all cells, logarithmic. " + figure.caption;
  return figure;
}

std::vector<std::string> cell_row(const Json& cell, int number_of_cell) {
  const std::string notes = notes_of(cell);
  const auto rounded = [&](const char* key, int digits) { return shown(number(cell, key), digits); };
  return {text(cell, "cell"),
          std::to_string(number_of_cell),
          text(cell, "outcome"),
          rounded("tip_over_radius", 4),
          signed_percent(number(cell, "energy_closure"), 3),
          percent(number(cell, "numerical_loss"), 0),
          rounded("smallest_jacobian", 2),
          rounded("smallest_step", 2),
          rounded("mach", 2),
          rounded("steps", 9),
          cpu_time(number(cell, "cpu_s")),
          notes.empty() ? absent : notes};
}

// A table for each group.
Section cells_section(const Json& result) {
  Section section{.id = "cells", .title = "The cells", .blocks = {}};
  add(section, closure_figure(result));
  Table table;
  int number_of_cell = 0;
  std::string group;
  for (const Json& cell : list(result, "cells")) {
    if (text(cell, "group") != group) {
      add(section, table);
      group = text(cell, "group");
      table = {.caption = group,
               .rows = {{"cell", "number", "outcome", "tip, radii", "energy error", "numerical loss", "smallest J",
                         "smallest step", "Mach", "steps", "time", "notes"}},
               .notes = {}};
      table.caption.front() = static_cast<char>(std::toupper(group.front()));
    }
    table.rows.push_back(cell_row(cell, ++number_of_cell));
  }
  add(section, table);
  add_sentence(section,
               "The energy error is the sum of the ledger less 1; the smallest step is over the first one. A refused "
               "cell was not run: its note has the scene reader's words.");
  return section;
}

}  // namespace

Json extremes_to_json(const std::vector<CellResult>& results, const Cost& cost) {
  Json cells = Json::array();
  std::map<std::string, int> outcomes;
  for (const auto& result : results) {
    cells.push_back(cell_to_json(result));
    ++outcomes[result.outcome()];
  }
  Json json = study_head(study_kind::extremes, {{"extremes", true}}, cost);
  json.update({{"cells", cells}, {"outcomes", outcomes}, {"summary", summary_to_json(results)}});
  return json;
}

std::string extremes_csv(const Json& result) {
  std::vector<ResultColumn> columns{{"group", "group", ResultColumn::free_text},
                                    {"cell", "cell", ResultColumn::free_text}};
  for (const char* key :
       {"outcome", "tip_over_radius", "energy_closure", "smallest_jacobian", "smallest_step", "mach", "steps", "cpu_s"})
    columns.push_back({key, key});
  columns.push_back({"notes", "notes", ResultColumn::free_text});
  std::vector<Json> rows = list(result, "cells");
  for (Json& row : rows) row["notes"] = notes_of(row);
  return as_csv(columns, rows);
}

Page extremes_page(const Json& result) {
  const Json &cells = list(result, "cells"), &summary = at(result, "summary");
  double longest = 0;
  for (const Json& cell : cells) longest = std::max(longest, number_or(cell, "cpu_s", 0));
  Page page;
  page.title = "Stiff and extreme impacts";
  page.summary = fmt::format(
      "{} cells, {} with troubles; the worst energy error of a run that is not unstable is {}. The longest took {}.",
      cells.size(), shown(number(summary, "cells_with_troubles"), 9), percent(number(summary, "worst_closure"), 2),
      cpu_time(longest));
  for (auto section : {endings_section, cells_section, provenance_section, input_section}) add(page, section(result));
  return page;
}

}  // namespace percal
