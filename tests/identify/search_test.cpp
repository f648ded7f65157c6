// The ridge and alpha's scan where the atlas knows the calibration's setting, and where it does not.
#include <gtest/gtest.h>

#include <cmath>

#include "percal/identify/alpha_scan.hpp"
#include "percal/identify/impacts.hpp"
#include "percal/identify/ridge.hpp"

namespace percal {
namespace {

// Glass into skin on 6 elements per radius; `width`: radii, 5 are what so slow a shot asks for.
IdentifyJob glass_into_skin(double width) {
  IdentifyJob job;
  job.tissue.density = 1000;
  job.calibration.radius = 10e-6;
  job.calibration.density = 8000;
  job.calibration.speed = 300;
  job.penetration = 130e-6;
  job.penetration_error = 5e-6;
  job.layer = {.depth = 40, .width = width};
  job.volumetric = BulkToShear{50};
  job.ridge = {.erosion_strains = {0.5, 0.7}, .start = 3e6, .elements_per_radius = 6, .replicates = 3};
  return job;
}

struct Searched {
  std::vector<RidgePoint> ridge;
  long runs;
};
Searched searched(double width) {
  Campaign campaign(nullptr, 2);
  const auto ridge = find_ridge(campaign, glass_into_skin(width), 8);
  return {ridge, campaign.cost().runs};
}

// A wall a thousandth nearer has no atlas, and next to the same depths.
TEST(Ridge, BegunByTheAtlasNeedsFewerRunsForTheSameModuli) {
  const Searched begun = searched(5), alone = searched(4.999);
  EXPECT_LT(begun.runs, 0.5 * static_cast<double>(alone.runs));
  for (std::size_t k = 0; k < begun.ridge.size(); ++k) {
    const RidgePoint &one = begun.ridge[k], &other = alone.ridge[k];
    ASSERT_EQ(one.inversion.outcome, InversionOutcome::found);
    EXPECT_LT(std::abs(std::log(one.mu / other.mu)), 3 * std::hypot(one.solver_error, other.solver_error));
    EXPECT_LT(one.solver_error, one.data_error);
    EXPECT_GE(one.inversion.points_in_line, 5);
  }
}

TEST(AlphaScan, WhereTheAtlasKnowsTheScatterOneRunACandidateIsEnough) {
  const auto scanned = [](double width) {
    const AlphaScan scan{.candidates = {6, 6.5, 7, 7.5, 8, 8.5, 9, 9.5, 10, 10.5},
                         .target_name = "",
                         .file = "",
                         .target = {{.mu = 15e6, .erosion_strain = 0.7, .mu_model = {}}},
                         .elements_per_radius = 8,
                         .replicates = 3};
    Campaign campaign(nullptr, 2);
    const auto trials = run_alpha_trials(campaign, glass_into_skin(width), scan);
    return std::pair(campaign.cost().runs, trials);
  };
  const auto [few, with] = scanned(5);
  const auto [many, without] = scanned(4.999);
  EXPECT_EQ(few, 10);
  EXPECT_EQ(many, 30);
  double sum = 0;
  for (std::size_t k = 0; k < with.size(); ++k) sum += (with[k].log_misfit - without[k].log_misfit) / 10;
  EXPECT_NEAR(sum, 0, 0.04) << "three errors of a mean of ten runs";
}

TEST(BesideTheAtlas, AShotIsRunAsOftenAsItsErrorNeeds) {
  const auto shot = [](double width, bool beside) {
    const IdentifyJob job = glass_into_skin(width);
    const Scene scene = impact_scene(job, job.calibration, {1000, 15e6, 8, 0.7}, job.volumetric, 8);
    Campaign campaign(nullptr, 2);
    return beside ? shoot_beside_atlas(campaign, {scene}, usual_replicates, "").front()
                  : shoot(campaign, {scene}, usual_replicates, "").front();
  };
  const Shooting few = shot(5, true), many = shot(5, false), unknown = shot(4.999, true);
  EXPECT_LT(few.runs.size(), many.runs.size());
  EXPECT_TRUE(few.penetration.is_joined);
  EXPECT_FALSE(unknown.penetration.is_joined);
  EXPECT_EQ(unknown.runs.size(), static_cast<std::size_t>(usual_replicates));
  const double apart = std::log(*few.penetration.depth / *many.penetration.depth);
  EXPECT_LT(std::abs(apart), 3 * std::hypot(*few.penetration.standard_error / *few.penetration.depth,
                                            *many.penetration.standard_error / *many.penetration.depth));
}

TEST(BesideTheAtlas, RunsThatDoNotAgreeWithItStandAlone) {
  const IdentifyJob job = glass_into_skin(5);
  const Scene scene = impact_scene(job, job.calibration, {1000, 15e6, 8, 0.7}, job.volumetric, 6);
  Campaign campaign(nullptr, 2);
  const auto depth = shoot(campaign, {scene}, usual_replicates, "").front().penetration.depth;
  ASSERT_TRUE(depth);
  const auto wrong = [&](const Shooting&) {
    return std::optional(AtlasDepth{.depth = 1.3 * *depth, .deviation = 0.01, .noise = 0.03, .width = 20});
  };
  const Shooting found = shoot_beside_atlas(campaign, {scene}, usual_replicates, "", wrong).front();
  EXPECT_FALSE(found.penetration.is_joined);
  EXPECT_EQ(found.runs.size(), static_cast<std::size_t>(usual_replicates));
  EXPECT_EQ(*found.penetration.depth, *depth);
}

}  // namespace
}  // namespace percal
