// Our uniaxial decks in CalculiX, against the closed form. Without ccx these tests are skipped.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "card/card_test.hpp"
#include "percal/card/solver.hpp"
#include "support/temporary_folder.hpp"

namespace percal {
namespace {

// One increment of a run: CalculiX prints seven digits.
struct Measured {
  double stretch, nominal_stress;  // Pa
};

bool have_ccx() { return std::system("command -v ccx > /dev/null 2>&1") == 0; }

// What the deck says of its cube: "..., over 100 mm^2; stretch = ...".
double area_of(const std::string& deck) {
  std::string flat;
  for (const std::string& line : card_test::lines_of(deck)) flat += line.substr(0, 2) == "**" ? line.substr(2) : "";
  const std::size_t at = flat.find(", over ");
  return at == std::string::npos ? 0 : std::stod(flat.substr(at + 7));
}

// Blocks "total force (fx,fy,fz) for set X1 and time T", an empty line, the force; then "displacements ..." with a line
// for each node.
std::vector<Measured> read_dat(const std::string& file, double area, double stress_unit) {
  std::ifstream stream(file);
  std::vector<Measured> increments;
  double force = 0;
  for (std::string line; std::getline(stream, line);) {
    const bool is_force = line.find("total force") != std::string::npos;
    if (!is_force && line.find("displacements") == std::string::npos) continue;
    std::string numbers;
    while (std::getline(stream, numbers) && numbers.empty()) {
    }
    std::istringstream fields(numbers);
    if (is_force) {
      fields >> force;
    } else {
      int node = 0;
      double displacement = 0;
      fields >> node >> displacement;
      increments.push_back({1 + displacement / std::sqrt(area), force / area * stress_unit});
    }
  }
  return increments;
}

// The deck as the library writes it, run by ccx on one thread; empty where ccx did not come to the end.
std::vector<Measured> run_ccx(const CardMaterial& material, double stretch, int increments = 20) {
  const UnitSystem units = unit_system("mm-t-s-MPa");
  const test::TemporaryFolder folder;
  const auto deck = uniaxial_deck(solver_named("calculix"), material, units, {stretch, increments}, "cube").front();
  std::ofstream(folder.path(deck.name)) << deck.text;
  const std::string command = "cd " + folder.path("") + " && OMP_NUM_THREADS=1 ccx cube > cube.log 2>&1";
  if (std::system(command.c_str()) != 0) return {};
  auto measured = read_dat(folder.path("cube.dat"), area_of(deck.text), units.stress);
  if (static_cast<int>(measured.size()) != increments) return {};
  return measured;
}

CardMaterial solid(double mu, double alpha, double bulk_to_shear) {
  return {.name = "cube", .density = 1000, .terms = {{mu, alpha}}, .bulk_modulus = bulk_to_shear * mu};
}

double incompressible(double mu, double alpha, double stretch) {
  return 2 * mu / alpha * (std::pow(stretch, alpha - 1) - std::pow(stretch, -alpha / 2 - 1));
}

// The compressible closed form: side stretch t by Newton on dW/dt = 0 with numerical derivatives, then dW/dlambda.
double compressible(double alpha, double bulk, double stretch) {  // mu = 1
  const auto slope_along = [&](double along, double side) {       // dW/d(along), times along
    const double root = std::cbrt(along * side * side), J = along * side * side;
    return 4 / (3 * alpha) * (std::pow(along / root, alpha) - std::pow(side / root, alpha)) + bulk * J * (J - 1);
  };
  const auto slope_aside = [&](double side) {  // dW/dt over 2, times t
    const double J = stretch * side * side, root = std::cbrt(J);
    return 2 / (3 * alpha) * (std::pow(side / root, alpha) - std::pow(stretch / root, alpha)) + bulk * J * (J - 1);
  };
  double side = 1 / std::sqrt(stretch);
  for (int i = 0; i < 100; ++i) {
    const double step = 1e-6;
    const double slope = (slope_aside(side + step) - slope_aside(side - step)) / (2 * step);
    side -= slope_aside(side) / slope;
  }
  return slope_along(stretch, side) / stretch;
}

struct Worst {
  double difference = 0;
  std::string where;
  void take(const Measured& measured, double expected, double alpha, double mu) {
    const double relative = std::abs(measured.nominal_stress / expected - 1);
    if (!(relative <= difference)) {  // NaN too
      difference = relative;
      where = "alpha " + std::to_string(alpha) + ", mu " + std::to_string(mu) + ", stretch " +
              std::to_string(measured.stretch);
    }
  }
};

TEST(Calculix, AgreesWithTheClosedFormAtOnePoint) {
  if (!have_ccx()) GTEST_SKIP() << "ccx (Debian: calculix-ccx) is not installed";
  const auto measured = run_ccx(solid(2e6, -3, 1e6), 1.4, 4);
  ASSERT_EQ(measured.size(), 4U);
  EXPECT_NEAR(measured.back().stretch, 1.4, 1e-6);
  const double expected = incompressible(2e6, -3, 1.4);
  EXPECT_NEAR(measured.back().nominal_stress, expected, 1e-3 * expected);
}

// CalculiX puts a number of its own in the place of a D2 of 0, which at this modulus is 2 % of the force and more.
TEST(Calculix, AgreesWithTheClosedFormOfTwoTerms) {
  if (!have_ccx()) GTEST_SKIP() << "ccx (Debian: calculix-ccx) is not installed";
  CardMaterial material = solid(2e9, 4, 1e6);
  material.terms.push_back({1e9, -3});
  const auto measured = run_ccx(material, 1.5, 4);
  ASSERT_EQ(measured.size(), 4U);
  const double expected = incompressible(2e9, 4, 1.5) + incompressible(1e9, -3, 1.5);
  EXPECT_NEAR(measured.back().nominal_stress, expected, 1e-3 * expected);
}

// |alpha| up to 9 of both signs, 1 kPa to 100 MPa, D1 = 2e-6/mu, every increment on the way to 0.5 and to 2.
TEST(SlowCalculix, AgreesWithTheIncompressibleClosedForm) {
  if (!have_ccx()) GTEST_SKIP() << "ccx (Debian: calculix-ccx) is not installed";
  Worst worst;
  for (const double alpha : {-9.0, -5.0, -2.0, -0.5, 0.5, 2.0, 5.0, 9.0}) {
    for (const double mu : {1e3, 1e5, 15e6, 100e6}) {
      for (const double stretch : {0.5, 2.0}) {
        const auto measured = run_ccx(solid(mu, alpha, 1e6), stretch);
        ASSERT_EQ(measured.size(), 20U) << "ccx did not finish: " << alpha << " " << mu << " " << stretch;
        EXPECT_NEAR(measured.back().stretch, stretch, 1e-6);
        for (const Measured& one : measured) worst.take(one, incompressible(mu, alpha, one.stretch), alpha, mu);
      }
    }
  }
  EXPECT_LT(worst.difference, 1e-3) << worst.where;
}

TEST(SlowCalculix, AgreesWithTheCompressibleClosedForm) {
  if (!have_ccx()) GTEST_SKIP() << "ccx (Debian: calculix-ccx) is not installed";
  Worst worst;
  for (const double alpha : {-9.0, -2.0, 2.0, 9.0}) {
    for (const double stretch : {0.5, 2.0}) {
      const double mu = 3e6;
      const auto measured = run_ccx(solid(mu, alpha, 50), stretch);
      ASSERT_EQ(measured.size(), 20U) << "ccx did not finish: " << alpha << " " << stretch;
      for (const Measured& one : measured) worst.take(one, mu * compressible(alpha, 50, one.stretch), alpha, mu);
    }
  }
  EXPECT_LT(worst.difference, 1e-4) << worst.where;
}

}  // namespace
}  // namespace percal
