// The brick's formulas against an eigensolver, its energy and the eigenvalues of its stiffness. docs/theory/solid.md.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "percal/impact/kernel/fibres.hpp"
#include "percal/impact/kernel/kernel.hpp"
#include "percal/solid/target/solid_of.hpp"

namespace percal {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
namespace hex = scalar::hex;

hex::Tensor<double> tensor(const Matrix3d& F) {
  return {F(0, 0), F(0, 1), F(0, 2), F(1, 0), F(1, 1), F(1, 2), F(2, 0), F(2, 1), F(2, 2)};
}
Matrix3d matrix(const hex::Tensor<double>& P) {
  Matrix3d M;
  M << P.xx, P.xy, P.xz, P.yx, P.yy, P.yz, P.zx, P.zy, P.zz;
  return M;
}

MaterialConstants solid_of(double alpha) { return {.mu = 1, .bulk = 50, .alpha = alpha, .hourglass = 2}; }

// By eigenvectors of b, in double.
Matrix3d reference_piola(const Matrix3d& F, const MaterialConstants& m) {
  const Eigen::SelfAdjointEigenSolver<Matrix3d> b(F * F.transpose());
  const double J = F.determinant();
  Vector3d g = (b.eigenvalues() * std::pow(J, -2.0 / 3)).array().pow(m.alpha / 2);
  const Vector3d tau = (2 * m.mu / m.alpha) * (g.array() - g.mean()) + m.bulk / 2 * (J * J - 1);
  return b.eigenvectors() * tau.asDiagonal() * b.eigenvectors().transpose() * F.inverse().transpose();
}

// The same in the arithmetic of the solver, single precision.
struct Single {
  Matrix3d piola;
  double largest;  // squared stretch
};
Single single_piola(const Matrix3d& F, const MaterialConstants& m) {
  const auto f = [&](int i, int j) { return static_cast<float>(F(i, j)); };
  const auto d = hex::deformation_of(
      hex::Tensor<float>{f(0, 0), f(0, 1), f(0, 2), f(1, 0), f(1, 1), f(1, 2), f(2, 0), f(2, 1), f(2, 2)});
  const auto g = hex::powers_of(d.spectrum, d.mean, static_cast<float>(m.alpha));
  auto tau =
      hex::isochoric_kirchhoff(d.B, d.B2, d.trace_of_square, d.spectrum, g, static_cast<float>(2 * m.mu / m.alpha));
  const float pressure = scalar::kirchhoff_pressure(PressureLaw::log_quadratic, d.jacobian, static_cast<float>(m.bulk));
  tau.xx += pressure, tau.yy += pressure, tau.zz += pressure;
  const auto P = hex::first_piola(tau, d);
  Single single{.largest = d.spectrum.largest};
  single.piola << P.xx, P.xy, P.xz, P.yx, P.yy, P.yz, P.zx, P.zy, P.zz;
  return single;
}

class States {
 public:
  explicit States(unsigned seed) : random_(seed) {}
  double between(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }
  Matrix3d rotation() {
    std::normal_distribution<double> normal;
    return Eigen::Quaterniond(normal(random_), normal(random_), normal(random_), normal(random_)).normalized().matrix();
  }
  // Volume to 2 %.
  Matrix3d of(Vector3d stretches) {
    stretches *= std::cbrt(between(0.98, 1.02) / stretches.prod());
    return rotation() * stretches.asDiagonal() * rotation();
  }

