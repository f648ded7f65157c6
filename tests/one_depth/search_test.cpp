// The solver as the forward model: what was shot into is found again.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <map>

#include "one_depth/small_shot.hpp"
#include "percal/campaign/sphere_runs.hpp"
#include "percal/one_depth/page/page.hpp"
#include "percal/text/file.hpp"
#include "support/temporary_folder.hpp"

namespace percal {
namespace {

using testing::HasSubstr;

class OneDepthSearch : public testing::Test {
 protected:
  // The depth of the small shot in this material, with its own standard error, relative.
  struct Shot {
    double depth, error;
  };
  Shot shot_into(double mu, double strain) {
    InvertRequest request = understood(test::small_shot());
    request.material.mu_true = mu;
    request.material.erosion_strain = strain;
    const Reduction reduction = reduce(scene_of(request, request.material));
    const Penetration found =
        summarise(campaign_.replicate({reduction.problem}, 5, nullptr).front(), reduction.problem, reduction.scales);
    return {found.depth.value(), *found.standard_error / *found.depth};
  }
  // Between what was found and the truth, in the errors of both mean depths over the slope.
  static double off(const PairOfDepth& found, LayerNumber sought, double truth, const Shot& shot) {
    const double error = std::hypot(found.search.log_modulus_error, shot.error / std::abs(found.search.slope));
    return std::log(number_of(found.material, sought) / truth) / error;
  }
  static InvertWords words_for(double depth) {
    InvertWords words = test::small_shot();
    words.depth = std::to_string(1e3 * depth) + " mm";
    return words;
  }

