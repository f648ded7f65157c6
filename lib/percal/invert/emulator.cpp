#include "percal/invert/emulator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "percal/base/error.hpp"
#include "percal/invert/depth_covariance.hpp"
#include "percal/invert/emulator_search.hpp"
#include "percal/math/gaussian_process.hpp"

namespace percal {
namespace {

constexpr double normal95 = 1.959963984540054;
constexpr double equal_gains = 1e-9;  // gains that differ by less differ by rounding: the first counts

const std::vector<TrainingRun>& checked(const std::vector<TrainingRun>& runs) {
  if (static_cast<int>(runs.size()) < fewest_training_runs)
    throw BadInput({}, fmt::format("{} runs to learn from", runs.size()),
                   fmt::format("{} or more", fewest_training_runs));
  for (const TrainingRun& run : runs) {
    if (!in_order(run.at).allFinite() || !std::isfinite(run.log_depth) || !std::isfinite(run.h) || !(run.h > 0) ||
        !(run.at.erosion_strain > 0) || std::ranges::any_of(cover_members, [&](const CoverMembers& cover) {
          return run.at.*cover.depth != 0 && !(run.at.*cover.depth > 0 && run.at.*cover.strain > 0);
        }))
      throw BadInput({}, "a run to learn from whose numbers cannot be those of an impact",
                     "finite numbers, an element size and erosion strains above 0");
  }
  return runs;
}

GaussianProcess conditioned(const DepthCovariance& covariance, const TrainingData& data) {
  auto process = GaussianProcess::conditioned(covariance.of_runs(data.points), data.values);
  if (!process)
    throw BadInput({}, "settings of the emulator with which its covariance is not positive definite",
                   "a noise that is not so small beside the amplitude");
  return *std::move(process);
}

}  // namespace

Eigen::VectorXd in_order(const SphereInputs& at) {
  Eigen::VectorXd all(sphere_inputs);
  for (int k = 0; k < sphere_inputs; ++k) all[k] = at.*sphere_input_order[k];
  return all;
}

void lay_on(SphereInputs& at, const CoverMembers& place, const CoverNumbers& cover) {
  at.*place.depth = std::log1p(cover.thickness);
  at.*place.log_density = std::log(cover.density);
  at.*place.log_mu = std::log(cover.mu);
  at.*place.alpha = cover.alpha;
  at.*place.strain = cover.erosion_strain;
}

struct Emulator::State {
  State(std::vector<TrainingRun> given, const EmulatorSettings& found)
      : runs(std::move(given)),
        settings(found),
        data(checked(runs)),
        covariance(covariance_parameters(settings, data.scale), data.plane_deviation),
        process(conditioned(covariance, data)),
        mean(covariance, data.points, process.weights()) {}

  MeshPoints points(const std::vector<SphereInputs>& at, double h) const {
    MeshPoints points{Eigen::MatrixXd(at.size(), data.scale.inputs()),
                      Eigen::VectorXd::Constant(static_cast<Eigen::Index>(at.size()), h / reference_h)};
    for (std::size_t i = 0; i < at.size(); ++i) points.inputs.row(i) = data.scale.scaled(at[i]).transpose();
    return points;
  }

  std::vector<TrainingRun> runs;
  EmulatorSettings settings;
  TrainingData data;
  DepthCovariance covariance;
  GaussianProcess process;
  WeightedCovariance mean;
};

Emulator::Emulator(std::vector<TrainingRun> runs, const EmulatorOptions& options) {
  const EmulatorSettings settings = find_settings(checked(runs), options);
  state_ = std::make_shared<const State>(std::move(runs), settings);
}

Emulator::Emulator(std::vector<TrainingRun> runs, const EmulatorSettings& settings)
    : state_(std::make_shared<const State>(std::move(runs), settings)) {}

DepthAnswers Emulator::depth(const std::vector<SphereInputs>& at, double h, bool with_covariance) const {
  const auto& [runs, settings, data, covariance, process, mean] = *state_;
  const MeshPoints points = state_->points(at, h);
  const auto count = static_cast<Eigen::Index>(at.size());
  DepthAnswers answers{Eigen::VectorXd(count), Eigen::MatrixXd(count, sphere_inputs), {}};
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto sum = mean.at(points.inputs.row(i).transpose(), points.h[i]);
    answers.log_depth[i] = data.mean + sum.value;
    answers.gradient.row(i) = data.scale.unscaled_gradient(at[i], sum.gradient).transpose();
  }
  if (!with_covariance) return answers;
  const Eigen::MatrixXd known = process.whitened(covariance.between(data.points, points));
  const Eigen::MatrixXd left = covariance.between(points, points) - known.transpose() * known;
  answers.covariance = 0.5 * (left + left.transpose());
  answers.covariance.diagonal() = answers.covariance.diagonal().cwiseMax(0);
  return answers;
}

