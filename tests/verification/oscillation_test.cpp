// Thick shells that a pressure, put on at once, sets swinging: the period against Knowles' and Guo and Solecki's solution.
#include "verification/shells.hpp"

namespace percal {
namespace {

struct Swing {
  double period, largest_stretch, closure;
};

// The inner radius passes the middle of its way upwards, downwards, upwards: the first and the third are a period apart.
Swing swing(Shell shell, const ShellMesh& mesh, const BodySolid& solid, double pressure, double middle, double time) {
  ShellBody shell_body(shell, mesh, solid);
  PressedBody& body = shell_body.body;
  shell_body.press(pressure, 0);
  body.forces();
  std::vector<double> stretch;
  Swing found{0, 1, 0};
  double worst_balance = 0, most_work = 0;
  const double dt = 0.5 * body.stable_step();
  for (double at = 0; at < time; at += dt) {
    stretch.push_back(shell_body.inner_stretch());
    found.largest_stretch = std::max(found.largest_stretch, stretch.back());
    advance(body, dt);
    worst_balance = std::max(worst_balance, std::abs(body.balance()));
    most_work = std::max(most_work, body.pressure_work());
  }
  found.closure = worst_balance / most_work;
  const auto times = crossings(stretch, dt, middle);
  EXPECT_GE(times.size(), 3u);
  found.period = times.at(2) - times.at(0);
  return found;
}

void meets_the_table(Shell shell, double alpha, double pressure, const ShellMesh& mesh) {
  const CsvTable table = exact_table("shell_radial_oscillation.csv");
  bool met = false;
  for (const auto& row : table.rows) {
    if (table.cell(row, 0) != (is_sphere(shell) ? "sphere" : "cylinder") || table.cell(row, 2) != "2.0") continue;
    if (std::stod(table.cell(row, 1)) != alpha || std::stod(table.cell(row, 3)) != pressure) continue;
    met = true;
    const double middle = std::stod(table.cell(row, 4)), top = std::stod(table.cell(row, 5)),
                 period = std::stod(table.cell(row, 6));
    double before = 10;
    for (const double bulk : {50.0, 200.0, 1000.0}) {
      const Swing found = swing(shell, mesh, {.mu = 1, .bulk = bulk, .alpha = alpha}, pressure, middle, 1.4 * period);
      const auto line = [&](const char* what, double value, double exact) {
        return record(
            {"Radial oscillation",
             fmt::format("{}, alpha {}, step pressure {} mu, K/mu {}: {}", name_of(shell), alpha, pressure, bulk, what),
             "shell_radial_oscillation.csv", mesh.text(), value, exact});
      };
      const double error = std::abs(line("period", found.period, period));
      const double stretch_error = std::abs(line("largest inner stretch", found.largest_stretch, top));
      EXPECT_LT(error, before);
      EXPECT_LT(found.closure, 0.01) << "energy";
      before = error;
      if (bulk < 1000) continue;
      EXPECT_LT(error, 0.01);
      EXPECT_LT(stretch_error, 0.01);
    }
  }
  EXPECT_TRUE(met);
}

TEST(Oscillation, AThickSphereSwingsWithThePeriodOfTheClosedForm) {
  meets_the_table(Shell::sphere, 3, 0.3, {.across = 12, .along = 8});
  meets_the_table(Shell::sphere, 6, 0.5, {.across = 12, .along = 8});
}

TEST(Oscillation, ATubeSwingsWithThePeriodOfTheClosedForm) {
  meets_the_table(Shell::tube_in_the_plane, 3, 0.3, {.across = 12, .along = 8});
  meets_the_table(Shell::tube_in_the_half_plane, 3, 0.3, {.across = 12});
}

}  // namespace
}  // namespace percal
