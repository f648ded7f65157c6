// A job of every kind of block, to be read as it stands or with changes, and a result of it made by hand.
#pragma once
#include <limits>
#include <utility>

#include "percal/base/error.hpp"
#include "percal/calibrate/result.hpp"
#include "support/program.hpp"

namespace percal::calibrate_test {

inline const std::string small_job = R"(title = "Jelly"
level = 0.9
bootstrap = 20

[parameters.mu]
kind = "modulus"
low = "10 kPa"
high = "1 MPa"
prior = "100 kPa"
prior_error = "50 %"

[parameters.mu_hard]
kind = "modulus"
low = "20 kPa"
high = "2 MPa"

[parameters.alpha]
kind = "exponent"
low = 2
high = 12

[parameters.strain]
kind = "erosion strain"
low = 0.3
high = 1.5

[materials.soft]
density = "1000 kg/m3"
mu = "mu"
alpha = "alpha"
erosion_strain = "strain"
rate_factor = 10
rate_factor_error = "5 %"
curve_modulus = "90 kPa"

[materials.hard]
density = "1100 kg/m3"
mu = "mu_hard"
alpha = "alpha"
erosion_strain = 0.8

[[shots]]
name = "balls"
material = "soft"
file = "balls.csv"
where = ["usable=yes"]
particle_column = "ball"
particle_density_column = "density_kg_m3"
diameter_column = "diameter_mm"
speed_column = "speed_m_s"
speed_error = "2 m/s"
depth_column = "depth_mm"
depth_error = "5 %"
depth_error_where = ["ball=steel"]
at_least_where = ["depth_mm=60"]
fit_where = ["ball=steel"]
layer_depth = "6 cm"
layer_width_radii = 5
leave_one_out = true

[[shots]]
name = "by hand"
material = "hard"
speed_error = "1 m/s"
layer_depth_radii = 40
scatter = "few"

[[shots.points]]
diameter = "2 mm"
particle_density = "7800 kg/m3"
speed = "50 m/s"
depth = "11 mm"
depth_error = "0.4 mm"

[[shots.points]]
label = "the fast one"
radius = "1 mm"
particle_density = "7800 kg/m3"
speed = "90 m/s"
depth = "20 mm"
at_least = true
use = "predict"

[[curves]]
name = "tension"
material = "soft"
file = "curve.csv"
where = ["test=a"]
x = "stretch"
y = "stress"
mode = "uniaxial"
error = 0.02
rate_factor = 10
rate_factor_error = 0.1
scatter = "curves"
synthetic = true

[scatter.few]
fixed = "3 %"

[[hypotheses]]
name = "free"

[[hypotheses]]
name = "held"
hold = { mu = "90 kPa", alpha = 5 }
convention = "mu/alpha"
measure = "true"

[[cross_validation]]
name = "steel -> lead"
fit = ["set=balls", "ball=steel"]
predict = ["ball=lead"]
goal = "7 %"
hypotheses = ["free"]

[[ridge_points]]
name = "somebody's"
parameter = "mu"
file = "pairs.csv"
mu = "mu"
erosion_strain = "strain"

[training]
coarse = 4
fine = 6
verify = 7
initial = 20
batch = 5
most = 30
fine_share = "25 %"
accuracy = 0.5
failures_tolerated = 0.3
verify_replicates = 2
seed = 7

[solver]
arithmetic = "double"
)";

// Targets for it, before [materials.soft]; a block of shots must name one.
inline const std::string layers_of_a_job = R"(
[targets.dressed]
material = "hard"
[[targets.dressed.covers]]
material = "soft"
thickness = "0.5 mm"
[[targets.dressed.covers]]
material = "hard"
thickness = "2 mm"
)";

class SmallJob : public test::Program {
 protected:
  SmallJob() {
    write("balls.csv",
          "ball,density_kg_m3,diameter_mm,speed_m_s,depth_mm,usable\n"
          "steel,7800,3,40,15,yes\nsteel,7800,3,60,24,yes\nsteel,7800,3,80,60,yes\nsteel,7800,2,80,14,no\n"
          "lead,11340,3,50,31,yes\n");
    write("curve.csv", "test,stretch,stress_kPa\na,1.1,5.5\na,1.2,11\nb,1.3,90\n");
    write("pairs.csv", "mu_kPa,strain\n80,0.9\n120,0.7\n");
  }

  std::string job(const std::vector<std::pair<std::string, std::string>>& replacements = {}) const {
    std::string text = small_job;
    for (const auto& [from, to] : replacements) {
      const auto at = text.find(from);
      if (at == std::string::npos) throw std::runtime_error("the job has no text \"" + from + "\"");
      text.replace(at, from.size(), to);
    }
    return write("job.toml", text);
  }
  CalibrationJob read_job(const std::vector<std::pair<std::string, std::string>>& replacements = {}) const {
    return read_calibration_job(job(replacements));
  }
};

