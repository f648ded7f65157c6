// The stable step that the kernel bounds, against the largest eigenvalue of numerical tangents. docs/theory/impact.md, "Stable step".
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <random>

#include "percal/impact/kernel/element.hpp"
#include "percal/impact/kernel/fibres.hpp"
#include "percal/problem/problem.hpp"

namespace percal {
namespace {

using State = Eigen::Matrix<double, 5, 1>;  // F_rr, F_rz, F_zr, F_zz, hoop stretch

constexpr double along_r[4] = {-0.5, 0.5, 0.5, -0.5}, along_z[4] = {-0.5, -0.5, 0.5, 0.5},
                 hourglass_mode[4] = {1, -1, 1, -1};

struct SteppedSolid {
  double mu = 1, bulk = 50, alpha = 8.5, hourglass = 0.5;
  FibreConstants fibres = {};
};
struct Shape {
  double width, height, radius;  // infinite in plane strain
  double thickness() const { return std::isinf(radius) ? 1 : radius; }
  double corner_mass() const { return thickness() * width * height / 4; }
};
constexpr double plane = std::numeric_limits<double>::infinity();

scalar::Gradient<double> gradient(const State& F) { return {F[0], F[1], F[2], F[3], F[4]}; }

scalar::FibreResponse<double> fibres_at(const scalar::Gradient<double>& F, const scalar::Stretches<double>& s,
                                        const SteppedSolid& solid) {
  return scalar::fibre_response(F, s, solid.fibres.k1, solid.fibres.k2, solid.fibres.kappa);
}

State piola(const State& at, const SteppedSolid& solid) {
  const auto F = gradient(at);
  const auto s = scalar::stretches(F);
  const auto t = scalar::isochoric_stress(scalar::isochoric_powers(F, s, solid.alpha), 2 * solid.mu / solid.alpha);
  const auto P = scalar::first_piola(F, s, t, solid.bulk / 2 * (s.jacobian * s.jacobian - 1));
  State p;
  p << P.rr, P.rz, P.zr, P.zz, P.hoop;
  if (solid.fibres.is_none()) return p;
  const auto more = fibres_at(F, s, solid).stress;
  State of_fibres;
  of_fibres << more.rr, more.rz, more.zr, more.zz, more.hoop;
  return p + of_fibres;
}

// Stiffness of one element over (u_r, u_z) of its four corners; the material part by central differences.
Eigen::Matrix<double, 8, 8> stiffness(const State& at, const SteppedSolid& solid, const Shape& shape) {
  Eigen::Matrix<double, 5, 5> tangent;
  for (int k = 0; k < 5; ++k) {
    State above = at, below = at;
    above[k] += 1e-6;
    below[k] -= 1e-6;
    tangent.col(k) = (piola(above, solid) - piola(below, solid)) / 2e-6;
  }
  Eigen::Matrix<double, 5, 8> strain = Eigen::Matrix<double, 5, 8>::Zero();
  Eigen::Matrix<double, 8, 2> modes = Eigen::Matrix<double, 8, 2>::Zero();
  for (int a = 0; a < 4; ++a) {
    strain(0, 2 * a) = along_r[a] / shape.width;
    strain(1, 2 * a) = along_z[a] / shape.height;
    strain(2, 2 * a + 1) = along_r[a] / shape.width;
    strain(3, 2 * a + 1) = along_z[a] / shape.height;
    strain(4, 2 * a) = 1 / (4 * shape.radius);  // 0 in plane strain
    modes(2 * a, 0) = modes(2 * a + 1, 1) = hourglass_mode[a];
  }
  const double spring =
      solid.hourglass * solid.mu / 12 * (shape.height / shape.width + shape.width / shape.height) * shape.thickness();
  return shape.thickness() * shape.width * shape.height * strain.transpose() * (tangent + tangent.transpose()) / 2 *
             strain +
         spring * modes * modes.transpose();
}

// 1/dt^2 as the kernel takes it.
double bound(const State& at, const SteppedSolid& solid, const Shape& shape, bool at_axis) {
  const auto F = gradient(at);
  const auto s = scalar::stretches(F);
  const auto g = scalar::isochoric_powers(F, s, solid.alpha);
  const auto t = scalar::isochoric_stress(g, 2 * solid.mu / solid.alpha);
  const auto matrix = scalar::step_bound(s, g, t, solid.mu, solid.bulk, 1 / (shape.width * shape.width),
                                         1 / (shape.height * shape.height),
                                         (at_axis ? scalar::axis_hoop_share : 1) / (4 * shape.radius * shape.radius));
  if (solid.fibres.is_none()) return matrix.stiffness;
  return matrix.stiffness + fibres_at(F, s, solid).stiffness * matrix.over_stretch;
}

// All three stretches between these.
struct StretchRange {
  double least, most;
};
bool within(const State& F, const StretchRange& range) {
  Eigen::Matrix2d in_plane;
  in_plane << F[0], F[1], F[2], F[3];
  if (in_plane.determinant() <= 0) return false;
  const auto stretch = Eigen::JacobiSVD<Eigen::Matrix2d>(in_plane).singularValues();
  return stretch[0] < range.most && stretch[1] > range.least && F[4] < range.most && F[4] > range.least;
}

// What erosion at a strain of 0.7 lets live, with a volume between 0.7 and 1.1 of the first.
constexpr StretchRange alive{0.3, 1.7};

class RandomStates {
 public:
  explicit RandomStates(unsigned seed) : random_(seed) {}
  double between(double least, double most) { return std::uniform_real_distribution<double>(least, most)(random_); }

