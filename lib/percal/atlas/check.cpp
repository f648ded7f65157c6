#include "percal/atlas/check.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>

#include "percal/campaign/sphere_runs.hpp"
#include "percal/math/distributions.hpp"

namespace percal {
namespace {

constexpr double by_chance = 1e-3;

// Half-way between a run and its nearest neighbour, in every input.
TrainingRun between_neighbours(const Atlas& atlas, std::size_t k) {
  const auto two = nearest_runs(atlas.runs, 2, feature_distance(atlas.runs[k].at));
  TrainingRun middle;
  for (double SphereInputs::*input : sphere_input_order)
    middle.at.*input = 0.5 * (two.front().at.*input + two.back().at.*input);
  middle.h = std::sqrt(two.front().h * two.back().h);
  return middle;
}

}  // namespace

std::vector<CheckedPoint> check_atlas(const Atlas& atlas, int count, Campaign& campaign, Progress& progress) {
  std::vector<TrainingRun> wanted;
  std::vector<Problem> problems;
  for (int k = 0; k < count; ++k) {
    wanted.push_back(
        between_neighbours(atlas, atlas.runs.size() * static_cast<std::size_t>(k) / static_cast<std::size_t>(count)));
    problems.push_back(problem_of(atlas.setting, wanted.back()));
  }
  const auto evaluations = campaign.evaluate(problems, &progress);
  std::vector<CheckedPoint> points;
  for (std::size_t k = 0; k < problems.size(); ++k)
    if (const auto reach = reach_of(problems[k], evaluations[k].result))
      points.push_back({.run = training_run(problems[k], *reach)});
  campaign.side_by_side(static_cast<int>(points.size()), [&](int k) {
    CheckedPoint& point = points[static_cast<std::size_t>(k)];
    const Emulator near = emulator_near(atlas, point.run.at);
    const DepthAnswers said = near.depth({point.run.at}, point.run.h, true);
    point.log_depth = said.log_depth[0];
    point.deviation = std::hypot(std::sqrt(said.covariance(0, 0)), near.noise(point.run.h));
  });
  return points;
}

AtlasAgreement agreement(const std::vector<CheckedPoint>& points) {
  AtlasAgreement found{.points = static_cast<int>(points.size())};
  if (points.empty()) return found;
  std::vector<double> sizes;
  for (const CheckedPoint& point : points) {
    const double error = point.error(), standardised = error / point.deviation;
    sizes.push_back(std::abs(error));
    found.root_mean_square += error * error / found.points;
    found.standardised += standardised * standardised / found.points;
    found.within95 += std::abs(standardised) <= normal_quantile(0.975);
  }
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  found.median = *middle;
  found.root_mean_square = std::sqrt(found.root_mean_square);
  found.standardised = std::sqrt(found.standardised);
  return found;
}

bool holds(const AtlasAgreement& agreement) {
  const auto outside = static_cast<unsigned>(agreement.points - agreement.within95);
  return outside == 0 || gsl_cdf_binomial_Q(outside - 1, 0.05, static_cast<unsigned>(agreement.points)) > by_chance;
}

}  // namespace percal
