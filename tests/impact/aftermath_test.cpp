// What a run says besides its depth: speeds behind layers, what follows the deepest point, how wide the channel is.
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "impact/plain_march.hpp"
#include "impact/polygons.hpp"
#include "impact/same_bits.hpp"
#include "impact/setting_s.hpp"
#include "percal/impact/march/march.hpp"
#include "percal/impact/march/rest_watch.hpp"

namespace percal {
namespace {

Problem to_rest(Problem p) {
  p.until = RunUntil::rest;
  return p;
}

// Thrown back out of the crater.
Problem thrown_back() {
  Problem p = setting_s(4);
  p.density_ratio = 1.2;
  p.depth = 10;
  return p;
}

// Held by its crater, for the stress relaxes.
Problem comes_to_rest() {
  Problem p = setting_s(4);
  p.density_ratio = 2;
  p.depth = 20;
  p.relaxation = PronySeries{{{0.5, 2}}};
  return p;
}

// Through three layers.
Problem passes_through() {
  Problem p = setting_s(5);
  p.depth = 3;
  p.below = {{.depth = 2, .density = 1, .mu = p.mu(), .alpha = 8.5, .erosion_limit = 0.7},
             {.depth = 1.5, .density = 0.9, .mu = p.mu() / 2, .alpha = 8.5, .erosion_limit = 0.9}};
  return p;
}

const std::vector<Problem> each_ending{thrown_back(), comes_to_rest(), passes_through()};

TEST(Aftermath, ChangesNoBitOfWhatTheRunSaysWithoutIt) {
  for (const Problem& problem : each_ending)
    for (const int rates : {1, 2}) {
      Problem p = problem;
      p.rates = rates;
      const ImpactResult without = run_impact(p);
      ImpactResult with = run_impact(to_rest(p));
      EXPECT_GT(with.steps, without.steps);
      EXPECT_GT(with.element_steps, without.element_steps);
      with.steps = without.steps;
      same_bits(with, without);
      EXPECT_EQ(with.smallest_step, without.smallest_step);
      EXPECT_EQ(with.target_momentum, without.target_momentum);
      EXPECT_EQ(with.speeds_behind, without.speeds_behind);
      EXPECT_TRUE(with.aftermath);
      EXPECT_FALSE(without.aftermath);
    }
}

TEST(Aftermath, EachWayToEndHasItsName) {
  EXPECT_EQ(run_impact(to_rest(thrown_back())).aftermath->ending, Ending::left_upwards);
  EXPECT_EQ(run_impact(to_rest(comes_to_rest())).aftermath->ending, Ending::rests);
  EXPECT_EQ(run_impact(to_rest(passes_through())).aftermath->ending, Ending::passed_through);
  Problem hurried = comes_to_rest();
  hurried.end_time = 30;
  const ImpactResult result = run_impact(to_rest(hurried));
  EXPECT_EQ(result.outcome, Outcome::stopped);
  EXPECT_EQ(result.aftermath->ending, Ending::time_up);
  EXPECT_NEAR(result.aftermath->time, 30, 0.1);
  hurried.end_time = 3;
  EXPECT_FALSE(run_impact(to_rest(hurried)).aftermath) << "its time was up before it was deepest";
}

// What stops ends there; what passes leaves as in a run to rest; what is held by what it has pushed out rests.
TEST(Aftermath, OfAPassageIsOnlyThatOfARunThatReachesTheLowerFace) {
  const auto of_passage = [](Problem p) {
    p.until = RunUntil::passage;
    return run_impact(p);
  };
  const ImpactResult stopped = of_passage(thrown_back());
  same_bits(stopped, run_impact(thrown_back()));
  EXPECT_FALSE(stopped.aftermath);
  const ImpactResult passed = of_passage(passes_through());
  ASSERT_TRUE(passed.aftermath);
  EXPECT_EQ(passed.aftermath->ending, Ending::passed_through);
  EXPECT_EQ(passed.aftermath->speed, run_impact(to_rest(passes_through())).aftermath->speed);
  Problem held = setting_s(4);
  held.density_ratio = 2;
  ImpactResult result;
  for (held.depth = 12; result.outcome != Outcome::passed_through && held.depth > 2; held.depth *= 0.99)
    result = of_passage(held);  // until the tip just reaches the lower face
  ASSERT_TRUE(result.aftermath);
  EXPECT_EQ(result.aftermath->ending, Ending::rests);
  EXPECT_LE(result.aftermath->speed, 0);
}

// The particle is rigid and does not turn: its share of the energy is its speed's square.
TEST(Aftermath, TheSpeedInFreeFlightIsWhatTheLedgerSays) {
  for (const Problem& problem : {thrown_back(), passes_through()}) {
    const ImpactResult result = run_impact(to_rest(problem));
    const Aftermath& after = *result.aftermath;
    EXPECT_NEAR(after.energy.particle, after.speed * after.speed, 1e-14);
    EXPECT_LT(std::abs(after.energy.closure()), 0.01);
    EXPECT_GE(after.eroded, result.eroded);
    EXPECT_EQ(after.half_width, 0);
    EXPECT_EQ(after.speed < 0, after.ending == Ending::left_upwards);
  }
}

TEST(Aftermath, NothingTouchesAParticleThatFliesFree) {
  Problem p = to_rest(thrown_back());
  p.history_samples = 100000;
  const ImpactResult result = run_impact(p);
  const Aftermath& after = *result.aftermath;
  EXPECT_LE(after.depth, -2);
  int untouched = 0;
  for (const HistoryPoint& point : result.history)
    if (point.tip < after.depth + 1.9) {
      EXPECT_NEAR(point.speed, after.speed, 1e-4);
      ++untouched;
    }
  EXPECT_GT(untouched, 5);
}

// From the history's path, by the rule as it is written down.
TEST(Aftermath, TheFinalDepthIsTheMiddleOfWhereTheTipWasInTheLastHalfOfTheTime) {
  for (const double end_time : {1000.0, 60.0}) {
    Problem p = to_rest(comes_to_rest());
    p.end_time = end_time;
    p.history_samples = 100000;
    const ImpactResult result = run_impact(p);
    const Aftermath& after = *result.aftermath;
    double low = -HUGE_VAL, high = HUGE_VAL;
    for (const HistoryPoint& point : result.history)
      if (point.time >= after.time / 2 && point.time >= result.end_time) {
        low = std::max(low, point.tip);
        high = std::min(high, point.tip);
      }
    EXPECT_NEAR(after.depth, (low + high) / 2, 0.02)
        << "the watch keeps it in intervals of a quarter of a radius' time";
    EXPECT_NEAR(after.half_width, (low - high) / 2, 0.02);
    if (after.ending == Ending::rests) EXPECT_LE(after.half_width, 0.025 * result.depth);
    EXPECT_LT(after.depth, result.depth);
  }
}

// Nothing erodes: a march without the shortcuts takes the same way back.
TEST(Aftermath, AReboundIsThatOfAPlainMarch) {
  Problem p = dent();
  p.density_ratio = 2;
  p.end_time = 1000;
  p.depth = 8;
  const ImpactResult result = run_impact(to_rest(p));
  ASSERT_EQ(result.aftermath->ending, Ending::left_upwards);
  p.end_time = result.aftermath->time;
  PlainMarch plain(p);
  plain.run();
  EXPECT_NEAR(plain.speed(), result.aftermath->speed, 1e-3);
  EXPECT_NEAR(plain.tip(), result.aftermath->depth, 0.03) << "it ends with the first step beyond that time";
}

TEST(Aftermath, ABottomThatIsHeldEndsTheRunWhereTheTipReachesIt) {
  Problem p = setting_s(5);
  p.depth = 4;
  p.bottom = Bottom::fixed;
  const ImpactResult without = run_impact(p), with = run_impact(to_rest(p));
  same_bits(with, without);
  ASSERT_EQ(with.outcome, Outcome::passed_through);
  EXPECT_EQ(with.aftermath->ending, Ending::passed_through);
  EXPECT_EQ(with.aftermath->speed, with.end_speed);
}

// --- the rule by itself -------------------------------------------------------------------------------------------

// A path, looked at every 0.01, from the deepest point at time 40 and depth 20 on.
template <class Tip>
std::pair<std::optional<Ending>, RestWatch::Swing> watched(const Tip& tip, double until) {
  RestWatch watch;
  watch.begin(40, 20, 30);
  for (double time = 40; time < until; time += 0.01) {
    const double speed = (tip(time + 1e-6) - tip(time - 1e-6)) / 2e-6;
    if (const auto ending = watch.look({time, tip(time), tip(time) - 2, speed})) return {ending, watch.swing(time)};
  }
  return {std::nullopt, watch.swing(until)};
}

TEST(RestWatch, ASwingThatDiesOutRestsAndItsLimitIsWithinTheHalfWidth) {
  for (const double period : {2.0, 15.0, 60.0})
    for (const double decay : {10.0, 60.0}) {
      const auto tip = [&](double t) {
        return 17 + 3 * std::exp(-(t - 40) / decay) * std::cos(2 * M_PI * (t - 40) / period);
      };
      const auto [ending, swing] = watched(tip, 2000);
      ASSERT_EQ(ending, Ending::rests) << period << ", " << decay;
      EXPECT_LE(swing.width(), 0.05 * 20);
      EXPECT_NEAR(swing.middle(), 17, swing.width() / 2) << period << ", " << decay;
    }
}

TEST(RestWatch, ACreepIsNoRest) {
  EXPECT_EQ(watched([](double t) { return 20 - 0.05 * (t - 40); }, 300).first, std::nullopt);
  EXPECT_EQ(watched([](double t) { return 19 + std::cos((t - 40) / 5); }, 1000).first, std::nullopt)
      << "a swing that stays";
}

TEST(RestWatch, ATurningPointIsNoRest) {
  EXPECT_EQ(watched([](double t) { return 20 - 1e-3 * (t - 40) * (t - 40); }, 130).first, std::nullopt);
}

TEST(RestWatch, OutsideItHasLeftOnceItHasGoneItsOwnHeightUntouched) {
  EXPECT_EQ(watched([](double t) { return 20 - 0.5 * (t - 40); }, 83.9).first, std::nullopt);
  EXPECT_EQ(watched([](double t) { return 20 - 0.5 * (t - 40); }, 84.2).first, Ending::left_upwards);
  EXPECT_EQ(watched([](double t) { return 20 + 0.5 * (t - 40); }, 63.9).first, std::nullopt);
  EXPECT_EQ(watched([](double t) { return 20 + 0.5 * (t - 40); }, 64.2).first, Ending::passed_through);
  EXPECT_EQ(watched([](double t) { return 20 + 0.5 * (t - 40) + 0.01 * std::sin(t); }, 100).first, std::nullopt)
      << "pushed to and fro";
}

// --- speeds -------------------------------------------------------------------------------------------------------

// Speeds of the history belong to the middles of steps.
double from_history(const std::vector<HistoryPoint>& history, double face) {
  std::size_t k = 1;
  while (history[k].tip < face) ++k;
  const auto& [before, after] = std::pair(history[k - 1], history[k]);
  const double time = before.time + (after.time - before.time) * (face - before.tip) / (after.tip - before.tip);
  const auto middle = [&](std::size_t i) { return (history[i - 1].time + history[i].time) / 2; };
  const std::size_t left = time < middle(k) ? k - 1 : k;
  if (left + 1 == history.size()) return NAN;
  const double share = (time - middle(left)) / (middle(left + 1) - middle(left));
  return history[left].speed + share * (history[left + 1].speed - history[left].speed);
}

TEST(SpeedsBehind, FallAndAreTheHistorys) {
  Problem p = passes_through();
  p.rates = 1;
  p.history_samples = 100000;
  const ImpactResult result = run_impact(to_rest(p));
  ASSERT_EQ(result.speeds_behind.size(), 3u);
  EXPECT_LT(result.speeds_behind[0], 1);
  EXPECT_LT(result.speeds_behind[1], result.speeds_behind[0]);
  EXPECT_LT(result.speeds_behind[2], result.speeds_behind[1]);
  EXPECT_LT(result.aftermath->speed, result.speeds_behind[2]);
  EXPECT_NEAR(result.speeds_behind[0], from_history(result.history, 3), 1e-12);
  EXPECT_NEAR(result.speeds_behind[1], from_history(result.history, 5), 1e-12);
  EXPECT_NEAR(result.speeds_behind[2], from_history(result.history, 6.5), 1e-3) << "there the run without it ends";
}

TEST(SpeedsBehind, AreOfTheLayersThatWereCrossed) {
  EXPECT_TRUE(run_impact(thrown_back()).speeds_behind.empty());
  Problem p = setting_s(5);
  p.depth = 1;
  p.below = {{.depth = 60, .density = 1, .mu = p.mu(), .alpha = 8.5, .erosion_limit = 0.7}};
  EXPECT_EQ(run_impact(p).speeds_behind.size(), 1u);
}

TEST(SpeedsBehind, TwoRatesSayTheSameWithinTheScatter) {
  Problem p = passes_through();
  const auto two = run_impact(p).speeds_behind;
  p.rates = 1;
  const auto one = run_impact(p).speeds_behind;
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(two.at(k), one.at(k), 0.02);
}

// --- the channel --------------------------------------------------------------------------------------------------

// Sees every step, and makes the rows' radii out of what --fields writes.
class ChannelOfFrames : public FrameObserver {
 public:
  explicit ChannelOfFrames(bool whole) : whole_(whole) {}
  bool is_due(const Moment&) override { return true; }
  void see(const Frame& frame) override {
    std::map<int, std::vector<std::array<double, 4>>> rows;  // undeformed middle, alive, left face, right face
    const TargetPiece& target = frame.target;
    for (std::size_t k = 0; k < target.eroded.size(); ++k) {
      const int* corner = target.corners.data() + 4 * k;
      const auto undeformed = [&](int a, int axis) {
        return target.position[corner[a]][axis] - target.displacement[corner[a]][axis];
      };
      const auto at = [&](int a) { return target.position[corner[a]][0]; };
      const double height = undeformed(2, 1) - undeformed(1, 1);
      const double middle = (undeformed(0, 0) + undeformed(1, 0)) / 2;
      rows[static_cast<int>(std::floor(-undeformed(2, 1) / height + 0.5))].push_back(
          {middle, target.eroded[k] ? 0.0 : 1.0, (at(0) + at(3)) / 2, (at(1) + at(2)) / 2});
      height_ = height;
    }
    radii.clear();
    for (auto& [row, cells] : rows) {
      std::sort(cells.begin(), cells.end());
      double right = cells.back()[3], left = cells.front()[2];
      const bool is_torn = std::any_of(cells.begin(), cells.end(), [](const auto& cell) { return cell[1] == 0; });
      for (auto cell = cells.rbegin(); cell != cells.rend() && (*cell)[1] == 1; ++cell) right = (*cell)[2];
      for (auto cell = cells.begin(); cell != cells.end() && (*cell)[1] == 1; ++cell) left = (*cell)[3];
      radii[row] = !is_torn ? 0 : (whole_ ? (right - left) / 2 : right);
      largest[row] = std::max(largest[row], radii[row]);
    }
  }
  int row_at(double depth) const { return static_cast<int>(std::floor(depth / height_)); }
  std::map<int, double> radii, largest;

