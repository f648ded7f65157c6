#include "percal/fit/point_bootstrap.hpp"

#include <algorithm>
#include <set>

#include "percal/base/progress.hpp"
#include "percal/math/draws.hpp"

namespace percal {
namespace {

std::vector<int> draw(std::size_t count, Draws& draws) {
  std::vector<int> rows(count);
  for (int& row : rows) row = draws.index(static_cast<int>(count));
  return rows;
}

// The value below which a share of the sorted numbers lies, straight between neighbours.
double quantile(const std::vector<double>& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const auto above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

Interval percentiles(const FreeParameter& parameter, const Eigen::VectorXd& searched, double level) {
  std::vector<double> sorted(searched.begin(), searched.end());
  std::sort(sorted.begin(), sorted.end());
  return {parameter.natural(quantile(sorted, (1 - level) / 2)), parameter.natural(quantile(sorted, (1 + level) / 2))};
}

}  // namespace

CalibrationProblem drawn(const CalibrationProblem& problem, const std::vector<int>& rows) {
  CalibrationProblem part;
  part.parameters = problem.parameters;
  part.groups = problem.groups;
  for (const int row : rows) part.data.push_back(problem.data[static_cast<std::size_t>(row)]);
  part.model = [&problem, rows](const Eigen::VectorXd& searched, Want want) {
    const ModelAnswer whole = problem.model(searched, want);
    ModelAnswer answer{whole.value(rows), whole.jacobian(rows, Eigen::all), {}};
    if (whole.covariance.size() > 0) answer.covariance = whole.covariance(rows, rows);
    return answer;
  };
  return part;
}

Bootstrap bootstrap_over_points(const CalibrationProblem& problem, const Minimum& minimum, int replicates, double level,
                                unsigned seed, const SearchOptions& options) {
  Draws draws(seed);
  const std::size_t parameters = problem.parameters.size();
  std::vector<Eigen::VectorXd> found;
  Bootstrap bootstrap;
  Progress progress("bootstrap over points", replicates);
  for (int replicate = 0; replicate < replicates; ++replicate) {
    const auto rows = draw(problem.data.size(), draws);
    const bool enough = std::set<int>(rows.begin(), rows.end()).size() > parameters;
    const Minimum refitted = enough ? refine(drawn(problem, rows), minimum.searched, {}, options) : Minimum{};
    if (refitted.converged) found.push_back(refitted.searched);
    progress.add();
  }
  bootstrap.failed = replicates - static_cast<int>(found.size());
  bootstrap.searched.resize(static_cast<Eigen::Index>(found.size()), static_cast<Eigen::Index>(parameters));
  for (std::size_t k = 0; k < found.size(); ++k)
    bootstrap.searched.row(static_cast<Eigen::Index>(k)) = found[k].transpose();
  if (found.size() > 1)
    for (std::size_t k = 0; k < parameters; ++k)
      bootstrap.intervals.push_back(
          percentiles(problem.parameters[k], bootstrap.searched.col(static_cast<Eigen::Index>(k)), level));
  return bootstrap;
}

}  // namespace percal
