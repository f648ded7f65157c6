#include "percal/study/extremes_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

namespace percal {
namespace {

using Json = nlohmann::json;

Json finite(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

std::string erosion_words(const Erosion& erosion) {
  if (const auto* strain = std::get_if<StrainErosion>(&erosion))
    return fmt::format("{} strain {:.6g}", word(strain->measure), strain->limit);
  if (const auto* stress = std::get_if<StressErosion>(&erosion))
    return fmt::format("stress {:.6g} rho v2", stress->limit);
  if (const auto* energy = std::get_if<EnergyErosion>(&erosion))
    return fmt::format("energy {:.6g} rho v2", energy->limit);
  return "none";
}

std::string particle_word(const Particle& particle) {
  return std::holds_alternative<RigidSphere>(particle)    ? "rigid sphere"
         : std::holds_alternative<RigidPolygon>(particle) ? "rigid profile"
                                                          : "elastic sphere";
}

Json problem_to_json(const Problem& p) {
  return {{"particle", particle_word(p.particle)},
          {"geometry", p.geometry == Geometry::axisymmetric ? "axisymmetric" : "plane strain"},
          {"pi4", p.pi4},
          {"density_ratio", p.density_ratio},
          {"alpha", p.alpha},
          {"bulk_to_shear", p.bulk_ratio},
          {"erosion", erosion_words(p.erosion)},
          {"layers", 1 + p.below.size()},
          {"depth_over_radius", p.whole_depth()},
          {"elements_per_radius", p.elements_per_radius},
          {"time_step_factor", p.time_step_factor}};
}

Json cell_to_json(const CellResult& result) {
  Json json{{"group", result.cell.group},
            {"cell", result.cell.what},
            {"radius_m", result.cell.scene.particle.radius},
            {"speed_m_s", result.cell.scene.particle.speed},
            {"outcome", result.outcome()},
            {"reason", result.reason},
            {"troubles", result.troubles}};
  if (!result.run) return json;
  const ImpactResult& r = result.run->evaluation.result;
  json.update({{"problem", problem_to_json(result.run->reduction.problem)},
               {"mach", finite(result.run->reduction.mach)},
               {"tip_over_radius", finite(r.depth)},
               {"end_time_over_radius_time", finite(r.end_time)},
               {"end_speed_ratio", finite(r.end_speed)},
               {"energy_closure", finite(r.energy.closure())},
               {"smallest_jacobian", finite(r.smallest_jacobian)},
               {"smallest_step", finite(r.smallest_step)},
               {"overlap_over_radius", finite(result.run->overlap())},
               {"numerical_loss", finite(r.energy.numerical_loss())},
               {"elements", r.elements},
               {"eroded", r.eroded},
               {"distorted", r.distorted},
               {"steps", r.steps},
               {"element_steps", finite(r.element_steps)},
               {"cpu_s", result.run->evaluation.cpu_seconds},
               {"same_problem_as", result.run->same_problem_as},
               {"warnings", result.run->warnings}});
  return json;
}

std::map<std::string, int> outcome_counts(const std::vector<CellResult>& results) {
  std::map<std::string, int> counts;
  for (const auto& result : results) ++counts[result.outcome()];
  return counts;
}

// Of the cells that ran and are not unstable.
struct Extent {
  double worst_closure = 0, smallest_jacobian = 1, smallest_step = 1, cpu_seconds = 0, longest_cell = 0;
  int with_troubles = 0, with_soft_contact = 0;
};
Extent extent_of(const std::vector<CellResult>& results) {
  Extent extent;
  for (const auto& result : results) {
    extent.with_troubles += !result.troubles.empty();
    if (!result.run) continue;
    const auto& [evaluation, r] = std::tie(result.run->evaluation, result.run->evaluation.result);
    if (result.run->same_problem_as.empty()) extent.cpu_seconds += evaluation.cpu_seconds;
    extent.longest_cell = std::max(extent.longest_cell, evaluation.cpu_seconds);
    if (r.outcome == Outcome::unstable) continue;
    extent.with_soft_contact += result.run->overlap() > tolerated_overlap;
    extent.worst_closure = std::max(extent.worst_closure, std::abs(r.energy.closure()));
    extent.smallest_jacobian = std::min(extent.smallest_jacobian, r.smallest_jacobian);
    extent.smallest_step = std::min(extent.smallest_step, r.smallest_step);
  }
  return extent;
}

std::string quoted(std::string text) {
  for (std::size_t i = 0; (i = text.find('"', i)) != std::string::npos; i += 2) text.insert(i, 1, '"');
  return '"' + text + '"';
}

std::string number(double x, const char* format) {
  return std::isfinite(x) ? fmt::format(fmt::runtime(format), x) : "-";
}

std::string notes_of(const CellResult& result) {
  std::vector<std::string> notes;
  for (const auto& trouble : result.troubles) notes.push_back("**" + trouble + "**");
  if (!result.reason.empty()) notes.push_back(result.reason);
  if (result.run) {
    const ImpactResult& r = result.run->evaluation.result;
    if (!result.run->same_problem_as.empty()) notes.push_back("the same problem as " + result.run->same_problem_as);
    if (result.run->overlap() > tolerated_overlap) notes.emplace_back("contact springs too soft");
    if (r.distorted > 0) notes.push_back(fmt::format("{} of {} eroded for distortion", r.distorted, r.eroded));
  }
  std::string line = fmt::format("{}", fmt::join(notes, "; "));
  for (std::size_t i = 0; (i = line.find('|', i)) != std::string::npos; i += 2) line.insert(i, 1, '\\');
  return line;
}

std::string page_line(const CellResult& result) {
  if (!result.run)
    return fmt::format("| {} | refused | - | - | - | - | - | - | - | - | - | {} |\n", result.cell.what,
                       notes_of(result));
  const RunCell& run = *result.run;
  const ImpactResult& r = run.evaluation.result;
  return fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {:.2f} | {} |\n", result.cell.what,
                     result.outcome(), number(r.depth, "{:.2f}"), number(r.energy.closure(), "{:.1e}"),
                     number(r.energy.numerical_loss(), "{:.2f}"), number(run.overlap(), "{:.2f}"),
                     number(r.smallest_jacobian, "{:.2g}"), number(r.smallest_step, "{:.2g}"),
                     number(run.reduction.mach, "{:.2g}"), r.steps, run.evaluation.cpu_seconds, notes_of(result));
}

constexpr const char* page_header =
    "| cell | outcome | tip, radii | energy closure | numerical loss | overlap, radii | smallest J | smallest step | "
    "Mach | steps | CPU s | notes |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";

}  // namespace

Json extremes_to_json(const std::vector<CellResult>& results) {
  Json cells = Json::array();
  for (const auto& result : results) cells.push_back(cell_to_json(result));
  const Extent extent = extent_of(results);
  return {{"cells", cells},
          {"outcomes", outcome_counts(results)},
          {"summary",
           {{"worst_closure", finite(extent.worst_closure)},
            {"smallest_jacobian", finite(extent.smallest_jacobian)},
            {"smallest_step", finite(extent.smallest_step)},
            {"cells_with_troubles", extent.with_troubles}}}};
}

std::string extremes_csv(const std::vector<CellResult>& results) {
  std::string csv =
      "group,cell,outcome,tip_over_radius,energy_closure,smallest_jacobian,smallest_step,mach,steps,cpu_s,notes\n";
  const auto cell = [](double x) { return std::isfinite(x) ? fmt::format("{:.9g}", x) : std::string(); };
  for (const auto& result : results) {
    csv += fmt::format("{},{},{}", quoted(result.cell.group), quoted(result.cell.what), result.outcome());
    if (result.run) {
      const auto& [evaluation, r] = std::tie(result.run->evaluation, result.run->evaluation.result);
      csv +=
          fmt::format(",{},{},{},{},{},{},{:.6g}", cell(r.depth), cell(r.energy.closure()), cell(r.smallest_jacobian),
                      cell(r.smallest_step), cell(result.run->reduction.mach), r.steps, evaluation.cpu_seconds);
    } else {
      csv += ",,,,,,,";
    }
    csv += fmt::format(",{}\n", quoted(notes_of(result)));
  }
  return csv;
}

std::string extremes_markdown(const std::vector<CellResult>& results) {
  std::vector<std::string> counts;
  for (const auto& [outcome, count] : outcome_counts(results)) counts.push_back(fmt::format("{} {}", count, outcome));
  const Extent extent = extent_of(results);
  std::string page = fmt::format(
      "{} cells: {}. Of those that ran and are not unstable: largest energy error {:.1e}, smallest J {:.2g}, smallest "
      "step {:.2g} of the first. {:.0f} s of processor time in all, {:.1f} s the longest cell.\n\nCells in trouble (a "
      "number that is not finite, an energy error above {:.0f} % or an element turned inside out under another name "
      "than unstable, a depth out of the layer): {}. In {} cells that count as sound nodes were more than {} radii "
      "inside the particle: the contact springs are too soft there, and the depth is not to be relied on; percal "
      "impact "
      "warns of it.\n",
      results.size(), fmt::join(counts, ", "), extent.worst_closure, extent.smallest_jacobian, extent.smallest_step,
      extent.cpu_seconds, extent.longest_cell, 100 * tolerated_closure, extent.with_troubles, extent.with_soft_contact,
      tolerated_overlap);
  std::string group;
  for (const auto& result : results) {
    if (result.cell.group != group) {
      group = result.cell.group;
      page +=
          fmt::format("\n## {}{}\n\n{}", static_cast<char>(std::toupper(group.front())), group.substr(1), page_header);
    }
    page += page_line(result);
  }
  return page;
}

}  // namespace percal