LeaveOneOut Emulator::leave_one_out() const {
  const LeftOutValues left_out = state_->process.leave_one_out();
  const Eigen::VectorXd standardised = left_out.error.cwiseQuotient(left_out.deviation);
  const double n = static_cast<double>(left_out.error.size());
  LeaveOneOut result;
  result.error.assign(left_out.error.begin(), left_out.error.end());
  result.standardised.assign(standardised.begin(), standardised.end());
  result.root_mean_square = std::sqrt(left_out.error.squaredNorm() / n);
  result.standardised_deviation = std::sqrt(standardised.squaredNorm() / n);
  result.coverage95 = static_cast<double>((standardised.array().abs() <= normal95).count()) / n;
  return result;
}

const EmulatorSettings& Emulator::settings() const { return state_->settings; }
const std::vector<TrainingRun>& Emulator::runs() const { return state_->runs; }
double Emulator::noise(double h) const { return state_->covariance.noise(h / reference_h); }

// With P the covariance of what is known so far, a run at c with noise variance n takes P_tc^2/(P_cc + n) from the variance at t.
// Afterwards P - P_.c P_c./(P_cc + n) is known; only columns that are asked for are computed. docs/theory/emulator.md (12)
std::vector<int> Emulator::choose(const std::vector<CandidateRun>& candidates, int count,
                                  const std::vector<SphereInputs>& targets, const std::vector<double>& weights,
                                  double h_target) const {
  assert(targets.size() == weights.size());
  const auto& [runs, settings, data, covariance, process, mean] = *state_;
  const auto size = static_cast<Eigen::Index>(candidates.size());
  std::vector<SphereInputs> places;
  Eigen::VectorXd h(size), noise_variance(size), cost(size);
  for (Eigen::Index c = 0; c < size; ++c) {
    places.push_back(candidates[c].at);
    h[c] = candidates[c].h / reference_h;
    noise_variance[c] = covariance.noise(h[c]) * covariance.noise(h[c]);
    cost[c] = candidates[c].cost;
  }
  MeshPoints points = state_->points(places, reference_h);
  points.h = h;
  const MeshPoints target_points = state_->points(targets, h_target);
  const Eigen::MatrixXd known = process.whitened(covariance.between(data.points, points));
  const Eigen::MatrixXd known_targets = process.whitened(covariance.between(data.points, target_points));
  const Eigen::Map<const Eigen::VectorXd> weight(weights.data(), static_cast<Eigen::Index>(weights.size()));

  Eigen::MatrixXd with_targets = covariance.between(target_points, points) - known_targets.transpose() * known;
  Eigen::VectorXd variance = covariance.variances(points) - known.colwise().squaredNorm().transpose();
  variance = variance.cwiseMax(0);
  Eigen::MatrixXd updates(size, 0);  // a column for each chosen run: P_.c/sqrt(P_cc + n)
  std::vector<int> chosen;
  std::vector<bool> taken(candidates.size(), false);
  while (static_cast<int>(chosen.size()) < std::min(count, static_cast<int>(size))) {
    const Eigen::VectorXd gain =
        (with_targets.cwiseAbs2().transpose() * weight).cwiseQuotient((variance + noise_variance).cwiseProduct(cost));
    Eigen::Index best = -1;
    for (Eigen::Index c = 0; c < size; ++c)
      if (!taken[c] && (best < 0 || gain[c] > (1 + equal_gains) * gain[best])) best = c;
    taken[best] = true;
    chosen.push_back(static_cast<int>(best));

    const double deviation = std::sqrt(variance[best] + noise_variance[best]);
    const MeshPoints one{points.inputs.row(best), points.h.segment(best, 1)};
    const Eigen::VectorXd update = (covariance.between(points, one) - known.transpose() * known.col(best) -
                                    updates * updates.row(best).transpose()) /
                                   deviation;
    const Eigen::VectorXd target_update = with_targets.col(best) / deviation;
    with_targets -= target_update * update.transpose();
    variance = (variance - update.cwiseAbs2()).cwiseMax(0);
    updates.conservativeResize(Eigen::NoChange, updates.cols() + 1);
    updates.rightCols(1) = update;
  }
  return chosen;
}

}  // namespace percal
