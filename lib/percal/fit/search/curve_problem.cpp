#include "percal/fit/search/curve_problem.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "percal/base/error.hpp"
#include "percal/units/words.hpp"

namespace percal {
namespace {

std::string stem(const std::string& file) { return std::filesystem::path(file).stem().string(); }

// "tension" or "compression" of a uniaxial point, empty otherwise.
std::string side(const Strained& strained) {
  if (strained.deformation != Deformation::uniaxial) return "";
  return strained.amount < 1 ? "compression" : "tension";
}

std::string name_of(const StressPoint& point, const CurveData& data) {
  const std::string sense = side(point.strained);
  const std::string test = word(point.strained.deformation) + (sense.empty() ? "" : " " + sense);
  return data.sources.size() < 2 ? test : stem(data.sources[point.source].file) + " " + test;
}

bool left_out(const StressPoint& point, CurveProblem& problem) {
  if (problem.residual == Residual::relative && point.nominal_stress == 0) {
    ++problem.left_out_zero_stress;
    return true;
  }
  if (problem.residual == Residual::error && !(point.standard_error && *point.standard_error > 0)) {
    ++problem.left_out_no_error;
    return true;
  }
  return false;
}

// 1 over what the residual is relative to, per unit of scaled stress.
double point_weight(const StressPoint& point, const CurveProblem& problem) {
  switch (problem.residual) {
    case Residual::relative: return problem.scale / point.nominal_stress;
    case Residual::error: return problem.scale / *point.standard_error;
    case Residual::absolute: break;
  }
  return 1;
}

int index_of_test(const StressPoint& point, const CurveData& data, CurveProblem& problem) {
  for (std::size_t i = 0; i < problem.tests.size(); ++i)
    if (belongs(point, data, problem.tests[i])) return static_cast<int>(i);
  problem.tests.push_back({.name = name_of(point, data),
                           .file = data.sources.empty() ? "" : data.sources[point.source].file,
                           .source = point.source,
                           .deformation = point.strained.deformation});
  return static_cast<int>(problem.tests.size()) - 1;
}

// How much each test counts as a whole.
std::vector<double> shares(const CurveProblem& problem, const EqualTests& weighting) {
  std::vector<double> share(problem.tests.size(), 1.0);
  for (const auto& [name, number] : weighting.of_test) {
    bool found = false;
    for (std::size_t i = 0; i < problem.tests.size(); ++i)
      if (is_meant(name, problem.tests[i])) share[i] = number, found = true;
    if (found) continue;
    std::vector<std::string> names;
    for (const auto& test : problem.tests) names.push_back(test.name);
    throw BadInput({"", 0, "--weights"}, "no test " + in_quotes(name), listed(names));
  }
  return share;
}

// Weights with the mean 1 over all points, so that sums stay comparable.                                (20)
void weigh_tests(CurveProblem& problem, const EqualTests& weighting) {
  const auto share = shares(problem, weighting);
  double sum = 0, rows = 0;
  for (std::size_t i = 0; i < share.size(); ++i) sum += share[i], rows += problem.tests[i].rows;
  for (std::size_t i = 0; i < share.size(); ++i)
    problem.tests[i].weight = share[i] / sum * rows / problem.tests[i].rows;
  for (auto& point : problem.points) point.weight *= std::sqrt(problem.tests[point.test].weight);
}

}  // namespace

bool belongs(const StressPoint& point, const CurveData& data, const CurveTest& test) {
  return point.source == test.source && point.strained.deformation == test.deformation &&
         name_of(point, data) == test.name;
}

bool is_meant(const std::string& name, const CurveTest& test) {
  if (name == "tension" || name == "compression") return test.name.ends_with(name);
  return name == stem(test.file) || name == test.name || deformation_of(name) == test.deformation;
}

CurveProblem curve_problem(const CurveData& data, Residual residual, const Weighting& weighting) {
  CurveProblem problem;
  problem.residual = residual;
  std::vector<const StressPoint*> used;
  double largest = 0;
  for (const auto& point : data.points) {
    if (left_out(point, problem)) continue;
    used.push_back(&point);
    largest = std::max(largest, std::abs(point.nominal_stress));
  }
  if (residual == Residual::error && used.empty() && !data.points.empty())
    throw BadInput(
        "found no standard errors above zero; accepted: a column of them (sem_kPa, stress_sd_kPa) for "
        "error-weighted residuals");
  if (largest == 0 && !used.empty())
    throw BadInput("found no stress that differs from zero; accepted: curves with stress");
  if (largest > 0) problem.scale = largest;
  if (residual == Residual::absolute) problem.objective_unit = problem.scale * problem.scale;
  std::set<std::pair<double, double>> different;
  for (const StressPoint* point : used) {
    const PrincipalPair pair = principal_pair(point->strained);
    const int test = index_of_test(*point, data, problem);
    const double weight = point_weight(*point, problem) * std::sqrt(point->rows);
    problem.points.push_back({pair, point->nominal_stress / problem.scale, weight, test});
    problem.rows.push_back(static_cast<std::size_t>(point - data.points.data()));
    ++problem.tests[test].points;
    problem.tests[test].rows += point->rows;
    ++problem.points_of_mode[point->strained.deformation];
    if (pair.log_i != pair.log_j) different.insert({pair.log_i, pair.log_j});
  }
  problem.different = static_cast<int>(different.size());
  if (const auto* tests = std::get_if<EqualTests>(&weighting)) weigh_tests(problem, *tests);
  return problem;
}

CurveResiduals residuals_of(const CurveProblem& problem, Model model, const Hyperelastic& solid) {
  const auto terms = static_cast<Eigen::Index>(solid.terms.size());
  const bool free = fixed_alphas(model).empty();
  CurveResiduals residuals{Eigen::VectorXd(problem.points.size()),
                           Eigen::MatrixXd(problem.points.size(), free ? 2 * terms : terms)};
  for (std::size_t i = 0; i < problem.points.size(); ++i) {
    const auto& point = problem.points[i];
    double model_stress = 0;
    for (Eigen::Index k = 0; k < terms; ++k) {
      const double mu = solid.terms[k].mu / problem.scale;
      const UnitTerm unit = unit_term(solid.terms[k].alpha, point.pair);
      model_stress += mu * unit.stress;
      residuals.jacobian(i, k) = -point.weight * mu * unit.stress;
      if (free) residuals.jacobian(i, terms + k) = -point.weight * mu * unit.by_alpha;
    }
    residuals.value(i) = point.weight * (point.stress - model_stress);
  }
  return residuals;
}

std::optional<double> aicc(double sum_of_squares, std::size_t points, int parameters) {
  const double n = static_cast<double>(points), k = parameters + 1;
  if (!(n - k - 1 > 0) || !(sum_of_squares > 0)) return std::nullopt;
  return n * std::log(sum_of_squares / n) + 2 * k + 2 * k * (k + 1) / (n - k - 1);
}

std::string word(Residual residual) {
  switch (residual) {
    case Residual::relative: return "relative";
    case Residual::error: return "error";
    case Residual::absolute: break;
  }
  return "absolute";
}

}  // namespace percal
