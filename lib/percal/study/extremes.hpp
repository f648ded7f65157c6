// The matrix of extreme impacts, run and judged: every cell ends as a named outcome, or is refused with a reason.
#pragma once
#include <functional>
#include <optional>

#include "percal/observe/penetration.hpp"
#include "percal/study/extreme_cells.hpp"

namespace percal {

// Results in the order of the problems, as Campaign::evaluate gives them.
using EvaluateBatch = std::function<std::vector<Evaluation>(const std::vector<Problem>&)>;

struct RunCell {
  Reduction reduction;
  Evaluation evaluation;
  std::string same_problem_as;        // the cell that is the same without dimensions; empty where there is none
  std::vector<std::string> warnings;  // those that percal impact would print
};

struct CellResult {
  ExtremeCell cell;
  std::optional<RunCell> run;         // not there: refused
  std::string reason;                 // why it was refused, or what went unstable; else empty
  std::vector<std::string> troubles;  // what must not happen: see judge_run()
  std::string outcome() const;        // "refused", or the outcome's word
};

inline constexpr double tolerated_closure = 0.05;  // of the energy, unless the outcome says unstable

// What is wrong with a run whose outcome is not `unstable`: a number that is not finite, an energy error beyond
// tolerated_closure, an element turned inside out, a share of the energy that is clearly negative, a depth out of the layer.
std::vector<std::string> judge_run(const ImpactResult& result, const Problem& problem);

// `instruction_level` of the evaluations, for telling equal problems.
std::vector<CellResult> run_extremes(const std::vector<ExtremeCell>& cells, const std::string& instruction_level,
                                     const EvaluateBatch& evaluate);

bool has_troubles(const std::vector<CellResult>& results);

}  // namespace percal
