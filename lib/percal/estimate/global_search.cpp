#include "percal/estimate/global_search.hpp"

#include <algorithm>
#include <limits>
#include <nlopt.hpp>
#include <numeric>

#include "percal/base/progress.hpp"
#include "percal/estimate/scatter.hpp"

namespace percal {
namespace {

using Eigen::VectorXd;

constexpr double no_answer = 1e30;           // of a point where the model has none
constexpr double separation = 0.1;           // of the unit box, times sqrt(parameters)
constexpr std::size_t most_compared = 2000;  // best points among which neighbours are looked for

// A point of the unit box.
struct Visited {
  VectorXd at;
  double value;
};

// -2 ln likelihood of independent data, each group's scatter the one that this point's residuals show. It spans decades less
// than a sum of squares does, and needs no weights beforehand.
double profiled_deviance(Evaluator& evaluator, const VectorXd& searched) {
  const CalibrationProblem& problem = evaluator.problem();
  const ModelAnswer& answer = evaluator.values(searched);
  if (!answer.value.allFinite()) return no_answer;
  const auto scatter = first_scatter(problem, residuals(problem, answer));
  const Weights weights = make_weights(problem.data, scatter, {});
  return std::min(no_answer,
                  whiten(problem, weights, answer, searched).objective() + weights.log_determinant(problem.data));
}

struct Search {
  Evaluator& evaluator;
  VectorXd low, width;
  std::vector<Visited> visited;
  Progress& progress;

  double value(const VectorXd& unit) {
    progress.add();
    const double found = profiled_deviance(evaluator, low + width.cwiseProduct(unit));
    visited.push_back({unit, found});
    return found;
  }
};

double nlopt_value(const std::vector<double>& unit, std::vector<double>&, void* search) {
  return static_cast<Search*>(search)->value(VectorXd::Map(unit.data(), static_cast<int>(unit.size())));
}

void direct(Search& search, int evaluations) {
  const auto p = static_cast<std::size_t>(search.low.size());
  nlopt::opt optimiser(nlopt::GN_DIRECT_L_NOSCAL, static_cast<unsigned>(p));
  optimiser.set_lower_bounds(0);
  optimiser.set_upper_bounds(1);
  optimiser.set_min_objective(nlopt_value, &search);
  optimiser.set_maxeval(evaluations);
  std::vector<double> unit(p, 0.5);
  double best = 0;
  optimiser.optimize(unit, best);
}

// Points whose nearest better point is far away are the bottoms of basins (nearest-better clustering, Preuss 2010).
std::vector<VectorXd> basin_bottoms(std::vector<Visited> visited, int most) {
  std::ranges::stable_sort(visited, {}, &Visited::value);
  visited.resize(std::min(visited.size(), most_compared));
  const double far = separation * std::sqrt(static_cast<double>(visited[0].at.size()));
  std::vector<VectorXd> bottoms;
  for (std::size_t i = 0; i < visited.size() && static_cast<int>(bottoms.size()) < most; ++i) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t better = 0; better < i && nearest >= far; ++better)
      nearest = std::min(nearest, (visited[i].at - visited[better].at).norm());
    if (nearest >= far && (i == 0 || visited[i].value < no_answer)) bottoms.push_back(visited[i].at);
  }
  return bottoms;
}

}  // namespace

std::vector<VectorXd> promising_points(Evaluator& evaluator, const SearchOptions& options) {
  const VectorXd low = lower_bounds(evaluator.problem()), high = upper_bounds(evaluator.problem());
  Progress progress("search for minima", options.global_evaluations);
  Search search{evaluator, low, high - low, {}, progress};
  search.value(VectorXd::Constant(low.size(), 0.5));
  if (options.global_evaluations > 1) direct(search, options.global_evaluations - 1);
  auto starts = basin_bottoms(std::move(search.visited), std::max(1, options.starts));
  for (VectorXd& start : starts) start = low + (high - low).cwiseProduct(start);
  return starts;
}

}  // namespace percal