// Every part of a result has something in it; the numbers are made up. Of the small job.
inline CalibrationResult made_up_result(const CalibrationJob& job) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  Minimum minimum;
  minimum.searched = Eigen::Vector4d(std::log(1e5), std::log(2e5), 6, std::log(0.9));
  minimum.objective = 12;
  minimum.deviance = 5;
  minimum.scatter = {0.03, 0.05, infinity};
  minimum.covariance = Eigen::Matrix4d::Identity() * 0.01;
  minimum.information = Eigen::Matrix4d::Identity() * 100;
  minimum.at_bound = {false, false, true, false};
  minimum.converged = true;
  minimum.degrees_of_freedom = 3;
  Minimum second = minimum;
  second.deviance = 7.5;

  HypothesisResult hypothesis;
  hypothesis.index = 0;
  hypothesis.parameters = {0, 1, 2, 3};
  hypothesis.minima = {minimum, second};
  hypothesis.intervals = {{0, {8e4, 1.3e5, false, false}, {{std::log(8e4), 2.7, {}}, {std::log(1e5), 0, {}}}, true},
                          {1, {2e4, 2e6, true, true}, {}, false},
                          {2, {5, 12, false, true}, {}, true},
                          {3, {0.7, 1.1, false, false}, {}, true}};
  hypothesis.bootstrap = Bootstrap{Eigen::MatrixXd::Zero(19, 4), {{8.1e4, 1.2e5}, {3e4, 1e6}, {5, 11}, {0.7, 1}}, 1};
  hypothesis.combinations = {{Eigen::Vector4d(1, 0, 0, 0), 0.1, true}};
  RidgeMap ridge{3, 0, {0.5, 1}, {5e4, 2e5}, Eigen::MatrixXd::Zero(2, 2), 4.6, {{{0.6, 1.4e5}, {1.1, 7e4}}}};
  ridge.rise(0, 0) = infinity;
  hypothesis.ridges = {ridge};
  for (int i = 0; i < static_cast<int>(job.shots.size()); ++i) {
    const MeasuredShot& shot = job.shots[i];
    ShotDepth depth{i, 1.1 * shot.depth, 0.01, 0.9 * shot.depth, 1.3 * shot.depth, shot.used, {}};
    if (shot.is_number()) depth.deviation = 0.1;
    hypothesis.shots.push_back(depth);
  }
  hypothesis.curves = {{0, {5.2e3, 1.05e4}, {4.8e3, 9.8e3}, {5.6e3, 1.12e4}}};
  hypothesis.sets = {{"balls, fitted", 2, 0.08, -0.02, 2}, {"by hand, predicted", 0, 0, 0, 0}};
  hypothesis.fresh = {{0, 7, 0.0157, "stopped", 0.0155, 0.8}, {1, 7, {}, "passed through", 0.024, 0}};
  hypothesis.fresh_deviation = 0.047;
  hypothesis.cross_validations = {
      {"steel -> lead", 3, hypothesis.shots, {"fitted", 3, 0.04, 0, 3}, {"predicted", 1, 0.06, 0.06, 1}, 0.07}};
  hypothesis.leave_one_out = {{"leave one out: balls", 0, hypothesis.shots, {}, {"predicted", 4, 0.125, -0.01, 3}, {}}};
  MaterialModuli soft{.material = "soft", .curve_modulus = 9e4};
  soft.mu_true = {1e5, {8e4, 1.3e5}};
  soft.mu_over_alpha = {3.3e4, {2e4, 5e4}};
  soft.youngs_quasi_static_true = Estimate{3e4, {2.4e4, 3.9e4}};
  soft.youngs_quasi_static_over_alpha = Estimate{1e4, {8e3, 1.3e4}};
  MaterialModuli hard{.material = "hard", .curve_modulus = {}};
  hard.mu_true = {2e5, {2e4, nan, true, true}};
  hypothesis.moduli = {soft, hard};
  hypothesis.budgets = {{"E of soft",
                         {{"scatter: shots", 0.08, 0.64}, {"rate factor", 0.06, 0.36}},
                         0.1,
                         {3e4, {2.4e4, 3.9e4}},
                         "steel 3 mm",
                         -1.7}};
  hypothesis.advice = {{"E of soft: three more shots", 0.8}};
  hypothesis.mesh_error = -0.004;
  hypothesis.findings = {"The strain and the modulus go together."};

  hypothesis.for_shots = {.name = "as given",
                          .materials = {{.name = "soft", .points = {LayerMaterial{1000, 1e5, 6, 0.9}}}}};

  HypothesisResult held = hypothesis;
  held.index = 1;
  held.parameters = {1, 3};
  held.minima.clear();
  held.intervals.clear();
  held.bootstrap.reset();
  held.combinations.clear();
  held.ridges.clear();
  held.fresh.clear();

  DehnResult dehn;
  dehn.parameters = {{.name = "c", .unit = "", .low = 1e-3, .high = 10},
                     {.name = "s of soft", .unit = "Pa", .low = 1e2, .high = 1e10}};
  dehn.minimum = minimum;
  dehn.minimum.searched = Eigen::Vector2d(std::log(0.3), std::log(3e5));
  dehn.minimum.covariance = Eigen::Matrix2d::Identity();
  dehn.minimum.at_bound = {false, false};
  dehn.shots = hypothesis.shots;
  dehn.sets = {{"balls, fitted", 2, 0.11, 0, 2}};
  dehn.cross_validations = {{"steel -> lead", 3, {}, {}, {"predicted", 1, 0.031, 0, 1}, 0.07}};
  dehn.leave_one_out = {{"leave one out: balls", 0, {}, {}, {"predicted", 4, 0.151, 0, 3}, {}}};

  EmulatorReport emulator;
  emulator.runs = 20;
  emulator.reused = 10;
  emulator.foreign = 3;
  emulator.outcomes = {{"stopped", 25}, {"passed through", 5}};
  emulator.leave_one_out = 0.02;
  emulator.standardised_deviation = 1.05;
  emulator.coverage95 = 0.94;
  emulator.error_at_optimum = 0.011;
  emulator.data_error = 0.05;
  emulator.stopped = "30 runs were made";
  emulator.rounds = {{20, 4, 0.03}, {30, 8, 0.011}};

  CalibrationResult result;
  result.emulator = emulator;
  result.hypotheses = {hypothesis, held};
  result.dehn = dehn;
  result.findings = {"Dehn predicts better."};
  result.cost = {20, 10, 9, 8, 60.0, "Twice the runs would help.", "x86_64_v2"};
  return result;
}

}  // namespace percal::calibrate_test