 private:
  bool whole_;
  double height_ = 1;
};

Problem skew_prism() {
  Problem p = prism_impact(parallelogram({1, 0.3}, {-0.2, 0.8}));
  std::get<RigidPolygon>(p.particle).free_rotation = true;
  p.end_time = 5;
  return p;
}

// Between the points of a history whose steps are no longer than a run's.
TEST(HalfSpeed, IsWhereTheHistoryHasHalfTheSpeed) {
  for (const double factor : {1.0, 0.97}) {
    Problem p = comes_to_rest();
    p.until = RunUntil::deepest;
    p.speed_factor = factor;
    p.history_samples = 100000;
    const ImpactResult result = run_impact(p);
    ASSERT_EQ(result.outcome, Outcome::stopped);
    std::size_t k = 1;
    while (result.history[k].speed > 0.5 * factor) ++k;
    EXPECT_GT(result.half_speed_depth, result.history[k - 1].tip - 0.02);
    EXPECT_LT(result.half_speed_depth, result.history[k].tip + 0.02);
    EXPECT_GT(result.half_speed_depth, 0.3 * result.depth);
  }
  Problem through = passes_through();
  through.depth = 2;
  EXPECT_EQ(run_impact(through).half_speed_depth, 0) << "it had more when it left";
}

TEST(Channel, IsThatOfTheFields) {
  for (Problem p : {to_rest(thrown_back()), passes_through(), skew_prism()}) {
    p.channel = true;
    ChannelOfFrames seen(p.whole);
    const ImpactResult result = run_impact(p, seen);
    ASSERT_EQ(result.channel.largest.size(), channel_shares.size());
    for (std::size_t k = 0; k < channel_shares.size(); ++k) {
      const int row = seen.row_at(channel_shares[k] * std::min(result.depth, p.whole_depth()));
      EXPECT_NEAR(result.channel.largest[k], seen.largest[row], 1e-6) << k;
      EXPECT_NEAR(result.channel.end[k], seen.radii[row], 1e-6) << k;
    }
    EXPECT_GT(result.channel.largest.front(), 0.3);
  }
}

TEST(Channel, ChangesNoBitAndIsKeptWhereItIsAskedFor) {
  Problem p = passes_through();
  const ImpactResult without = run_impact(p);
  p.channel = true;
  same_bits(run_impact(p), without);
  EXPECT_TRUE(without.channel.largest.empty());
  EXPECT_TRUE(without.channel.end.empty());
}

TEST(Channel, WithoutErosionThereIsNone) {
  Problem p = dent();
  p.channel = true;
  EXPECT_THAT(run_impact(p).channel.largest, testing::Each(0));
}

TEST(FieldMeasuresOfARun, AreTheSameBitsOnAnyNumberOfThreadsAndInTheMirror) {
  for (Problem p : {to_rest(thrown_back()), to_rest(passes_through())}) {
    p.channel = true;
    const ImpactResult one = run_impact(p, 1), three = run_impact(p, 3);
    EXPECT_EQ(one.speeds_behind, three.speeds_behind);
    EXPECT_EQ(one.channel.largest, three.channel.largest);
    EXPECT_EQ(one.channel.end, three.channel.end);
    EXPECT_EQ(one.aftermath->depth, three.aftermath->depth);
    EXPECT_EQ(one.aftermath->speed, three.aftermath->speed);
    EXPECT_EQ(one.aftermath->energy.sum(), three.aftermath->energy.sum());
  }
  Problem p = skew_prism();
  p.channel = true;
  const ImpactResult right = run_impact(p);
  auto& profile = std::get<RigidPolygon>(p.particle);
  profile = mirror_image(profile);
  const ImpactResult left = run_impact(p);
  EXPECT_EQ(right.channel.largest, left.channel.largest);
  EXPECT_EQ(right.channel.end, left.channel.end);
}

}  // namespace
}  // namespace percal
