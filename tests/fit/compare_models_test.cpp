#include "percal/fit/search/compare_models.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "percal/base/error.hpp"
#include "percal/fit/read/read_curves.hpp"

namespace percal {
namespace {

CurveData treloar() { return read_curves({PERCAL_DATA "/public/treloar1944_rubber_primary.csv"}, {}); }

const ComparedModel& model_in(const std::vector<ComparedModel>& models, Model model) {
  for (const auto& one : models)
    if (one.model == model) return one;
  throw std::logic_error("not compared");
}

CurveData exact_data(const Hyperelastic& solid) {
  CurveData data;
  int i = 0;
  for (const auto deformation : {Deformation::uniaxial, Deformation::equibiaxial, Deformation::planar})
    for (double stretch = 1.05; stretch < 2; stretch += 0.1) {
      const double stress = nominal_stress(solid, Strained{deformation, stretch});
      data.points.push_back({{deformation, stretch}, stress * (1 + (++i % 3 - 1) * 0.01)});
    }
  return data;
}

TEST(CompareModels, TheTrueModelHasTheLowestCriterionAndPredictsWhatItDidNotSee) {
  for (const auto& [truth, model] : {std::pair{Hyperelastic{{{900, 2}, {300, -2}}}, Model::mooney_rivlin},
                                     {Hyperelastic{{{1000, 6}}}, Model::ogden}}) {
    const auto models = compare_models(exact_data(truth), {});
    ASSERT_EQ(models.size(), 5u);
    const auto& best = model_in(models, model);
    for (const auto& other : models) EXPECT_LE(*best.fit->aicc, *other.fit->aicc) << word(other.model);
    EXPECT_LT(*best.mean_relative_deviation, 0.03);
    EXPECT_GT(*model_in(models, Model::neo_hooke).mean_relative_deviation, 0.05);
  }
}

TEST(CompareModels, ALeftOutTestIsPredictedFromTheOthersAlone) {
  const auto data = treloar();
  const auto models = compare_models(data, {.residual = Residual::absolute});
  const auto& ogden = model_in(models, Model::ogden);
  ASSERT_EQ(ogden.left_out.size(), 3u);
  EXPECT_EQ(ogden.left_out[1].name, "equibiaxial");
  CurveData others = data;
  std::erase_if(others.points, [](const auto& p) { return p.strained.deformation == Deformation::equibiaxial; });
  const auto solid = fit_ogden(others, Residual::absolute).minima[0].solid;
  double sum = 0, count = 0, deviation = 0, stress = 0;
  for (const auto& point : data.points) {
    if (point.strained.deformation != Deformation::equibiaxial) continue;
    const double predicted = nominal_stress(solid, point.strained);
    sum += std::abs(predicted / point.nominal_stress - 1), ++count;
    deviation += std::abs(predicted - point.nominal_stress), stress += std::abs(point.nominal_stress);
  }
  EXPECT_NEAR(*ogden.left_out[1].mean_relative_deviation, sum / count, 1e-9);
  EXPECT_NEAR(*ogden.left_out[1].relative_to_sum, deviation / stress, 1e-9);
}

TEST(CompareModels, OneTestIsLeftUnpredictedAndTooFewPointsAreSaid) {
  auto data = exact_data({{{1000, 6}}});
  data.points.resize(5);
  const auto models = compare_models(data, {});
  EXPECT_TRUE(model_in(models, Model::ogden).left_out.empty());
  EXPECT_EQ(model_in(models, Model::ogden).mean_relative_deviation, std::nullopt);
  EXPECT_FALSE(model_in(models, Model::ogden3).fit.has_value());
  EXPECT_NE(model_in(models, Model::ogden3).why_not, "");
}

// Three terms on Treloar's tension: one of them has 6e-28 Pa at alpha = 40 and stands for the last points.
TEST(CompareModels, AFitWithATermThatIsNothingIsNotRanked) {
  const auto tension = read_curves({PERCAL_DATA "/public/treloar1944_rubber_primary.csv"}, {.where = {"mode=UT"}});
  const auto models = compare_models(tension, {.residual = Residual::absolute});
  EXPECT_THAT(model_in(models, Model::ogden3).not_ranked, testing::HasSubstr("alpha = 40, the bound of the search"));
  EXPECT_THAT(model_in(models, Model::ogden3).not_ranked, testing::HasSubstr("which is nothing"));
  EXPECT_EQ(model_in(models, Model::ogden).not_ranked, "");
}

TEST(CompareModels, AShareOfALeftOutTestDoesNotStandInTheWay) {
  const auto models = compare_models(treloar(), {.weighting = EqualTests{{{"equibiaxial", 2}}}});
  for (const auto& model : models) EXPECT_TRUE(model.mean_relative_deviation.has_value()) << word(model.model);
  EXPECT_THROW(compare_models(treloar(), {.weighting = EqualTests{{{"shear", 2}}}}), BadInput);
}

}  // namespace
}  // namespace percal