 private:
  std::mt19937 random_;
};

struct Kind {
  const char* name;
  Vector3d (*stretches)(States&);
  double rms, worst,
      largest;  // of P over max(mu, |P|); of the largest squared stretch, which may lie as far off as nodes are taken apart
};
const Kind kinds[] = {
    {"0.3 to 1.7", [](States& s) { return Vector3d(s.between(0.3, 1.7), s.between(0.3, 1.7), s.between(0.3, 1.7)); },
     1e-5, 2e-4, 3e-4},
    {"within 0.1", [](States& s) { return Vector3d(s.between(0.9, 1.1), s.between(0.9, 1.1), s.between(0.9, 1.1)); },
     8e-6, 5e-5, 3e-4},
    {"all equal to 1e-4",
     [](States& s) {
       return Vector3d(1 + 1e-4 * s.between(-1, 1), 1 + 1e-4 * s.between(-1, 1), 1 + 1e-4 * s.between(-1, 1));
     },
     8e-6, 5e-5, 3e-4},
    {"all equal", [](States&) { return Vector3d(1, 1, 1); }, 8e-6, 5e-5, 3e-4},
    {"the smaller two equal to 1e-3",
     [](States& s) { return Vector3d(1.6, 0.79 * (1 + 1e-3 * s.between(-1, 1)), 0.79); }, 8e-6, 5e-5, 3e-4},
    {"the larger two equal to 1e-5",
     [](States& s) { return Vector3d(1.5, 1.5 * (1 + 1e-5 * s.between(-1, 1)), 1 / 2.25); }, 8e-6, 5e-5, 3e-4},
};

TEST(Brick, StressWithoutEigenvectorsIsThatOfAnEigensolver) {
  constexpr int states = 20'000;
  for (const double alpha : {2.0, 8.5, 13.8, 20.0, -6.0})
    for (const Kind& kind : kinds) {
      States random(1);
      const MaterialConstants m = solid_of(alpha);
      double squares = 0, worst = 0, largest = 0;
      for (int k = 0; k < states; ++k) {
        // What single precision has of F is the state.
        const Matrix3d F = random.of(kind.stretches(random)).cast<float>().cast<double>();
        const Matrix3d P = reference_piola(F, m);
        const Single single = single_piola(F, m);
        const double error = (single.piola - P).cwiseAbs().maxCoeff() / std::max(m.mu, P.cwiseAbs().maxCoeff());
        squares += error * error;
        worst = std::max(worst, error);
        const double square = Eigen::SelfAdjointEigenSolver<Matrix3d>(F * F.transpose()).eigenvalues()[2];
        largest = std::max(largest, std::abs(single.largest - square) / square);
      }
      SCOPED_TRACE(testing::Message() << "alpha " << alpha << ", stretches " << kind.name);
      EXPECT_LT(std::sqrt(squares / states), kind.rms);
      EXPECT_LT(worst, kind.worst);
      EXPECT_LT(largest, kind.largest);
    }
}

// Relative to the largest component of stress, or to mu.
void expect_derivative_of_energy(const MaterialConstants& m, const Matrix3d& F, double tolerance) {
  const Matrix3d P = matrix(first_piola(m, tensor(F)));
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      constexpr double step = 1e-5;
      Matrix3d above = F, below = F;
      above(i, j) += step;
      below(i, j) -= step;
      const double slope = (energy_density(m, tensor(above)) - energy_density(m, tensor(below))) / (2 * step);
      EXPECT_NEAR(P(i, j), slope, tolerance * std::max(1.0, P.cwiseAbs().maxCoeff())) << "alpha " << m.alpha;
    }
}

TEST(Brick, StressIsTheDerivativeOfItsEnergy) {
  States random(2);
  for (const double alpha : {8.5, 2.0, 20.0, -6.0})
    for (int k = 0; k < 200; ++k) {
      const MaterialConstants m = solid_of(alpha);
      const Matrix3d F = random.of({random.between(0.5, 1.6), random.between(0.5, 1.6), random.between(0.5, 1.6)});
      expect_derivative_of_energy(m, F, 1e-6);
    }
}

// Where all fibres are taut or slack: the switch between is a kink of the modulus.
TEST(Brick, StressOfFibresIsTheDerivativeOfTheirEnergy) {
  States random(7);
  for (const FibreConstants& fibres :
       {FibreConstants{2, 0.8, 0.45}, FibreConstants{2, 0.8, 0, true, 0.7}, FibreConstants{3, 2, 0.2, true, 0.3}})
    for (int k = 0; k < 100; ++k) {
      MaterialConstants m = solid_of(3);
      m.fibres = fibres;
      const Matrix3d F = random.of({random.between(0.8, 1.4), random.between(0.8, 1.4), random.between(0.8, 1.4)});
      expect_derivative_of_energy(m, F, 1e-4);
    }
}

