// Curves and depths that say one thing, that contradict each other, and that cannot tell.
#include "percal/calibrate/verdict.hpp"

#include <gmock/gmock.h>

#include "calibrate/gel_job.hpp"
#include "calibrate/small_job.hpp"

namespace percal {
namespace {

using testing::HasSubstr;

class Verdicts : public testing::Test {
 protected:
  static void SetUpTestSuite() { emulator_ = new Emulator(test::emulator_of_the_smooth_law()); }
  static void TearDownTestSuite() { delete emulator_; }

  Verdicts() {
    job_.hypotheses[0].held[2] = truth_[2];
    test::measure(job_, truth_, 0.05, 3);
  }

  // A tension curve of a solid with the true exponent that is softer by this factor than the one the shots met, with errors of 1 %.
  void add_curve(double softer) {
    MeasuredCurve curve{.name = "tension", .data = {}, .relative_error = 0.01};
    const Ogden solid{truth_[0] / softer, truth_[1]};
    for (double stretch = 1.1; stretch < 2; stretch += 0.1) {
      const Strained state{Deformation::uniaxial, stretch};
      curve.data.points.push_back({.strained = state, .nominal_stress = nominal_stress(solid, state)});
    }
    job_.groups.push_back({"curves", false, 0});
    curve.group = 1;
    job_.curves.push_back(curve);
  }
  Verdict verdict() const {
    const JobModel model = finite_element_model(job_, job_.hypotheses[0], *emulator_, 0.1);
    return verdict_of(job_, 0, model, fit_job(job_, model, used_shots(job_), quick_search()));
  }

  static inline const Emulator* emulator_;
  const std::vector<double> truth_{200e3, 7, 0.8};
  CalibrationJob job_ = test::gel_job(16);
};

TEST_F(Verdicts, CurveAndDepthsOfOneSolidAgree) {
  add_curve(1);
  const Verdict found = verdict();
  EXPECT_EQ(found.agreement, DataAgreement::agrees) << found.sentences[0];
  ASSERT_EQ(found.rate_factors.size(), 1u);
  EXPECT_NEAR(found.rate_factors[0].implied.value, 1, 0.3);
}

TEST_F(Verdicts, ASlowCurveBesideFastShotsContradictsThemUntilItsRateFactorIsSaid) {
  add_curve(10);
  const Verdict found = verdict();
  EXPECT_EQ(found.agreement, DataAgreement::disagrees);
  const ImpliedRateFactor& rate = found.rate_factors.at(0);
  EXPECT_LT(rate.implied.interval.low, 10);
  EXPECT_GT(rate.implied.interval.high, 10);
  EXPECT_LT(rate.modulus_of_depths.interval.low, truth_[0]);
  EXPECT_GT(rate.modulus_of_depths.interval.high, truth_[0]);
  EXPECT_NEAR(rate.modulus_of_curves, truth_[0] / 10, 0.02 * truth_[0] / 10);
  EXPECT_THAT(found.sentences[0], HasSubstr("would join them; the job has 1."));
  job_.curves[0].rate_factor = 10;
  EXPECT_EQ(verdict().agreement, DataAgreement::agrees);
}

// Between the job's level and 99.9 %: said, but no contradiction.
TEST_F(Verdicts, AModerateMisfitIsADoubt) {
  add_curve(1);
  const double usual = verdict().rate_factors.at(0).implied.interval.high;
  job_.curves[0].rate_factor = 1.02 * usual;
  const Verdict found = verdict();
  EXPECT_EQ(found.agreement, DataAgreement::cannot_tell) << found.sentences[0];
  EXPECT_THAT(found.sentences[0], HasSubstr("hardly agree"));
  job_.curves[0].rate_factor = 5 * usual;
  EXPECT_EQ(verdict().agreement, DataAgreement::disagrees);
}

TEST_F(Verdicts, AnUncertainRateFactorIsContradictedLess) {
  add_curve(10);
  job_.curves[0].rate_factor = 5;
  EXPECT_EQ(verdict().agreement, DataAgreement::disagrees);
  job_.curves[0].rate_factor_error = 0.5;
  EXPECT_EQ(verdict().agreement, DataAgreement::agrees);
}

// Stiffer and easier to erode is as deep: the modulus is anywhere.
TEST_F(Verdicts, DepthsThatLeaveTheModulusOpenCannotTell) {
  add_curve(1);
  job_.hypotheses[0].held.clear();
  job_.parameters[0].free.low = 10e3;
  job_.parameters[0].free.high = 4e6;
  job_.shots.resize(2);
  job_.shots[1].speed = job_.shots[0].speed;
  const Verdict found = verdict();
  EXPECT_EQ(found.agreement, DataAgreement::cannot_tell) << found.sentences[0];
}

TEST_F(Verdicts, DepthsAloneHaveNothingToContradict) {
  job_.hypotheses[0].held[1] = truth_[1];
  const Verdict found = verdict();
  EXPECT_EQ(found.agreement, DataAgreement::cannot_tell);
  EXPECT_TRUE(found.rate_factors.empty());
}

TEST_F(Verdicts, AScatterThatNoShotsHaveIsAContradiction) {
  job_.hypotheses[0].held[1] = truth_[1];
  for (std::size_t i = 0; i < job_.shots.size(); i += 2) job_.shots[i].depth *= 4;
  const Verdict found = verdict();
  EXPECT_EQ(found.agreement, DataAgreement::disagrees);
  EXPECT_THAT(found.sentences, testing::Contains(HasSubstr("would have to scatter by")));
}

TEST_F(Verdicts, AParameterAtItsBoundIsSaid) {
  add_curve(1);
  job_.parameters[0].free.high = 150e3;
  const Verdict found = verdict();
  EXPECT_THAT(found.sentences, testing::Contains(HasSubstr("mu is at the upper bound of its search")));
}

// The whole command on curves alone: nothing is shot.
class CurvesOnly : public calibrate_test::SmallJob {};

TEST_F(CurvesOnly, AJobOfCurvesIsFittedAndShootsNothing) {
  write("tension.csv", "stretch,stress_kPa\n1.1,10.3\n1.2,18.9\n1.3,26.4\n1.5,39.5\n1.7,51.5\n2,70\n");
  write("job.toml",
        "[parameters.mu]\nkind = \"modulus\"\nlow = \"1 kPa\"\nhigh = \"1 MPa\"\n[parameters.alpha]\nkind = "
        "\"exponent\"\nlow = 0.5\nhigh = 20\n[materials.gel]\ndensity = \"1000 kg/m3\"\nmu = \"mu\"\nalpha = "
        "\"alpha\"\nerosion_strain = 0.8\n[[curves]]\nname = \"tension\"\nmaterial = \"gel\"\nfile = "
        "\"tension.csv\"\nmode = \"uniaxial\"\n");
  const auto ended = run({"calibrate", "job.toml", "--store", "store", "--out", "out"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  const nlohmann::json found = result("out/result.json");
  EXPECT_EQ(found["hypotheses"][0]["verdict"]["agreement"], "cannot tell");
  EXPECT_NEAR(found["hypotheses"][0]["parameters"][0]["value_Pa"].get<double>(), 36e3, 6e3);
  EXPECT_EQ(found["cost"]["runs"], 0);
  EXPECT_THAT(ended.out, testing::Not(HasSubstr("nan")));
}

}  // namespace
}  // namespace percal
