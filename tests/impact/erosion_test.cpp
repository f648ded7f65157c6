// When an element goes, and what becomes of the nodes that are left.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "impact/element_reference.hpp"
#include "impact/setting_s.hpp"
#include "percal/impact/march/march.hpp"
#include "percal/problem/replicates.hpp"

namespace percal {
namespace {

// A deformation of the plane as a function of time; out of the plane nothing stretches.
struct InPlane {
  double xx, xz, zx, zz;
};
using Motion = std::function<InPlane(double)>;

InPlane turned_field(double angle, const InPlane& F) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * F.xx - s * F.zx, c * F.xz - s * F.zz, s * F.xx + c * F.zx, s * F.xz + c * F.zz};
}

double squared_stretch(const InPlane& F) {
  const double a = F.xx * F.xx + F.zx * F.zx, c = F.xz * F.xz + F.zz * F.zz, b = F.xx * F.xz + F.zx * F.zz;
  return 0.5 * (a + c) + std::sqrt(0.25 * (a - c) * (a - c) + b * b);
}

constexpr double limit = 1.5;

// When the largest stretch passes the limit: it grows all the time.
double crossing_time(const Motion& motion) {
  double before = 0, after = 2;
  while (after - before > 1e-13) {
    const double middle = (before + after) / 2;
    (squared_stretch(motion(middle)) > limit * limit ? after : before) = middle;
  }
  return after;
}

// One column of elements whose nodes are moved as told.
class DrivenColumn {
 public:
  DrivenColumn() : problem_(plane()), block_(problem_, mesh_of(problem_), kernel<double>().lanes) {
    material_ = constants_of(problem_);
    material_.erosion_stretch = limit;
    material_.bulk = 1;  // forces don't matter here
  }

  // The step, counted from `first_time`, in which the kernel takes the elements out.
  double deletion_time(const Motion& motion, double first_time, double step) {
    const auto& view = block_.view();
    for (int j = 0; j < block_.mesh().rows; ++j) {
      view.alive[block_.at(0, j)] = 1;
      view.jacobian[block_.at(0, j)] = 1;
      view.erosion_measure[block_.at(0, j)] = squared_stretch(motion(first_time - step));
    }
    for (double time = first_time;; time += step) {
      move(motion(time));
      ColumnReport report;
      column_internal_forces(kernel<double>(), block_, 0, material_, step, report);
      if (report.doomed == 0) continue;
      EXPECT_EQ(report.doomed, block_.mesh().rows) << "all are strained alike";
      return time;
    }
  }

 private:
  static Problem plane() {
    Problem p = small_problem(3);
    p.geometry = Geometry::plane_strain;
    p.depth = 4;
    return p;
  }
  void move(const InPlane& F) {
    for (int i = 0; i <= 1; ++i)
      for (int j = 0; j <= block_.mesh().rows; ++j) {
        const double x = block_.mesh().radius[i], z = j * block_.mesh().row_height;
        block_.view().u_r[block_.at(i, j)] = (F.xx - 1) * x + F.xz * z;
        block_.view().u_z[block_.at(i, j)] = F.zx * x + (F.zz - 1) * z;
      }
  }
  Problem problem_;
  Block<double> block_;
  MaterialConstants material_;
};

struct Lateness {
  double mean, standard_error;  // in steps
};
Lateness lateness(const std::function<double(double first_time, double step)>& deletion, double crossing, double step,
                  unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> phase(0, 1);
  constexpr int phases = 2000;
  double sum = 0, squares = 0;
  for (int k = 0; k < phases; ++k) {
    const double first_time = crossing - (3 + phase(random)) * step;
    const double late = (deletion(first_time, step) - crossing) / step;
    sum += late;
    squares += late * late;
  }
  const double mean = sum / phases;
  return {mean, std::sqrt((squares / phases - mean * mean) / phases)};
}

const Motion pull = [](double t) { return InPlane{1 / (1 + 0.6 * t), 0, 0, 1 + 0.6 * t}; };
const Motion turning_pull = [](double t) { return turned_field(0.8 * t, pull(t)); };
const Motion shear = [](double t) { return InPlane{1, 1.2 * t, 0, 1}; };

// The limit is passed at any moment of a step with the same chance. What is left of the half step's linear guess is of the order
// of the step squared: 0.003 steps at the largest step here, a third of the standard error.
TEST(Erosion, TheDeletionTimeIsUnbiasedInTheStep) {
  DrivenColumn column;
  unsigned seed = 1;
  for (const Motion& motion : {pull, turning_pull, shear})
    for (const double step : {0.001, 0.003, 0.01}) {
      const double crossing = crossing_time(motion);
      const auto by_kernel =
          lateness([&](double first_time, double dt) { return column.deletion_time(motion, first_time, dt); }, crossing,
                   step, seed);
      EXPECT_LT(std::abs(by_kernel.mean), 3 * by_kernel.standard_error) << "step " << step << ", seed " << seed;
      // The same judged by the stretch at the step's end is half a step late, and this test would see it.
      const auto at_the_end = lateness(
          [&](double first_time, double dt) {
            double time = first_time;
            while (squared_stretch(motion(time)) <= limit * limit) time += dt;
            return time;
          },
          crossing, step, seed);
      EXPECT_NEAR(at_the_end.mean, 0.5, 4 * at_the_end.standard_error);
      EXPECT_GT(at_the_end.mean, 20 * at_the_end.standard_error);
      ++seed;
    }
}

// Debris that is struck goes on as fast as the particle, and then bears nothing: it hardly matters whether it is there.
TEST(Erosion, ErodedNodesThatStayInContactMoveTheDepthByLittle) {
  Problem p = setting_s(7);
  double released = 0, kept = 0;
  for (int k = 0; k < 5; ++k) {
    p.speed_factor = replicate_speed_factor(k);
    p.eroded_nodes = ErodedNodes::released;
    released += run_impact(p).depth / 5;
    p.eroded_nodes = ErodedNodes::in_contact;
    const ImpactResult result = run_impact(p);
    EXPECT_EQ(result.outcome, Outcome::stopped);
    EXPECT_LT(std::abs(result.energy.closure()), 0.02);
    kept += result.depth / 5;
  }
  RecordProperty("released", std::to_string(released));
  RecordProperty("kept", std::to_string(kept));
  EXPECT_NE(kept, released);
  EXPECT_NEAR(kept, released, 0.05 * released);
}

}  // namespace
}  // namespace percal
