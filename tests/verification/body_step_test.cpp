// The stable step of a Body against the eigenvalues of its own forces, differenced.
#include <Eigen/Eigenvalues>

#include "verification/verification.hpp"

namespace percal {
namespace {

// The largest eigenvalue of M^-1 K over the free displacements, K = -df/du by central differences.
double largest_square_frequency(Body& body, const std::vector<Point>& u) {
  std::vector<std::array<int, 2>> free;
  for (int n = 0; n < body.nodes(); ++n)
    for (int d = 0; d < 2; ++d)
      if (!body.held(n, d)) free.push_back({n, d});
  const auto size = static_cast<Eigen::Index>(free.size());
  Eigen::MatrixXd K(size, size);
  const auto forces_at = [&](int k, double by) {
    Point moved = u[free[k][0]];
    moved[free[k][1]] += by;
    body.set_displacement(free[k][0], moved);
    body.forces();
    body.set_displacement(free[k][0], u[free[k][0]]);
    Eigen::VectorXd f(size);
    for (Eigen::Index i = 0; i < size; ++i) f[i] = body.force(free[i][0])[free[i][1]];
    return f;
  };
  const double by = 1e-6;
  for (int k = 0; k < size; ++k) K.col(k) = (forces_at(k, -by) - forces_at(k, by)) / (2 * by);
  for (Eigen::Index i = 0; i < size; ++i)
    for (Eigen::Index j = 0; j < size; ++j) K(i, j) /= std::sqrt(body.mass(free[i][0]) * body.mass(free[j][0]));
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>((K + K.transpose()) / 2, Eigen::EigenvaluesOnly)
      .eigenvalues()
      .maxCoeff();
}

struct Ratios {
  double longest = 0, shortest = 10;  // of the step to 2/omega
};

// Random convex quads, on the axis, near it or away from it, deformed at random.
Ratios random_elements(Geometry geometry, double alpha, double bulk, unsigned seed, int count) {
  std::mt19937 random(seed);
  const auto between = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
  Ratios ratios;
  for (int done = 0; done < count;) {
    const double aspect = std::exp(between(-1.5, 1.5));
    const int where = static_cast<int>(between(0, 3));
    const double left = where == 0 ? 0 : where == 1 ? between(0, 2) : 50;
    QuadMesh mesh{{}, {{0, 1, 2, 3}}};
    for (int a = 0; a < 4; ++a)
      mesh.nodes.push_back(
          {left + aspect * ((a == 1 || a == 2) + (where > 0 || a == 1 || a == 2 ? between(0, 0.4) : 0)),
           (a >= 2) + between(-0.3, 0.3)});
    if (worst_corner(mesh) < 0.2) continue;
    Body body(mesh, geometry, {.mu = 1, .bulk = bulk, .alpha = alpha});
    std::vector<Point> u(4);
    const double stretch = between(0.5, 1.6), amount = between(0, 0.4);
    for (int a = 0; a < 4; ++a) {
      u[a] = {mesh.nodes[a][0] * (stretch - 1) + amount * aspect * between(-1, 1),
              mesh.nodes[a][1] * (1 / (stretch * stretch) - 1) + amount * between(-1, 1)};
      if (body.held(a, 0)) u[a][0] = 0;
      body.set_displacement(a, u[a]);
    }
    const double J = body.smallest_jacobian();
    const auto F = body.gradient(0);
    const auto s = scalar::stretches(F);
    if (J < 0.5 || J > 1.5 || s.first2 > 4 || s.second2 < 0.1 || F.hoop < 0.3) continue;
    const double ratio = body.stable_step() * std::sqrt(largest_square_frequency(body, u)) / 2;
    ratios.longest = std::max(ratios.longest, ratio);
    ratios.shortest = std::min(ratios.shortest, ratio);
    ++done;
  }
  return ratios;
}

TEST(BodyStep, IsNeverLongerThanTheLimitOfARandomElementNorMuchShorter) {
  for (const Geometry geometry : {Geometry::axisymmetric, Geometry::plane_strain})
    for (const double bulk : {2.0, 50.0}) {
      Ratios all;
      for (const double alpha : {-20.0, -5.0, 2.0, 8.5, 20.0}) {
        const Ratios ratios = random_elements(geometry, alpha, bulk, 5, 1000);
        EXPECT_LE(ratios.longest, 1 + 1e-6) << "alpha " << alpha << ", K/mu " << bulk;
        all.longest = std::max(all.longest, ratios.longest);
        all.shortest = std::min(all.shortest, ratios.shortest);
      }
      EXPECT_GT(all.shortest, 0.75) << "K/mu " << bulk;
      const std::string name = geometry == Geometry::axisymmetric ? "axisymmetric" : "plane strain";
      const std::string check = fmt::format("stable step over 2/omega, {}, K/mu {}, alpha -20 to 20", name, bulk);
      record_bound("Stable step", check + ": longest", "5000 random elements", all.longest, "at most 1");
      record_bound("Stable step", check + ": shortest", "5000 random elements", all.shortest, "");
    }
}

TEST(BodyStep, IsNeverLongerThanTheLimitOfAMesh) {
  const Disc made = half_disc(6);
  Body body(made.mesh, Geometry::axisymmetric, {.mu = 1, .bulk = 3, .alpha = 2});
  const double ratio =
      body.stable_step() * std::sqrt(largest_square_frequency(body, std::vector<Point>(body.nodes()))) / 2;
  EXPECT_LE(ratio, 1 + 1e-6);
  EXPECT_GT(ratio, 0.75);
  record_bound("Stable step", "stable step over 2/omega of a half disc at rest, K/mu 3", "6 elements per radius", ratio,
               "at most 1");
}

// With this much viscosity the step that elasticity alone allows is twice too long.
TEST(BodyStep, LeavesRoomForViscosity) {
  const QuadBlock block = rectangle({.across = 4, .along = 4});
  const BodySolid elastic{.mu = 1, .bulk = 50, .alpha = 2};
  BodySolid viscous = elastic;
  viscous.linear_viscosity = 1;
  const double elastic_step = Body(block.mesh, Geometry::plane_strain, elastic).stable_step();
  for (const bool own_step : {true, false}) {
    Body body(block.mesh, Geometry::plane_strain, viscous);
    std::mt19937 random(3);
    for (int n = 0; n < body.nodes(); ++n)
      body.set_velocity(n, {std::uniform_real_distribution<double>(-1e-4, 1e-4)(random), 0});
    body.forces();
    const double dt = own_step ? body.stable_step() : elastic_step, start = body.energy().kinetic;
    for (int k = 0; k < 100; ++k) advance(body, dt);
    if (own_step)
      EXPECT_LT(body.energy().kinetic, start);
    else
      EXPECT_FALSE(body.energy().kinetic < 10 * start);
  }
}

TEST(BodyStep, RefusesAnElementThatIsNotConvex) {
  const QuadMesh bow{{{0, 0}, {1, 0}, {0, 1}, {1, 1}}, {{0, 1, 2, 3}}};
  EXPECT_THROW(Body(bow, Geometry::plane_strain, {}), std::runtime_error);
}

}  // namespace
}  // namespace percal