// Along a family without dispersion: W = 2 k1/(2 k2) (exp(k2 (lambda^2 - 1)^2) - 1) of two families on one line, none across.
TEST(Brick, FibresOfOneDirectionBearAlongItAlone) {
  MaterialConstants m = solid_of(2), bare = m;
  m.fibres = {0.7, 1.3, 0, true, 0};
  const auto stretched = [](double x, double y, double z) { return hex::Tensor<double>{x, 0, 0, 0, y, 0, 0, 0, z}; };
  const double E = 1.2 * 1.2 - 1, more = 0.7 / 1.3 * (std::exp(1.3 * E * E) - 1);
  const double across = 1 / std::sqrt(1.2);
  EXPECT_NEAR(energy_density(m, stretched(1.2, across, across)) - energy_density(bare, stretched(1.2, across, across)),
              more, 1e-12);
  EXPECT_EQ(energy_density(m, stretched(across, 1.2, across)), energy_density(bare, stretched(across, 1.2, across)));
}

// All directions alike, as the axisymmetric solver has them.
TEST(Brick, PlanarFibresAreThoseOfTheAxisymmetricSolver) {
  MaterialConstants m = solid_of(3), bare = m;
  m.fibres = {0.7, 1.3, 0.45};
  const scalar::Gradient<double> F{1.15, 0.1, -0.05, 0.8, 1.1};
  const hex::Tensor<double> same{1.15, 0, 0.1, 0, 1.1, 0, -0.05, 0, 0.8};
  const auto expected = scalar::fibre_response(F, scalar::stretches(F), 0.7, 1.3, 0.45);
  EXPECT_NEAR(energy_density(m, same) - energy_density(bare, same), expected.energy, 1e-12);
  const auto P = first_piola(m, same), without = first_piola(bare, same);
  EXPECT_NEAR(P.xx - without.xx, expected.stress.rr, 1e-12);
  EXPECT_NEAR(P.zx - without.zx, expected.stress.zr, 1e-12);
  EXPECT_NEAR(P.yy - without.yy, expected.stress.hoop, 1e-12);
}

TEST(Brick, ARigidRotationMakesNoStress) {
  States random(3);
  for (int k = 0; k < 100; ++k)
    EXPECT_LT(matrix(first_piola(solid_of(8.5), tensor(random.rotation()))).cwiseAbs().maxCoeff(), 1e-10);
}

// Of a corner in x, y, z, in the order of Corners8.
double sign(int corner, bool lower, int direction) {
  const bool far[3] = {(corner & 1) != 0, (corner & 2) != 0, lower};
  return far[direction] ? 1 : -1;
}

hex::Corners8<double> corners_of(const std::function<double(double, double, double)>& u) {
  hex::Corners8<double> corners{};
  for (int c = 0; c < 4; ++c) {
    corners.upper[c] = u(sign(c, false, 0), sign(c, false, 1), sign(c, false, 2));
    corners.lower[c] = u(sign(c, true, 0), sign(c, true, 1), sign(c, true, 2));
  }
  return corners;
}

std::array<double, 7> list(const hex::Modes<double>& m) { return {m.x, m.y, m.z, m.xy, m.xz, m.yz, m.xyz}; }

TEST(Brick, ModesAreSumsWithTheCornersSigns) {
  const std::array<std::function<double(double, double, double)>, 7> fields{
      [](double x, double, double) { return x; },
      [](double, double y, double) { return y; },
      [](double, double, double z) { return z; },
      [](double x, double y, double) { return x * y; },
      [](double x, double, double z) { return x * z; },
      [](double, double y, double z) { return y * z; },
      [](double x, double y, double z) { return x * y * z; }};
  for (std::size_t k = 0; k < fields.size(); ++k) {
    const auto modes = list(hex::modes_of(corners_of(fields[k])));
    for (std::size_t other = 0; other < modes.size(); ++other) EXPECT_EQ(modes[other], other == k ? 8 : 0);
    std::array<double, 7> one{};
    one[k] = 1;
    const auto forces = hex::corner_forces(hex::Modes<double>{one[0], one[1], one[2], one[3], one[4], one[5], one[6]});
    const auto expected = corners_of(fields[k]);
    for (int c = 0; c < 4; ++c) {
      EXPECT_EQ(forces.upper[c], -expected.upper[c]) << k;
      EXPECT_EQ(forces.lower[c], -expected.lower[c]) << k;
    }
  }
}

