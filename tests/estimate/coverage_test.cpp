// Made-up data from known parameters: how often the intervals hold the truth. With 500 replicates the share of a true 95 % is
// known to 1 %, so 92 to 98 is 3 of these standard deviations.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "estimate/problems.hpp"
#include "percal/estimate/intervals.hpp"
#include "percal/invert/dehn.hpp"
#include "percal/math/distributions.hpp"

namespace percal {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int replicates = 500;
constexpr double level = 0.95;

using Replicate = std::function<CalibrationProblem(unsigned seed)>;

// The share of replicates whose profile interval of each parameter holds the truth.
std::vector<double> coverage(const Replicate& replicate, const VectorXd& truth) {
  std::vector<double> share(truth.size(), 0);
  for (unsigned seed = 1; seed <= replicates; ++seed) {
    const CalibrationProblem problem = replicate(seed);
    const Minimum minimum = refine(problem, truth, {}, {});
    EXPECT_TRUE(minimum.converged) << "seed " << seed;
    for (const auto& one : profile_intervals(problem, minimum, level, {})) {
      const double natural = problem.parameters[one.parameter].natural(truth[one.parameter]);
      if (one.interval.low <= natural && natural <= one.interval.high) share[one.parameter] += 1.0 / replicates;
    }
  }
  return share;
}

void expect_nominal(const std::vector<double>& shares) {
  for (const double share : shares) {
    EXPECT_GE(share, 0.92);
    EXPECT_LE(share, 0.98);
  }
}

TEST(SlowCoverage, OfACurvesTwoParameters) {
  expect_nominal(
      coverage([](unsigned seed) { return curve_problem(12, 1.3, 2, 0.5, seed); }, Eigen::Vector2d(std::log(1.3), 2)));
}

std::vector<DehnShot> gelatin_shots() {
  std::ifstream file(PERCAL_DATA "/guha2009/gelatin_shots.csv");
  std::vector<DehnShot> shots;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("#") || line.starts_with("material")) continue;
    std::istringstream cells(line.substr(line.find(',') + 1));
    double density, printed, diameter, speed;
    char comma;
    cells >> density >> comma >> printed >> comma >> diameter >> comma >> speed;
    shots.push_back({.radius = diameter / 2000, .density = density, .speed = speed, .target_density = 1010});
  }
  return shots;
}

const double true_c = 0.3, true_s = 1.2e6;  // the depths are then 0.4 to 6 cm

CalibrationProblem dehn_problem(const std::vector<DehnShot>& shots, double scatter, unsigned seed) {
  CalibrationProblem problem;
  problem.parameters = {positive_parameter("c", 1e-3, 10), positive_parameter("s", 1e4, 1e9)};
  problem.groups = {{.name = "shots"}};
  Draws draws(seed);
  for (const DehnShot& shot : shots)
    problem.data.push_back(
        {.label = "shot", .value = dehn_depth(shot, true_c, true_s).log_depth + scatter * draws.normal()});
  problem.model = model_of(static_cast<int>(shots.size()), [shots](const VectorXd& at, int i) {
    const DehnDepth depth = dehn_depth(shots[i], std::exp(at[0]), std::exp(at[1]));
    return ValueAndGradient{depth.log_depth, Eigen::Vector2d(depth.gradient[0], depth.gradient[1])};
  });
  return problem;
}

const VectorXd dehn_truth = Eigen::Vector2d(std::log(true_c), std::log(true_s));

TEST(SlowCoverage, OfDehnsModelFromTheTwentyFourShots) {
  const auto shots = gelatin_shots();
  ASSERT_EQ(shots.size(), 24u);
  expect_nominal(coverage([&](unsigned seed) { return dehn_problem(shots, 0.06, seed); }, dehn_truth));
}

// y = m n (exp(k x) - 1): ln m + ln n and k are known, m and n are not.
TEST(SlowCoverage, OnARidgeOfTheCombinationsThatAreDetermined) {
  const VectorXd truth = Eigen::Vector3d(std::log(1.3), 0, 2);
  std::vector<double> held(2, 0);
  for (unsigned seed = 1; seed <= replicates; ++seed) {
    auto problem = curve_problem(12, 1.3, 2, 0.2, seed);
    problem.parameters.insert(problem.parameters.begin() + 1, positive_parameter("n", 1e-2, 1e2));
    problem.model = [inner = problem.model](const VectorXd& at, Want want) {
      ModelAnswer answer = inner(Eigen::Vector2d(at[0] + at[1], at[2]), want);
      answer.jacobian = MatrixXd(answer.jacobian(Eigen::all, std::vector{0, 0, 1}));
      return answer;
    };
    const Minimum minimum = refine(problem, truth, {}, {});
    const auto found = combinations(problem, minimum);
    EXPECT_TRUE(found[0].determined && found[1].determined && !found[2].determined) << "seed " << seed;
    for (int k = 0; k < 2; ++k) {
      const double off = found[k].weight.dot(minimum.searched - truth);
      const double t = student_quantile(0.975, effective_degrees_of_freedom(problem, minimum, found[k].weight));
      held[k] += (std::abs(off) <= t * found[k].standard_deviation) / double(replicates);
    }
  }
  expect_nominal(held);
}