  State anywhere() {
    return with_hoop([&] { return between(0.3, 1.7); });
  }
  State in_plane_strain() {
    return with_hoop([] { return 1.0; });
  }

  template <class Hoop>
  State with_hoop(Hoop hoop) {
    for (;;) {
      State F;
      F << 0, between(-1.7, 1.7), between(-1.7, 1.7), 0, hoop();
      F[0] = between(-1.7, 1.7);
      F[3] = (between(0.7, 1.1) / F[4] + F[1] * F[2]) / F[0];
      if (within(F, alive)) return F;
    }
  }
  // On the axis the inner nodes keep their radius: F_rr and the hoop stretch are the same number.
  State at_axis() {
    for (;;) {
      State F;
      F[0] = F[4] = between(0.3, 1.7);
      F[1] = between(-1.7, 1.7);
      F[2] = between(-1.7, 1.7);
      F[3] = (between(0.7, 1.1) / F[4] + F[1] * F[2]) / F[0];
      if (within(F, alive)) return F;
    }
  }
  // An element beside one at the axis shares two nodes with it, whose mean radius gives its hoop stretch. It may find none.
  std::optional<State> beside(const State& axis) {
    for (int k = 0; k < 100; ++k) {
      State F;
      F[0] = between(0.1, 1.7);
      F[4] = (2 * axis[4] + F[0]) / 3;
      F[1] = between(-1.7, 1.7);
      F[2] = between(-1.7, 1.7);
      F[3] = (between(0.7, 1.1) / F[4] + F[1] * F[2]) / F[0];
      if (within(F, alive)) return F;
    }
    return std::nullopt;
  }

 private:
  std::mt19937 random_;
};

double largest_eigenvalue(const Eigen::MatrixXd& matrix) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly).eigenvalues().tail(1)[0];
}

// The kernel's step over the true one, 2/omega: how many times too long it is.
double step_over_true(double largest_square_frequency, double inverse_square_step) {
  return std::sqrt(std::max(largest_square_frequency, 0.0) / (4 * inverse_square_step));
}

double worst_away_from_the_axis(double alpha, double aspect, double radius, int count, unsigned seed = 20,
                                const FibreConstants& fibres = {}) {
  RandomStates states(seed);
  const SteppedSolid solid{.alpha = alpha, .fibres = fibres};
  const Shape shape{aspect, 1, radius};
  double worst = 0;
  for (int k = 0; k < count; ++k) {
    const State F = std::isinf(radius) ? states.in_plane_strain() : states.anywhere();
    const Eigen::MatrixXd scaled = stiffness(F, solid, shape) / shape.corner_mass();
    worst = std::max(worst, step_over_true(largest_eigenvalue(scaled), bound(F, solid, shape, false)));
  }
  return worst;
}

// With the time-step factor the step is never longer than the limit.
void never_too_long(double worst) {
  testing::Test::RecordProperty("worst", std::to_string(worst));
  EXPECT_LT(worst * Problem{}.time_step_factor, 1);
}

TEST(StepBound, IsHardlyTooLongAwayFromTheAxis) {
  double worst = 0;
  for (const double alpha : {-20.0, -6.0, 2.0, 8.5, 20.0})
    for (const double aspect : {1.0, 3.0})
      for (const double radius : {1.5 * aspect, 5.5 * aspect, plane})
        worst = std::max(worst, worst_away_from_the_axis(alpha, aspect, radius, 1000));
  never_too_long(worst);
  EXPECT_GT(worst, 0.95) << "nor much too short";
}

