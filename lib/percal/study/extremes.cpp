#include "percal/study/extremes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "percal/base/error.hpp"
#include "percal/scene/scene_toml.hpp"

namespace percal {
namespace {

constexpr double clearly_negative = -0.05;  // of the impact energy

std::vector<double> numbers_of(const ImpactResult& r) {
  std::vector<double> numbers{r.depth,         r.end_time,          r.end_speed,     r.sideways,    r.turn,
                              r.element_steps, r.smallest_jacobian, r.smallest_step, r.energy.sum()};
  for (const auto& [key, share, words] : energy_terms) numbers.push_back(r.energy.*share);
  return numbers;
}

// The scene as the reader takes it; throws BadInput.
Scene checked(const Scene& scene) { return parse_scene(scene_to_toml(scene, ""), "cell"); }

RunCell finished(const Reduction& reduction, const Evaluation& evaluation) {
  RunCell run{.reduction = reduction, .evaluation = evaluation, .same_problem_as = "", .warnings = reduction.warnings};
  const Penetration p = summarise({evaluation}, reduction.problem, reduction.scales);
  const std::string& reason = evaluation.result.reason;  // shown in a place of its own
  for (const auto& line : warnings(p, {evaluation}))
    if (reason.empty() || !line.ends_with(reason)) run.warnings.push_back(line);
  return run;
}

}  // namespace

std::string CellResult::outcome() const { return run ? word(run->evaluation.result.outcome) : "refused"; }

std::vector<std::string> judge_run(const ImpactResult& result, const Problem& problem) {
  std::vector<std::string> troubles;
  if (result.outcome == Outcome::unstable) {
    if (result.reason.empty()) troubles.emplace_back("unstable without a reason");
    return troubles;
  }
  if (!std::ranges::all_of(numbers_of(result), [](double x) { return std::isfinite(x); }))
    return {"a number is not finite"};
  if (const double closure = result.energy.closure(); std::abs(closure) > tolerated_closure)
    troubles.push_back(fmt::format("the energy is {:+.1f} % off", 100 * closure));
  if (result.smallest_jacobian <= 0)
    troubles.push_back(fmt::format("an element was turned inside out: J = {:.3g}", result.smallest_jacobian));
  const auto is_stretched = [](const auto& layer) { return layer.stretch != 1 || layer.stretch_across; };
  const bool taut = is_stretched(problem) || std::ranges::any_of(problem.below, is_stretched);
  // Energies of stretched elements are counted from their stretch, and fall where they slacken.
  const auto may_be_negative = [taut](double EnergyLedger::*share) {
    return taut && (share == &EnergyLedger::elastic || share == &EnergyLedger::eroded);
  };
  for (const auto& [key, share, words] : energy_terms)
    if (result.energy.*share < clearly_negative && !may_be_negative(share))
      troubles.push_back(fmt::format("{} has {:.1f} % of the energy", key, 100 * result.energy.*share));
  // The tip may be a step's way past the bottom.
  if (result.depth < 0 || result.depth > problem.whole_depth() + 1)
    troubles.push_back(fmt::format("the depth is {:.3g} radii", result.depth));
  return troubles;
}

std::vector<CellResult> run_extremes(const std::vector<ExtremeCell>& cells, const std::string& instruction_level,
                                     const EvaluateBatch& evaluate) {
  std::vector<CellResult> results;
  std::vector<Reduction> reductions;
  std::vector<Problem> problems;
  std::vector<std::size_t> place;  // in results, of each problem
  for (const ExtremeCell& cell : cells) {
    results.push_back({.cell = cell, .run = std::nullopt, .reason = "", .troubles = {}});
    try {
      reductions.push_back(reduce(checked(cell.scene)));
      problems.push_back(reductions.back().problem);
      place.push_back(results.size() - 1);
    } catch (const BadInput& refusal) {
      results.back().reason = refusal.what();
    }
  }
  const auto evaluations = evaluate(problems);
  std::map<std::string, std::string> first_with_key;
  for (std::size_t i = 0; i < problems.size(); ++i) {
    CellResult& result = results[place[i]];
    result.run = finished(reductions[i], evaluations[i]);
    result.reason = evaluations[i].result.reason;
    result.troubles = judge_run(evaluations[i].result, problems[i]);
    const auto [first, is_new] =
        first_with_key.try_emplace(evaluation_key(problems[i], instruction_level), result.cell.what);
    if (!is_new) result.run->same_problem_as = first->second;
  }
  return results;
}

bool has_troubles(const std::vector<CellResult>& results) {
  return std::ranges::any_of(results, [](const CellResult& result) { return !result.troubles.empty(); });
}

}  // namespace percal
