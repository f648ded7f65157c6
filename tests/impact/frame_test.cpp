// What an observer sees is what the run holds, and looking changes nothing.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "impact/polygons.hpp"
#include "impact/same_bits.hpp"
#include "impact/setting_s.hpp"
#include "impact/specimen.hpp"
#include "percal/impact/march/march.hpp"

namespace percal {
namespace {

// Every so many long steps, kept.
class Watcher : public FrameObserver {
 public:
  explicit Watcher(long steps) : steps_(steps) {}
  bool is_due(const Moment& now) override { return now.step % steps_ == 0; }
  void see(const Frame& frame) override { frames.push_back(frame); }
  std::vector<Frame> frames;

 private:
  long steps_;
};

Problem elastic_dent() {
  Problem p = dent();
  p.particle = ElasticSphere{.youngs_modulus = 20, .poisson_ratio = 0.3};
  return p;
}
Problem short_prism() {
  Problem p = prism_impact(square_on_its_corner());
  std::get<RigidPolygon>(p.particle).free_rotation = true;
  p.end_time = 4;
  return p;
}
std::vector<Problem> all_kinds() {
  Problem one_rate = setting_s(5);
  one_rate.rates = 1;
  one_rate.arithmetic = Arithmetic::double_precision;
  one_rate.end_time = 8;
  Problem two_rates = setting_s(5);
  two_rates.relaxation = PronySeries{{{0.3, 0.1}}};
  two_rates.end_time = 8;
  return {one_rate, two_rates, elastic_dent(), short_prism()};
}

// F of a homogeneous state with z downwards -> principal stretches, Cauchy stress with y upwards, energy: the closed form of
// docs/theory/impact.md (2) by an eigenvalue solver of another's making.
struct ClosedForm {
  Eigen::Vector3d stretches;  // descending
  Eigen::Matrix3d cauchy;     // x, y, hoop
  double energy;
};
ClosedForm closed_form(const Eigen::Matrix3d& F, double mu, double alpha, double bulk) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> left(F * F.transpose());
  const Eigen::Vector3d lambda = left.eigenvalues().cwiseSqrt();
  const double J = F.determinant();
  Eigen::Vector3d tau;
  double energy = bulk / 4 * (J * J - 1 - 2 * std::log(J)) - 6 * mu / (alpha * alpha);
  for (int i = 0; i < 3; ++i) {
    const double pressure_part = bulk / 2 * (J * J - 1);
    tau[i] = isochoric_stress_of(mu, alpha, lambda[i], lambda[(i + 1) % 3], lambda[(i + 2) % 3]) + pressure_part;
    energy += 2 * mu / (alpha * alpha) * std::pow(lambda[i] * std::pow(J, -1.0 / 3), alpha);
  }
  Eigen::Matrix3d cauchy = left.eigenvectors() * tau.asDiagonal() * left.eigenvectors().transpose() / J;
  cauchy(0, 1) = cauchy(1, 0) = -cauchy(0, 1);
  return {lambda.reverse(), cauchy, energy};
}

TEST(TargetPiece, AHomogeneousStateHasTheClosedFormsStretchesStressAndEnergy) {
  for (const Geometry geometry : {Geometry::plane_strain, Geometry::axisymmetric}) {
    Problem p = specimen_problem();
    p.geometry = geometry;
    StrainedTarget<double> specimen(p);
    const double shear = 0.3;
    specimen.stretch(1.2, 0.7, shear);
    Eigen::Matrix3d F = Eigen::Matrix3d::Identity();
    F(0, 0) = 1.2;
    F(1, 1) = 0.7;
    F(1, 0) = shear;
    if (geometry == Geometry::axisymmetric) F(2, 2) = 1.2;
    const ClosedForm expected = closed_form(F, p.mu(), p.alpha, p.bulk());
    const TargetPiece piece = target_piece(specimen.block, specimen.solid);
    ASSERT_EQ(piece.states.size(), static_cast<std::size_t>(specimen.block.mesh().elements()));
    const double size = expected.cauchy.norm();
    for (const CellState& state : piece.states) {
      for (int i = 0; i < 3; ++i) EXPECT_NEAR(state.stretches[i], expected.stretches[i], 1e-10);
      for (int i = 0; i < 3; ++i) EXPECT_NEAR(state.stress[i], expected.cauchy(i, i), 1e-9 * size);
      EXPECT_NEAR(state.stress[3], expected.cauchy(0, 1), 1e-9 * size);
      EXPECT_NEAR(state.energy_density, expected.energy, 1e-9 * expected.energy);
    }
  }
}

TEST(TargetPiece, APressedLayerIsUnderPressureAndRelaxingStressIsWhatTheKernelPushesWith) {
  Problem p = specimen_problem();
  p.relaxation = PronySeries{{{0.3, 0.1}, {0.2, 1}}};
  StrainedTarget<double> specimen(p);
  specimen.stretch(1, 0.9);
  specimen.look(0.05);
  specimen.look(0.4);
  const CellState state = target_piece(specimen.block, specimen.solid).states.front();
  EXPECT_LT(state.stress[1], 0);
  EXPECT_NEAR(state.stress[0] * 0.9, specimen.stress_r(), 1e-9) << "sigma J = P lambda";
  EXPECT_NEAR(state.stress[1], specimen.stress_z(), 1e-9);
}

TEST(TargetPiece, LayersVolumesAndPlacesAreTheMeshs) {
  Problem p = setting_s(5);
  p.depth = 4;
  p.below = {{.depth = 2, .density = 1, .mu = p.mu(), .alpha = 3, .erosion_limit = 2}};
  Block<float> block(p, mesh_of(p), kernel<float>().lanes);
  const TargetPiece piece = target_piece(block, TargetSolid(p, block.layers()));
  double volume = 0, lower = 0;
  for (std::size_t k = 0; k < piece.volume.size(); ++k) (piece.layer[k] == 0 ? volume : lower) += piece.volume[k];
  EXPECT_NEAR(volume, 4 * p.width * p.width / 2, 1e-9);
  EXPECT_NEAR(lower, 2 * p.width * p.width / 2, 1e-9);
  EXPECT_EQ(piece.position.front(), (Point{0, 0}));
  EXPECT_NEAR(piece.position.back()[0], p.width, 1e-12);
  EXPECT_NEAR(piece.position.back()[1], -6, 1e-12);
  double doubled_area = 0;  // positive: counter-clockwise
  for (int a = 0; a < 4; ++a) {
    const Point &from = piece.position[piece.corners[a]], &to = piece.position[piece.corners[(a + 1) % 4]];
    doubled_area += from[0] * to[1] - to[0] * from[1];
  }
  EXPECT_NEAR(doubled_area, 2 * 0.2 * 0.2, 1e-12);
}

TEST(Frames, LookingChangesNoBit) {
  for (const Problem& problem : all_kinds()) {
    const ImpactResult alone = run_impact(problem);
    Watcher watcher(7);
    same_bits(run_impact(problem, watcher), alone);
    EXPECT_GT(watcher.frames.size(), 10u);
    Problem with_history = problem;
    with_history.history_samples = 400;
    Watcher other(13);
    same_bits(run_impact(with_history, other), alone);
  }
}

TEST(Frames, AreTheSameOnAnyNumberOfThreads) {
  Problem p = setting_s(5);
  p.end_time = 6;
  Watcher one(50), three(50);
  run_impact(p, one, 1);
  run_impact(p, three, 3);
  ASSERT_EQ(one.frames.size(), three.frames.size());
  for (std::size_t k = 0; k < one.frames.size(); ++k) {
    EXPECT_EQ(one.frames[k].moment.time, three.frames[k].moment.time);
    EXPECT_EQ(one.frames[k].target.position, three.frames[k].target.position);
    EXPECT_EQ(one.frames[k].target.velocity, three.frames[k].target.velocity);
    EXPECT_EQ(one.frames[k].target.states, three.frames[k].target.states);
    EXPECT_EQ(one.frames[k].particle.position, three.frames[k].particle.position);
  }
}

TEST(Frames, TheLastIsWhatTheResultTells) {
  const Problem p = setting_s(5);
  Watcher watcher(100000000);
  const ImpactResult result = run_impact(p, watcher);
  ASSERT_EQ(watcher.frames.size(), 2u) << "the first, which is due, and the last, which is not";
  const Frame &first = watcher.frames.front(), &last = watcher.frames.back();
  EXPECT_FALSE(first.is_last);
  EXPECT_TRUE(last.is_last);
  EXPECT_EQ(first.moment.time, 0);
  for (const Point& velocity : first.particle.velocity) EXPECT_EQ(velocity, (Point{0, -1}));
  EXPECT_EQ(last.moment.time, result.end_time);
  EXPECT_EQ(last.moment.step, result.steps);
  EXPECT_EQ(std::count(last.target.eroded.begin(), last.target.eroded.end(), 1), result.eroded);
  EXPECT_EQ(last.particle.velocity.front()[1], -result.end_speed);
  double lowest = 0;
  for (const Point& point : last.particle.position) lowest = std::min(lowest, point[1]);
  EXPECT_NEAR(lowest, -last.moment.tip, 1e-12);
  EXPECT_EQ(first.target.corners, last.target.corners) << "one mesh for the whole series";
}

TEST(Frames, EnergyDensitiesOverTheVolumeAreTheLedgersElasticShare) {
  for (Problem p : all_kinds()) {
    p.history_samples = 1000000;
    Watcher watcher(40);
    const ImpactResult result = run_impact(p, watcher);
    const double mass = std::holds_alternative<RigidPolygon>(p.particle) ? std::get<RigidPolygon>(p.particle).mass
                                                                         : 2.0 / 3 * p.density_ratio;
    ASSERT_GT(watcher.frames.size(), 2u);
    for (const Frame& frame : watcher.frames) {
      double stored = 0;
      for (std::size_t k = 0; k < frame.target.volume.size(); ++k)
        stored += frame.target.volume[k] * frame.target.states[k].energy_density;
      const auto point = std::find_if(result.history.begin(), result.history.end(),
                                      [&](const HistoryPoint& h) { return h.time == frame.moment.time; });
      ASSERT_NE(point, result.history.end());
      EXPECT_NEAR(stored, point->energy.elastic * mass / 2, 1e-9) << "rows at rest, which it leaves out, hold 1e-11";
    }
  }
}

TEST(ParticlePiece, AnElasticSpheresDisplacementsAndStatesAreItsBodys) {
  Watcher watcher(60);
  run_impact(elastic_dent(), watcher);
  const ParticlePiece &first = watcher.frames.front().particle, &last = watcher.frames.back().particle;
  ASSERT_EQ(last.states.size(), last.ends.size());
  for (std::size_t n = 0; n < last.position.size(); ++n)
    for (int d = 0; d < 2; ++d) EXPECT_NEAR(last.position[n][d] - last.displacement[n][d], first.position[n][d], 1e-12);
  double largest = 0;
  for (const CellState& state : last.states) largest = std::max(largest, std::abs(state.stress[1]));
  EXPECT_GT(largest, 0.01);
  for (const CellState& state : first.states) EXPECT_NEAR(state.stretches[0], 1, 1e-6);
}

TEST(ParticlePiece, ARigidPolygonIsMovedAndTurnedAndOfAHalfModelOnlyTheRightHalfIsShown) {
  Watcher watcher(60);
  const ImpactResult result = run_impact(short_prism(), watcher);
  const ParticlePiece &first = watcher.frames.front().particle, &last = watcher.frames.back().particle;
  EXPECT_EQ(first.ends, std::vector<int>{4});
  double lowest = 1;
  for (const Point& point : first.position) lowest = std::min(lowest, point[1]);
  EXPECT_NEAR(lowest, 0, 1e-12) << "it begins on the surface";
  for (std::size_t n = 0; n < last.position.size(); ++n)
    for (int d = 0; d < 2; ++d) EXPECT_NEAR(last.position[n][d] - last.displacement[n][d], first.position[n][d], 1e-12);
  EXPECT_GT(result.depth, 0.5);

  Problem half = short_prism();
  half.whole = false;
  std::get<RigidPolygon>(half.particle).free_rotation = false;
  Watcher of_half(60);
  run_impact(half, of_half);
  const ParticlePiece& piece = of_half.frames.front().particle;
  ASSERT_EQ(piece.position.size(), 3u);
  EXPECT_NEAR(piece.position[0][1], 0, 1e-12);
  EXPECT_NEAR(piece.position[1][0], 1, 1e-12);
  EXPECT_NEAR(piece.position[2][1], 2, 1e-12);
  for (const Point& point : piece.position) EXPECT_GE(point[0], 0);
}

TEST(History, EnergiesCloseAtEveryPointAsAtTheEnd) {
  for (Problem p : all_kinds()) {
    p.history_samples = 400;
    const ImpactResult result = run_impact(p);
    double worst = 0;
    for (const HistoryPoint& point : result.history) worst = std::max(worst, std::abs(point.energy.closure()));
    EXPECT_LT(worst, 5e-3);
    EXPECT_LT(worst, 3 * std::abs(result.energy.closure()) + 2e-3);
    EXPECT_EQ(result.history.front().energy.particle, 1);
    EXPECT_EQ(result.history.back().energy.sum(), result.energy.sum());
    double taken = 0;  // never given back
    for (const HistoryPoint& point : result.history) {
      EXPECT_GE(point.energy.eroded, taken);
      taken = point.energy.eroded;
    }
  }
}

}  // namespace
}  // namespace percal
