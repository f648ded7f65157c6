#include "percal/fit/polish.hpp"

#include <ceres/ceres.h>
#include <glog/logging.h>

#include <mutex>

namespace percal {
namespace {

// weight (stress - mu f(alpha)) of one point. The parameters are ln(mu/start_mu) and alpha, so that mu stays positive
// and both are of order 1 whatever the units.
struct StressResidual {
  WeightedPoint point;
  double start_mu;

  template <class T>
  bool operator()(const T* const parameters, T* residual) const {
    using std::exp;
    const OgdenOf<T> solid{start_mu * exp(parameters[0]), parameters[1]};
    residual[0] = point.weight * (point.stress - nominal_stress(solid, point.pair));
    return true;
  }
};

// glog prints on standard error even where Ceres is silent. A host that has set glog up itself keeps its settings.
void silence_glog() {
  static std::once_flag once;
  std::call_once(once, [] {
    if (google::IsGoogleLoggingInitialized()) return;
    google::InitGoogleLogging("percal");
    FLAGS_logtostderr = true;
    FLAGS_minloglevel = 3;
  });
}

void add_normal_matrix(const StressResidual& residual, const double* parameters, Polished& polished) {
  using Jet = ceres::Jet<double, 2>;
  const Jet at[2] = {Jet(parameters[0], 0), Jet(parameters[1], 1)};
  Jet value;
  residual(at, &value);
  polished.objective += value.a * value.a;
  polished.normal_matrix[0] += value.v[0] * value.v[0];
  polished.normal_matrix[1] += value.v[0] * value.v[1];
  polished.normal_matrix[2] += value.v[1] * value.v[1];
}

}  // namespace

Polished polish(const std::vector<WeightedPoint>& points, const Bracket& bracket) {
  silence_glog();
  double parameters[2] = {0, bracket.start.alpha};
  ceres::Problem problem;
  for (const auto& point : points)
    problem.AddResidualBlock(
        new ceres::AutoDiffCostFunction<StressResidual, 1, 2>(new StressResidual{point, bracket.start.mu}), nullptr,
        parameters);
  problem.SetParameterLowerBound(parameters, 1, bracket.low);
  problem.SetParameterUpperBound(parameters, 1, bracket.high);

  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = 500;
  options.function_tolerance = 1e-16;
  options.gradient_tolerance = 1e-14;
  options.parameter_tolerance = 1e-13;
  options.logging_type = ceres::SILENT;
  options.num_threads = 1;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);

  Polished polished{};
  polished.solid = {bracket.start.mu * std::exp(parameters[0]), parameters[1]};
  polished.converged = summary.termination_type == ceres::CONVERGENCE;
  polished.iterations = static_cast<int>(summary.iterations.size());
  for (const auto& point : points) add_normal_matrix({point, bracket.start.mu}, parameters, polished);
  return polished;
}

}  // namespace percal