// Shots at nearly one speed leave c and s on a curved ridge. What they do tell is the depth at that speed.
TEST(SlowCoverage, OnACurvedRidgeOfWhatTheDataMeasure) {
  std::vector<DehnShot> shots;
  for (int i = 0; i < 10; ++i)
    shots.push_back({.radius = 1.59e-3, .density = 7800, .speed = 50 + 0.1 * i, .target_density = 1010});
  double held = 0;
  for (unsigned seed = 1; seed <= replicates; ++seed) {
    const auto problem = dehn_problem(shots, 0.06, seed);
    const Minimum minimum = refine(problem, dehn_truth, {}, {});
    const DehnDepth found = dehn_depth(shots[5], std::exp(minimum.searched[0]), std::exp(minimum.searched[1]));
    const VectorXd gradient = Eigen::Vector2d(found.gradient[0], found.gradient[1]);
    const double t = student_quantile(0.975, effective_degrees_of_freedom(problem, minimum, gradient));
    const double off = found.log_depth - dehn_depth(shots[5], true_c, true_s).log_depth;
    held += std::abs(off) <= t * std::sqrt(gradient.dot(minimum.covariance * gradient));
  }
  expect_nominal({held / replicates});
}

// Twelve shots scatter by 10 %, a curve of 30 points gives the strength by itself, more finely: each group has its own scatter.
CalibrationProblem joint_problem(unsigned seed) {
  auto shots = gelatin_shots();
  shots.resize(12);
  CalibrationProblem problem = dehn_problem(shots, 0.1, seed);
  problem.groups.push_back({.name = "curve"});
  Draws draws(seed + 1000000);
  for (int i = 0; i < 30; ++i)
    problem.data.push_back(
        {.label = "curve", .value = dehn_truth[1] + 0.04 * draws.normal(), .error = 0.02, .group = 1});
  problem.model = model_of(42, [shots](const VectorXd& at, int i) {
    if (i >= 12) return ValueAndGradient{at[1], Eigen::Vector2d(0, 1)};
    const DehnDepth depth = dehn_depth(shots[i], std::exp(at[0]), std::exp(at[1]));
    return ValueAndGradient{depth.log_depth, Eigen::Vector2d(depth.gradient[0], depth.gradient[1])};
  });
  return problem;
}

TEST(SlowCoverage, OfCurvesAndDepthsTogether) { expect_nominal(coverage(joint_problem, dehn_truth)); }

// A model that is wrong by one number everywhere, drawn with the data: its covariance is what the intervals need.
CalibrationProblem biased_problem(unsigned seed, bool told) {
  auto shots = gelatin_shots();
  CalibrationProblem problem = dehn_problem(shots, 0.03, seed);
  problem.parameters.erase(problem.parameters.begin());
  problem.model = model_of(24, [shots](const VectorXd& at, int i) {
    const DehnDepth depth = dehn_depth(shots[i], true_c, std::exp(at[0]));
    return ValueAndGradient{depth.log_depth, VectorXd::Constant(1, depth.gradient[1])};
  });
  Draws draws(seed + 1000000);
  const double bias = 0.05 * draws.normal();
  problem.model = [inner = problem.model, bias, told](const VectorXd& at, Want want) {
    ModelAnswer answer = inner(at, want);
    answer.value.array() += bias;
    if (told && want == Want::values_and_covariance) answer.covariance = MatrixXd::Constant(24, 24, 0.05 * 0.05);
    return answer;
  };
  return problem;
}

TEST(SlowCoverage, OfAModelWithAnErrorOfItsOwnNeedsItsCovariance) {
  const VectorXd truth = VectorXd::Constant(1, std::log(true_s));
  const auto told = coverage([](unsigned seed) { return biased_problem(seed, true); }, truth);
  const auto untold = coverage([](unsigned seed) { return biased_problem(seed, false); }, truth);
  expect_nominal(told);
  EXPECT_LT(untold[0], 0.6);
}

// Where the bottom is in the way of the deeper half of the shots, they say "at least" this much.
TEST(SlowCoverage, WithAtLeastDataOfTheDeepShots) {
  const auto shots = gelatin_shots();
  const double bottom = std::log(0.04);
  const auto shortened = [&](unsigned seed) {
    CalibrationProblem problem = dehn_problem(shots, 0.06, seed);
    problem.groups[0] = {.name = "shots", .estimated = false, .fixed = 0.06};
    for (Datum& datum : problem.data)
      if (datum.value > bottom) {
        datum.value = bottom;
        datum.seen = Seen::at_least;
      }
    return problem;
  };
  expect_nominal(coverage(shortened, dehn_truth));
}

}  // namespace
}  // namespace percal