  Campaign campaign_{nullptr, 2};
};

constexpr double mu = 500e3, strain = 1;

TEST_F(OneDepthSearch, FindsTheModulusOfARun) {
  const Shot shot = shot_into(mu, strain);
  const OneDepth found = find_at_depth(understood(words_for(shot.depth)), campaign_);
  ASSERT_TRUE(found.own().found()) << found.own().why_not;
  EXPECT_LT(std::abs(off(found.own(), LayerNumber::mu, mu, shot)), 3);
  EXPECT_GT(mu, found.own().interval->low);
  EXPECT_LT(mu, found.own().interval->high);
  EXPECT_GE(found.own().search.points_in_line, 10);
  EXPECT_LT(*found.ridge_exponent, -0.5);
}

TEST_F(OneDepthSearch, FindsTheErosionStrainOfARun) {
  const Shot shot = shot_into(mu, strain);
  InvertWords words = words_for(shot.depth);
  words.erosion_strain = "";
  words.mu = "500 kPa";
  words.speed_error = "1 %";
  const OneDepth found = find_at_depth(understood(words), campaign_);
  ASSERT_TRUE(found.own().found()) << found.own().why_not;
  EXPECT_LT(std::abs(off(found.own(), LayerNumber::erosion_strain, strain, shot)), 3);
  EXPECT_GT(strain, found.own().interval->low);
  EXPECT_LT(strain, found.own().interval->high);
  EXPECT_NEAR(*found.own().errors[1].of_value, 0.02 / std::abs(*found.ridge_exponent), 1e-12);
}

// What a faster shot asks for is what the speed's share says, of a modulus exactly.
TEST_F(OneDepthSearch, TheModulusGoesWithTheSquareOfTheSpeed) {
  const Shot shot = shot_into(mu, strain);
  InvertWords words = words_for(shot.depth);
  words.speed = "110 m/s";
  words.speed_error = "1 %";
  const OneDepth faster = find_at_depth(understood(words), campaign_);
  EXPECT_LT(std::abs(off(faster.own(), LayerNumber::mu, mu * 1.21, shot)), 3);
  EXPECT_NEAR(*faster.own().errors[1].of_value, 0.02, 1e-12);
}

// The same shot with its wall just below the 5 radii that the slowest shots ask for: there is no atlas, and the depth is another by 2 % at most.
TEST_F(OneDepthSearch, BegunByTheAtlasItNeedsFewerRunsForTheSameNumber) {
  const auto found_with = [&](const std::string& width, CampaignCost& cost) {
    InvertWords words = test::small_shot();
    words.depth_error = "5 %";
    words.elements_per_radius = "6";
    words.layer_width = width;
    Campaign campaign(nullptr, 2);
    OneDepth found = find_at_depth(understood(words), campaign);
    cost = campaign.cost();
    return found;
  };
  CampaignCost begun, alone;
  const OneDepth by_atlas = found_with("27 mm", begun), without = found_with("11.249 mm", alone);
  ASSERT_TRUE(by_atlas.own().found() && without.own().found());
  EXPECT_LT(begun.runs, 0.8 * static_cast<double>(alone.runs));
  const Inversion &one = by_atlas.own().search, &other = without.own().search;
  EXPECT_LT(std::abs(one.log_modulus - other.log_modulus),
            3 * std::hypot(one.log_modulus_error, other.log_modulus_error, 0.02 / std::abs(one.slope)));
  EXPECT_GE(other.points_in_line, 10) << "as ever";
  EXPECT_LT(by_atlas.own().interval->low, number_of(without.own().material, LayerNumber::mu));
  EXPECT_GT(by_atlas.own().interval->high, number_of(without.own().material, LayerNumber::mu));
}

TEST_F(OneDepthSearch, ItsAnswersComeFromAllPhasesOfTheMesh) {
  const test::TemporaryFolder folder;
  Store store(folder.path("store"));
  Campaign kept(&store, 2);
  find_at_depth(understood(test::small_shot()), kept);
  std::map<double, int> runs;
  for (const StoredSphere& sphere : stored_spheres(store)) ++runs[sphere.problem.elements_per_radius];
  EXPECT_EQ(runs.size(), 5u);
  for (const auto& [mesh, count] : runs) EXPECT_GE(count, 5) << mesh << ": a run of each search";
}

TEST_F(OneDepthSearch, HasTheSameBitsForAnyNumberOfThreads) {
  Campaign alone(nullptr, 1);
  EXPECT_EQ(one_depth_to_json(find_at_depth(understood(test::small_shot()), campaign_)),
            one_depth_to_json(find_at_depth(understood(test::small_shot()), alone)));
}

TEST_F(OneDepthSearch, WhereNothingIsFoundItSaysWhy) {
  InvertWords words = test::small_shot();
  words.depth = "0.1 mm";  // no layer is so stiff
  const OneDepth found = find_at_depth(understood(words), campaign_);
  EXPECT_FALSE(found.own().found());
  EXPECT_THAT(found.own().why_not, HasSubstr("out of reach: deeper from"));
  EXPECT_FALSE(found.own().interval);
  const page::Json json = one_depth_to_json(found);
  EXPECT_TRUE(json["pair"]["mu_Pa"].is_null());
  EXPECT_THAT(invert_page(json).summary, HasSubstr("out of reach"));
}

TEST_F(OneDepthSearch, RunsThatPassedThroughBesideTheAnswerAreToldOf) {
  InvertWords words = test::small_shot();
  EXPECT_THAT(find_at_depth(understood(words), campaign_).warnings,
              testing::Not(testing::Contains(HasSubstr("passed"))));
  words.depth = "38.5 mm";
  const OneDepth found = find_at_depth(understood(words), campaign_);
  ASSERT_TRUE(found.own().found()) << found.own().why_not;
  EXPECT_THAT(found.warnings, testing::Contains(HasSubstr("passed through the layer")));
}

TEST_F(OneDepthSearch, WithAnErosionLengthItSaysWhatElementsLeave) {
  InvertWords words = test::small_shot();
  words.erosion_length = "2 mm";
  const OneDepth found = find_at_depth(understood(words), campaign_);
  ASSERT_TRUE(found.own().found()) << found.own().why_not;
  EXPECT_THAT(found.findings.back(), HasSubstr("judged over a length"));
}

std::string scene_of_small_shot(double mu, const std::string& particle) {
  return fmt::format(
      "[particle]\n{}speed = \"100 m/s\"\n[target]\ndensity = \"1000 kg/m3\"\nmu = \"{:.17g} Pa\"\nalpha = 5\n"
      "depth = \"40 mm\"\nwidth = \"11.25 mm\"\n[target.erosion]\nstrain = 0.6931471805599453\nmeasure = \"true\"\n"
      "[mesh]\nelements_per_radius = 4\n",
      particle, mu);
}

std::string written(const test::TemporaryFolder& folder, const std::string& scene) {
  write_file(folder.path("shot.toml"), scene);
  return folder.path("shot.toml");
}

TEST_F(OneDepthSearch, ASceneOfTheSameShotHasTheSameAnswer) {
  const test::TemporaryFolder folder;
  const InvertRequest said = understood(test::small_shot());
  const std::string sphere = "diameter = \"4.5 mm\"\ndensity = \"2500 kg/m3\"\n";
  const InvertWords words{.scene = written(folder, scene_of_small_shot(said.material.mu_true, sphere)),
                          .depth = "20 mm",
                          .erosion_strain = "1"};
  EXPECT_EQ(one_depth_to_json(find_at_depth(understood(words), campaign_))["ridge"],
            one_depth_to_json(find_at_depth(said, campaign_))["ridge"]);
}

TEST_F(OneDepthSearch, FindsTheErosionStrainOfACone) {
  const test::TemporaryFolder folder;
  const std::string cone = "shape = \"cone\"\nradius = \"2.25 mm\"\ntip_angle = \"90 deg\"\ndensity = \"7800 kg/m3\"\n";
  InvertWords words{.scene = written(folder, scene_of_small_shot(mu, cone)), .depth = "10 mm", .mu = "500 kPa"};
  const InvertRequest request = understood(words);
  const Reduction reduction = reduce(scene_of(request, request.material));
  const Penetration shot =
      summarise(campaign_.replicate({reduction.problem}, 5, nullptr).front(), reduction.problem, reduction.scales);
  words.depth = std::to_string(1e3 * shot.depth.value()) + " mm";
  const OneDepth found = find_at_depth(understood(words), campaign_);
  ASSERT_TRUE(found.own().found()) << found.own().why_not;
  EXPECT_LT(std::abs(off(found.own(), LayerNumber::erosion_strain, strain,
                         {*shot.depth, *shot.standard_error / *shot.depth})),
            3);
  EXPECT_THAT(invert_page(one_depth_to_json(found)).summary, HasSubstr("stops the cone at 100 m/s"));
}

}  // namespace
}  // namespace percal