// The largest eigenvalue of the whole element, hourglass springs too, by numerical tangents.
double largest_frequency_squared(const Matrix3d& F, const MaterialConstants& m, const Vector3d& sides) {
  Eigen::Matrix<double, 9, 9> tangent;
  for (int k = 0; k < 9; ++k) {
    Matrix3d above = F, below = F;
    above(k / 3, k % 3) += 1e-6;
    below(k / 3, k % 3) -= 1e-6;
    const Matrix3d slope = (matrix(first_piola(m, tensor(above))) - matrix(first_piola(m, tensor(below)))) / 2e-6;
    for (int row = 0; row < 9; ++row) tangent(row, k) = slope(row / 3, row % 3);
  }
  const double volume = sides.prod();
  const auto spring = hex::hourglass_stiffness(m.hourglass * m.mu * volume, 1 / (sides[0] * sides[0]),
                                               1 / (sides[1] * sides[1]), 1 / (sides[2] * sides[2]));
  Eigen::Matrix<double, 9, 24> gradient = Eigen::Matrix<double, 9, 24>::Zero();
  Eigen::Matrix<double, 24, 24> K = Eigen::Matrix<double, 24, 24>::Zero();
  for (int component = 0; component < 3; ++component) {
    Eigen::Matrix<double, 24, 4> patterns = Eigen::Matrix<double, 24, 4>::Zero();
    for (int corner = 0; corner < 8; ++corner) {
      const int at = 3 * corner + component;
      Vector3d s;
      for (int d = 0; d < 3; ++d) {
        s[d] = sign(corner / 2, corner % 2 == 1, d);
        gradient(3 * component + d, at) = s[d] / (4 * sides[d]);
      }
      patterns.row(at) << s[0] * s[1], s[0] * s[2], s[1] * s[2], s.prod();
    }
    K += patterns * Eigen::Vector4d(spring.xy, spring.xz, spring.yz, spring.xyz).asDiagonal() * patterns.transpose();
  }
  K += volume * gradient.transpose() * (tangent + tangent.transpose()) / 2 * gradient;
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 24, 24>>(K).eigenvalues()[23] * 8 / volume;
}

// Without viscosity dt <= 2/omega.
TEST(Brick, TheStepBoundIsNoLongerThanItsStiffnessAllows) {
  States random(4);
  double tightest = 10;
  for (const double alpha : {8.5, 2.0, 13.8, 20.0, -2.0, -6.0})
    for (int k = 0; k < 300; ++k) {
      MaterialConstants m = solid_of(alpha);
      if (k % 2 == 1) m.bulk = 10;  // direction counts for more
      const Matrix3d F = random.of({random.between(0.5, 1.6), random.between(0.5, 1.6), random.between(0.5, 1.6)});
      const Vector3d sides(random.between(0.5, 1.5), random.between(0.5, 1.5), random.between(0.5, 1.5));
      const auto d = hex::deformation_of(tensor(F));
      const auto g = hex::powers_of(d.spectrum, d.mean, alpha);
      const auto tau = hex::isochoric_kirchhoff(d.B, d.B2, d.trace_of_square, d.spectrum, g, 2 * m.mu / alpha);
      const Vector3d per = sides.cwiseInverse().cwiseAbs2();
      const auto bound =
          hex::step_bound(d, tau, scalar::volumetric_stiffness(PressureLaw::log_quadratic, d.jacobian, m.bulk),
                          g.sum() / 3, m.mu, alpha, per[0], per[1], per[2]);
      const double ratio = bound.stiffness / (largest_frequency_squared(F, m, sides) / 4);
      tightest = std::min(tightest, ratio);
      EXPECT_GT(ratio, 1 - 1e-4) << "alpha " << alpha << " K " << m.bulk << " F\n" << F;
    }
  EXPECT_LT(tightest, 1.5);  // it is a bound, not a guess far below
}

}  // namespace
}  // namespace percal