TEST(SlowStepBound, IsNeverLongerThanTheLimitInTwentyThousandStates) {
  for (const double radius : {1.5, 5.5, plane}) {
    double worst = 0;
    for (const double alpha : {-20.0, -6.0, -2.0, 1.0, 2.0, 3.0, 8.5, 12.0, 20.0})
      for (const double aspect : {0.5, 1.0, 3.0})
        worst = std::max(worst, worst_away_from_the_axis(alpha, aspect, radius * aspect, 20000, 21));
    never_too_long(worst);
    std::printf("radius %g: %.3f\n", radius, worst);
  }
}

// The axis column's elements have half of their corners held and little mass; what makes its step safe with a quarter of its hoop
// term is the mass of the second column on the nodes between. So the two are taken together: no element outside the pair lends them its mass.
double worst_of_the_axis_pair(double alpha, double aspect, int count, const FibreConstants& fibres = {}) {
  RandomStates states(7);
  const SteppedSolid solid{.alpha = alpha, .fibres = fibres};
  const Shape first{aspect, 1, 0.5 * aspect}, second{aspect, 1, 1.5 * aspect};
  const int of_first[4] = {0, 1, 4, 3}, of_second[4] = {1, 2, 5, 4};
  double worst = 0;
  for (int k = 0; k < count; ++k) {
    const State F = states.at_axis();
    const auto G = states.beside(F);
    if (!G) continue;
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(12, 12);
    Eigen::VectorXd mass = Eigen::VectorXd::Zero(12);
    const auto add = [&](const Eigen::MatrixXd& element, const Shape& shape, const int(&nodes)[4]) {
      for (int a = 0; a < 8; ++a) {
        const int row = 2 * nodes[a / 2] + a % 2;
        mass[row] += shape.corner_mass();
        for (int b = 0; b < 8; ++b) K(row, 2 * nodes[b / 2] + b % 2) += element(a, b);
      }
    };
    add(stiffness(F, solid, first), first, of_first);
    add(stiffness(*G, solid, second), second, of_second);
    for (const int held : {0, 6}) {  // u_r on the axis
      K.row(held).setZero();
      K.col(held).setZero();
    }
    const Eigen::VectorXd per_root_mass = mass.cwiseSqrt().cwiseInverse();
    const Eigen::MatrixXd scaled = per_root_mass.asDiagonal() * K * per_root_mass.asDiagonal();
    worst = std::max(worst, step_over_true(largest_eigenvalue(scaled),
                                           std::max(bound(F, solid, first, true), bound(*G, solid, second, false))));
  }
  return worst;
}

TEST(StepBound, IsHardlyTooLongAtTheAxis) {
  double worst = 0;
  for (const double alpha : {-20.0, -6.0, -2.0, 1.0, 2.0, 3.0, 8.5, 12.0, 20.0})
    for (const double aspect : {1.0, 2.0}) worst = std::max(worst, worst_of_the_axis_pair(alpha, aspect, 2000));
  never_too_long(worst);
}

TEST(SlowStepBound, IsNeverLongerThanTheLimitInTwentyThousandStatesAtTheAxis) {
  double worst = 0;
  for (const double alpha : {-20.0, -6.0, -2.0, 1.0, 2.0, 3.0, 8.5, 12.0, 20.0})
    for (const double aspect : {0.5, 1.0, 2.0}) worst = std::max(worst, worst_of_the_axis_pair(alpha, aspect, 20000));
  never_too_long(worst);
  std::printf("axis: %.3f\n", worst);
}

TEST(StepBound, IsNotTooLongWhereFibresAreStifferThanTheMatrix) {
  double worst = 0;
  for (const double k1 : {1.0, 30.0, 1000.0})
    for (const double k2 : {0.1, 3.0})
      for (const double kappa : {1.0 / 3, 0.42, 0.5}) {
        const FibreConstants fibres{k1, k2, kappa};
        for (const double radius : {1.5, 5.5, plane})
          worst = std::max(worst, worst_away_from_the_axis(8.5, 1, radius, 500, 20, fibres));
        worst = std::max(worst, worst_of_the_axis_pair(8.5, 1, 500, fibres));
      }
  never_too_long(worst);
}

TEST(StepBound, IsTheClosedFormInTheUndeformedState) {
  State rest;
  rest << 1, 0, 0, 1, 1;
  const SteppedSolid solid;
  const Shape shape{0.5, 0.25, 3};
  EXPECT_NEAR(bound(rest, solid, shape, false), (50 + 4.0 / 3) * (4 + 16 + 1.0 / 36), 1e-5);
  EXPECT_NEAR(bound(rest, solid, shape, true), (50 + 4.0 / 3) * (4 + 16 + 1.0 / 144), 1e-5);
}

}  // namespace
}  // namespace percal
