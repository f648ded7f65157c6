// Every distinct minimum: starts from a search over the whole box, fits from them, and which of those are one.
#include <algorithm>
#include <cmath>
#include <limits>
#include <nlopt.hpp>
#include <numeric>

#include "percal/base/progress.hpp"
#include "percal/estimate/profile.hpp"

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

// Starts for the local search, best first: points of a search over the whole box that have no better point near them. One or
// more. The search is NLopt's DIRECT_L, which draws no random numbers.                docs/theory/calibration.md (9)
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

constexpr double barrier = 0.1;  // of -2 ln likelihood: nothing that data could show
constexpr int steps = 12;
constexpr double same_place = 1e-4;  // of the box

// Whether two minima are one: the same point, or points of one ridge, between which the objective rises by less than the barrier.
// The parameter that is furthest off is led to its goal in small steps, the others fitted anew, and stays there; then the next. On a
// ridge, straight or curved, the first one takes the others with it.
bool connected(const CalibrationProblem& problem, const Minimum& from, const Minimum& to) {
  const VectorXd width = upper_bounds(problem) - lower_bounds(problem);
  VectorXd here = from.searched;
  const auto off = [&](const VectorXd& there) {
    return VectorXd((to.searched - there).cwiseQuotient(width).cwiseAbs());
  };
  if (off(here).maxCoeff() < same_place) return true;
  if (std::abs(to.deviance - from.deviance) > barrier) return false;

  const Surroundings near(problem, from);
  std::vector<int> held;
  int furthest = 0;
  while (off(here).maxCoeff(&furthest) >= same_place) {
    if (std::ranges::find(held, furthest) != held.end()) return false;
    held.push_back(furthest);
    const double start = here[furthest];
    for (int step = 1; step <= steps; ++step) {
      here[furthest] = start + (to.searched[furthest] - start) * step / steps;
      const auto point = near.fit_others(here, held);
      if (!(point.rise < barrier)) return false;
      here = point.searched;
    }
  }
  return true;
}

}  // namespace

std::vector<Minimum> find_minima(const CalibrationProblem& problem, const SearchOptions& options) {
  check_problem(problem);
  Evaluator evaluator(problem);
  std::vector<Minimum> found;
  const auto starts = promising_points(evaluator, options);
  Progress progress("fits from the best starts", static_cast<long>(starts.size()));
  for (const VectorXd& start : starts) {
    found.push_back(settle(evaluator, start, {}, options));
    progress.add();
  }

  // Converged ones first, then by deviance: those that did not converge are no minima unless nothing else was found.
  std::ranges::stable_sort(found, [](const Minimum& a, const Minimum& b) {
    return a.converged != b.converged ? a.converged : a.deviance < b.deviance;
  });
  std::vector<Minimum> distinct;
  for (Minimum& minimum : found) {
    if (!distinct.empty() && !minimum.converged) continue;
    if (std::ranges::any_of(distinct, [&](const Minimum& kept) { return connected(problem, kept, minimum); })) continue;
    minimum.evaluations = evaluator.evaluations();
    distinct.push_back(std::move(minimum));
  }
  return distinct;
}

}  // namespace percal
