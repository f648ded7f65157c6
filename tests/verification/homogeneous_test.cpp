// Homogeneous states of the compressible solid on distorted meshes: the patch test. Exact but for the 1e-12 that element.hpp
// adds under a root, so 1e-10 of the modulus is asked for.
#include <Eigen/Dense>
#include <functional>

#include "verification/verification.hpp"

namespace percal {
namespace {

using Eigen::Matrix3d;
constexpr double tolerance = 1e-10;
constexpr double exponents[] = {-6, 2, 8.5};

// P = tau F^-T with tau = sum tau_i n_i n_i^T over the principal directions of F F^T, tau_i = lambda_i dW/dlambda_i.
Matrix3d closed_form(const BodySolid& solid, const Matrix3d& F) {
  const Eigen::SelfAdjointEigenSolver<Matrix3d> of(F * F.transpose());
  const double J = F.determinant();
  Eigen::Vector3d power;
  for (int i = 0; i < 3; ++i) power[i] = std::pow(of.eigenvalues()[i] / std::cbrt(J * J), solid.alpha / 2);
  const Eigen::Vector3d tau =
      2 * solid.mu / solid.alpha * (power.array() - power.mean()) + solid.bulk / 2 * (J * J - 1);
  return of.eigenvectors() * tau.asDiagonal() * of.eigenvectors().transpose() * F.inverse().transpose();
}

// F of the half plane's axes (x, y or r, z) and the third direction.
Matrix3d gradient_of(double xx, double xy, double yx, double yy, double third) {
  Matrix3d F;
  F << xx, xy, 0, yx, yy, 0, 0, 0, third;
  return F;
}

// The stretch across that leaves no stress there, between 0.2 and 5.
double root(const std::function<double(double)>& stress) {
  double low = 0.2, high = 5;
  while (high - low > 1e-15 * high && (low + high) / 2 > low && (low + high) / 2 < high)
    (stress((low + high) / 2) < 0 ? low : high) = (low + high) / 2;
  return (low + high) / 2;
}

QuadBlock patch() {
  return distorted(rectangle({.left = 0, .right = 2, .bottom = 0, .top = 3, .across = 5, .along = 6}), 0.13, 11);
}

struct Deviation {
  double stress = 0;  // of any element from the closed form
  double inside = 0;  // force on any node within, over that of a unit stress on an edge
  double outer_side = 0;
};

Deviation deviation(const BodySolid& solid, Geometry geometry, const Matrix3d& F) {
  const QuadBlock block = patch();
  Body body(block.mesh, geometry, solid);
  for (int n = 0; n < body.nodes(); ++n) {
    const Point& at = block.mesh.nodes[n];
    body.set_displacement(n, {(F(0, 0) - 1) * at[0] + F(0, 1) * at[1], F(1, 0) * at[0] + (F(1, 1) - 1) * at[1]});
  }
  body.forces();
  const Matrix3d exact = closed_form(solid, F);
  Deviation found;
  const double size = solid.bulk + exact.cwiseAbs().maxCoeff();
  for (int e = 0; e < body.elements(); ++e) {
    const auto P = body.first_piola(e);
    Matrix3d mine;
    mine << P.rr, P.rz, 0, P.zr, P.zz, 0, 0, 0, P.hoop;
    if (geometry == Geometry::plane_strain) mine(2, 2) = exact(2, 2);  // held in the third direction
    found.stress = std::max(found.stress, (mine - exact).cwiseAbs().maxCoeff() / size);
  }
  for (int j = 1; j < block.along; ++j) {
    for (int i = 1; i < block.across; ++i)
      for (const double f : body.force(block.node(i, j))) found.inside = std::max(found.inside, std::abs(f) / size);
    for (const double f : body.force(block.node(block.across, j)))
      found.outer_side = std::max(found.outer_side, std::abs(f) / size);
  }
  return found;
}

void expect_exact(const std::string& what, const std::string& geometry, double worst) {
  EXPECT_LT(worst, tolerance) << what << ", " << geometry;
  record_bound("Homogeneous states", what + ", " + geometry, "5 x 6, inner nodes moved by up to a quarter of an edge",
               worst, "1e-10");
}

TEST(Homogeneous, UniaxialStretchWithFreeSidesIsExactOnADistortedMesh) {
  double worst = 0;
  for (const double alpha : exponents)
    for (const double lambda : {0.6, 0.95, 1.05, 1.7}) {
      const BodySolid solid{.mu = 1.3, .bulk = 4, .alpha = alpha};
      const double across = root([&](double s) { return closed_form(solid, gradient_of(s, 0, 0, lambda, s))(0, 0); });
      const auto found = deviation(solid, Geometry::axisymmetric, gradient_of(across, 0, 0, lambda, across));
      worst = std::max({worst, found.stress, found.inside, found.outer_side});
    }
  expect_exact("uniaxial stretch 0.6 to 1.7, alpha -6, 2, 8.5", "axisymmetric", worst);
}

TEST(Homogeneous, EquibiaxialStretchIsExactOnADistortedMesh) {
  double worst = 0;
  for (const double alpha : exponents)
    for (const double lambda : {0.7, 1.4}) {
      const BodySolid solid{.mu = 1.3, .bulk = 4, .alpha = alpha};
      const double along =
          root([&](double s) { return closed_form(solid, gradient_of(lambda, 0, 0, s, lambda))(1, 1); });
      const auto found = deviation(solid, Geometry::axisymmetric, gradient_of(lambda, 0, 0, along, lambda));
      worst = std::max({worst, found.stress, found.inside});
    }
  expect_exact("equibiaxial stretch 0.7 and 1.4", "axisymmetric", worst);
}

TEST(Homogeneous, DilatationIsExactOnADistortedMesh) {
  double worst = 0;
  for (const double lambda : {0.8, 1.3}) {
    const BodySolid solid{.mu = 1.3, .bulk = 4, .alpha = 8.5};
    const auto found = deviation(solid, Geometry::axisymmetric, lambda * Matrix3d::Identity());
    worst = std::max({worst, found.stress, found.inside});
  }
  expect_exact("equal stretches 0.8 and 1.3", "axisymmetric", worst);
}

TEST(Homogeneous, SimpleShearIsExactOnADistortedMesh) {
  double worst = 0;
  for (const double alpha : exponents)
    for (const double gamma : {-0.5, 1.2}) {
      const BodySolid solid{.mu = 1.3, .bulk = 4, .alpha = alpha};
      const auto found = deviation(solid, Geometry::plane_strain, gradient_of(1, gamma, 0, 1, 1));
      worst = std::max({worst, found.stress, found.inside});
    }
  expect_exact("simple shear -0.5 and 1.2", "plane strain", worst);
}

TEST(Homogeneous, AnyLinearFieldIsExactOnADistortedMesh) {
  double worst = 0;
  for (const double alpha : exponents) {
    const BodySolid solid{.mu = 1.3, .bulk = 65, .alpha = alpha};
    const auto found = deviation(solid, Geometry::plane_strain, gradient_of(0.3, -1.1, 0.9, 0.4, 1));
    worst = std::max({worst, found.stress, found.inside});
  }
  expect_exact("stretch, shear and rotation at once", "plane strain", worst);
}

// A ball swollen evenly by lambda carries sigma = K/2 (J^2 - 1)/J everywhere: a pressure of -sigma on its surface, where that is now,
// leaves no force on any node.
TEST(Homogeneous, APressureBalancesADilatationAtEveryNodeOfItsSurface) {
  double worst = 0;
  for (const Geometry geometry : {Geometry::axisymmetric, Geometry::plane_strain})
    for (const double lambda : {0.8, 1.3}) {
      const bool ball = geometry == Geometry::axisymmetric;
      Disc made = ball ? half_disc(5) : disc(5);
      if (!ball) made.boundary.push_back(made.boundary.front());
      const BodySolid solid{.mu = 1.3, .bulk = 4, .alpha = 8.5};
      PressedBody body(made.mesh, geometry, solid);
      const Matrix3d F = gradient_of(lambda, 0, 0, lambda, ball ? lambda : 1);
      const double sigma = (closed_form(solid, F) * F.transpose())(0, 0) / F.determinant();
      body.press(made.boundary, -sigma);
      for (int n = 0; n < body.nodes(); ++n) {
        const Point& at = made.mesh.nodes[n];
        body.set_displacement(n, {(lambda - 1) * at[0], (lambda - 1) * at[1]});
      }
      body.forces();
      for (int n = 0; n < body.nodes(); ++n)
        for (int d = 0; d < 2; ++d)
          if (!body.held(n, d)) worst = std::max(worst, std::abs(body.force(n)[d]) / solid.bulk);
    }
  EXPECT_LT(worst, tolerance);
  record_bound("Homogeneous states",
               "a ball and a disc swollen by 0.8 and 1.3, pressed by their own stress: force on any node",
               "5 elements per radius", worst, "1e-10");
}

// The same states against the incompressible closed forms: they are approached as 1/K.
TEST(Homogeneous, TheIncompressibleStressIsApproachedAsOneOverK) {
  const CsvTable table = exact_table("ogden_homogeneous_stress.csv");
  std::vector<double> per_bulk, errors;
  for (const auto& row : table.rows) {
    if (std::stod(table.cell(row, 0)) != 3 || std::stod(table.cell(row, 1)) != 1.5) continue;
    const double exact = std::stod(table.cell(row, table.column("P_UT")));
    for (const double bulk : {50.0, 200.0, 1000.0, 5000.0}) {
      const BodySolid solid{.mu = 1, .bulk = bulk, .alpha = 3};
      const double across = root([&](double s) { return closed_form(solid, gradient_of(s, 0, 0, 1.5, s))(0, 0); });
      const QuadBlock block = patch();
      Body body(block.mesh, Geometry::axisymmetric, solid);
      for (int n = 0; n < body.nodes(); ++n)
        body.set_displacement(n, {(across - 1) * block.mesh.nodes[n][0], 0.5 * block.mesh.nodes[n][1]});
      body.forces();
      double force = 0;
      for (const int n : block.last) force -= body.force(n)[1];
      const double found = force / 2;  // the end's area is 2 a radian
      record({"Homogeneous states", fmt::format("nominal stress, uniaxial stretch 1.5, alpha 3, K/mu {}", bulk),
              "ogden_homogeneous_stress.csv", "5 x 6 distorted", found, exact});
      per_bulk.push_back(1 / bulk);
      errors.push_back(std::abs(found / exact - 1));
    }
  }
  ASSERT_EQ(errors.size(), 4u);
  EXPECT_NEAR(slope(per_bulk, errors), 1, 0.05);
}

}  // namespace
}  // namespace percal
