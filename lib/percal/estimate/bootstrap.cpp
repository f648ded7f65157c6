#include <algorithm>
#include <cmath>

#include "percal/base/progress.hpp"
#include "percal/base/threads.hpp"
#include "percal/estimate/profile.hpp"
#include "percal/math/draws.hpp"
#include "percal/math/grid_convergence.hpp"

namespace percal {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// The whitened residuals of each group, made as large as the errors they are the remains of (divided by sqrt(1 - leverage)) and
// moved to the mean 0.                                                                                                (14)
std::vector<std::vector<double>> residual_pools(const Surroundings& near) {
  const auto& problem = near.problem();
  const Whitened white = whiten(problem, near.weights(), near.answer(), near.minimum().searched);
  std::vector<std::vector<double>> pools(problem.groups.size());
  for (std::size_t i = 0; i < problem.data.size(); ++i) {
    if (!problem.data[i].is_number()) continue;
    const double leverage = white.jacobian.row(i) * near.minimum().covariance * white.jacobian.row(i).transpose();
    pools[problem.data[i].group].push_back(white.residual[i] / std::sqrt(std::max(1 - leverage, 1e-6)));
  }
  for (auto& pool : pools) {
    double mean = 0;
    for (const double residual : pool) mean += residual / static_cast<double>(pool.size());
    for (double& residual : pool) residual -= mean;
  }
  return pools;
}

// Independent errors of unit size, one for each datum.
VectorXd draw_errors(const CalibrationProblem& problem, const std::vector<std::vector<double>>& pools,
                     BootstrapKind kind, Draws& draws) {
  VectorXd errors(problem.data.size());
  for (int i = 0; i < errors.size(); ++i) {
    const auto& pool = pools[problem.data[i].group];
    errors[i] = kind == BootstrapKind::parametric || pool.empty() ? draws.normal()
                                                                  : pool[draws.index(static_cast<int>(pool.size()))];
  }
  return errors;
}

// The errors with their sizes and correlations: L e.
VectorXd coloured(const Weights& weights, const VectorXd& errors) {
  VectorXd sized = weights.deviation.cwiseProduct(errors);
  if (!weights.correlated.empty())
    sized(weights.correlated) = weights.factor.triangularView<Eigen::Lower>() * VectorXd(errors(weights.correlated));
  return sized;
}

CalibrationProblem drawn_anew(const Surroundings& near, const std::vector<std::vector<double>>& pools,
                              BootstrapKind kind, Draws& draws) {
  CalibrationProblem problem = near.problem();
  const VectorXd drawn = near.answer().value + coloured(near.weights(), draw_errors(problem, pools, kind, draws));
  for (std::size_t i = 0; i < problem.data.size(); ++i) {
    Datum& datum = problem.data[i];
    const double beyond = drawn[i] - datum.value;
    if (datum.seen == Seen::above || datum.seen == Seen::below) {
      datum.seen = beyond > 0 ? Seen::above : Seen::below;
    } else if (datum.is_number() || side(datum.seen) * beyond < 0) {
      datum.seen = Seen::number;
      datum.value = drawn[i];
    }
  }
  for (int k = 0; k < static_cast<int>(problem.parameters.size()); ++k) {
    FreeParameter& free = problem.parameters[k];
    if (free.prior) free.prior = free.natural(near.minimum().searched[k] + free.prior_error * draws.normal());
  }
  return problem;
}

Interval percentiles(const FreeParameter& free, const VectorXd& searched, double level) {
  const std::vector<double> values(searched.begin(), searched.end());
  const double low = quantile(values, (1 - level) / 2), high = quantile(values, (1 + level) / 2);
  return {free.natural(low), free.natural(high), low <= free.searched(free.low), high >= free.searched(free.high)};
}

}  // namespace

Bootstrap bootstrap(const CalibrationProblem& problem, const Minimum& minimum, BootstrapKind kind, int replicates,
                    double level, unsigned seed, const SearchOptions& options) {
  const Surroundings near(problem, minimum);
  const auto pools = residual_pools(near);
  const std::vector<int> free = free_parameters(problem, {});
  Draws draws(seed);
  std::vector<CalibrationProblem> drawn;
  for (int replicate = 0; replicate < replicates; ++replicate) drawn.push_back(drawn_anew(near, pools, kind, draws));
  std::vector<FrozenFit> fits(drawn.size());
  Progress progress("bootstrap", replicates);
  side_by_side(options.threads, replicates, [&](int replicate) {
    Evaluator evaluator(drawn[replicate]);
    fits[replicate] = frozen_fit(evaluator, near.weights(), minimum.searched, free);
    progress.add();
  });
  std::vector<VectorXd> fitted;
  for (const FrozenFit& fit : fits)
    if (fit.converged) fitted.push_back(fit.searched);

  Bootstrap result;
  result.failed = replicates - static_cast<int>(fitted.size());
  result.searched.resize(static_cast<int>(fitted.size()), static_cast<int>(free.size()));
  for (std::size_t i = 0; i < fitted.size(); ++i) result.searched.row(i) = fitted[i].transpose();
  if (!fitted.empty())
    for (const int k : free)
      result.intervals.push_back(percentiles(problem.parameters[k], result.searched.col(k), level));
  return result;
}

}  // namespace percal
