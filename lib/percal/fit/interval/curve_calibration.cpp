#include "percal/fit/interval/curve_calibration.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "percal/base/progress.hpp"
#include "percal/math/distributions.hpp"
#include "percal/math/draws.hpp"

namespace percal {
namespace {

constexpr double exact = 1e-20;          // share of the data's sum of squares that is only rounding
constexpr double errors_refuted = 0.01;  // chance of so large a misfit below which standard errors are not believed
constexpr int fewest_neighbours = 8;     // pairs of points for a correlation

// "mu" and "alpha" of one term; "mu_1", "alpha_1", .. of several.
std::string numbered(const std::string& symbol, std::size_t term, std::size_t terms) {
  return terms == 1 ? symbol : symbol + "_" + std::to_string(term + 1);
}

// `largest` is that of the solid's moduli: where signs are free, a small one may grow to its size and change its sign.
FreeParameter modulus(const std::string& name, double mu, double largest, Signs signs) {
  FreeParameter parameter;
  parameter.name = name;
  parameter.unit = "Pa";
  parameter.logarithmic = signs == Signs::positive;
  parameter.high = (parameter.logarithmic ? mu : largest) * modulus_reach;
  parameter.low = parameter.logarithmic ? mu / modulus_reach : -parameter.high;
  return parameter;
}

FreeParameter exponent(const std::string& name, double alpha, bool even) {
  FreeParameter parameter;
  parameter.name = name;
  parameter.logarithmic = false;
  parameter.low = even && alpha >= 0 ? 0 : -largest_alpha;
  parameter.high = even && alpha < 0 ? 0 : largest_alpha;
  return parameter;
}

// The model's weighted stresses: sum_k mu_k f(alpha_k).
struct WeightedStress {
  const CurveProblem& problem;
  std::vector<double> alphas;  // the fixed ones; overwritten by the searched where they are free
  bool free_alphas;
  bool logarithmic;

  ModelAnswer operator()(const Eigen::VectorXd& at, Want) const {
    const auto rows = static_cast<Eigen::Index>(problem.points.size());
    const auto terms = static_cast<Eigen::Index>(alphas.size());
    ModelAnswer answer;
    answer.value = Eigen::VectorXd::Zero(rows);
    answer.jacobian = Eigen::MatrixXd::Zero(rows, at.size());
    for (Eigen::Index k = 0; k < terms; ++k) {
      const double mu = (logarithmic ? std::exp(at[k]) : at[k]) / problem.scale;
      const double mu_slope = logarithmic ? mu : 1 / problem.scale;
      const double alpha = free_alphas ? at[terms + k] : alphas[static_cast<std::size_t>(k)];
      for (Eigen::Index i = 0; i < rows; ++i) {
        const auto& point = problem.points[static_cast<std::size_t>(i)];
        const UnitTerm unit = unit_term(alpha, point.pair);
        answer.value[i] += point.weight * mu * unit.stress;
        answer.jacobian(i, k) = point.weight * mu_slope * unit.stress;
        if (free_alphas) answer.jacobian(i, terms + k) = point.weight * mu * unit.by_alpha;
      }
    }
    return answer;
  }
};

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

ErrorSource error_source(const CurveProblem& problem, const CurveOptions& options, double sum_of_squares, int degrees) {
  const bool one_to_one =
      options.residual == Residual::error && options.loss == Loss::squares &&
      std::all_of(problem.tests.begin(), problem.tests.end(), [](const auto& test) { return test.weight == 1; });
  return one_to_one && chi_squared_tail(sum_of_squares, degrees) > errors_refuted ? ErrorSource::standard_errors
                                                                                  : ErrorSource::residuals;
}

bool lies_on_the_model(const CurveProblem& problem, double sum_of_squares) {
  double whole = 0;
  for (const auto& point : problem.points) whole += point.weight * point.stress * point.weight * point.stress;
  return sum_of_squares <= exact * whole;
}

std::optional<double> neighbour_correlation(const CurveProblem& problem, const Eigen::VectorXd& residual) {
  double product = 0;
  int pairs = 0;
  for (Eigen::Index i = 0; i + 1 < residual.size(); ++i) {
    if (problem.points[static_cast<std::size_t>(i)].test != problem.points[static_cast<std::size_t>(i) + 1].test)
      continue;
    product += residual[i] * residual[i + 1];
    ++pairs;
  }
  if (pairs < fewest_neighbours) return std::nullopt;
  return (product / pairs) / (residual.squaredNorm() / static_cast<double>(residual.size()));
}

CalibrationProblem calibration_of(const CurveProblem& problem, const CurveOptions& options, const Hyperelastic& solid,
                                  ErrorSource errors) {
  const bool known = errors == ErrorSource::standard_errors;
  CalibrationProblem calibration;
  calibration.groups.push_back({.name = "points", .estimated = !known, .fixed = 0});
  for (const auto& point : problem.points)
    calibration.data.push_back({.label = "", .value = point.weight * point.stress, .error = known ? 1.0 : 0.0});

  const std::size_t terms = solid.terms.size();
  double largest = 0;
  for (const auto& term : solid.terms) largest = std::max(largest, std::abs(term.mu));
  std::vector<double> alphas;
  for (std::size_t k = 0; k < terms; ++k) {
    calibration.parameters.push_back(modulus(numbered("mu", k, terms), solid.terms[k].mu, largest, options.signs));
    alphas.push_back(solid.terms[k].alpha);
  }
  const bool free_alphas = fixed_alphas(options.model).empty();
  for (std::size_t k = 0; k < terms && free_alphas; ++k)
    calibration.parameters.push_back(exponent(numbered("alpha", k, terms), alphas[k], even_in_alpha(problem)));
  calibration.model = WeightedStress{problem, alphas, free_alphas, options.signs == Signs::positive};
  return calibration;
}

Eigen::VectorXd searched(const CalibrationProblem& problem, const Hyperelastic& solid) {
  const std::size_t terms = solid.terms.size(), count = problem.parameters.size();
  Eigen::VectorXd at(static_cast<Eigen::Index>(count));
  for (std::size_t k = 0; k < count; ++k) {
    const auto& parameter = problem.parameters[k];
    const double natural = k < terms ? solid.terms[k].mu : solid.terms[k - terms].alpha;
    at[static_cast<Eigen::Index>(k)] = parameter.searched(std::clamp(natural, parameter.low, parameter.high));
  }
  return at;
}

bool even_in_alpha(const CurveProblem& problem) {
  return std::all_of(problem.points.begin(), problem.points.end(),
                     [](const auto& point) { return point.pair.log_j == -point.pair.log_i; });
}

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
