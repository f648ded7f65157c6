// What the verification tests share: the table they write, exact values from data/verification, a march in double precision.
#pragma once
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "mesh/quad_blocks.hpp"
#include "percal/text/csv.hpp"
#include "verification/pressed_body.hpp"

namespace percal {

// A line of docs/verification/closed_forms.md.
struct Finding {
  std::string section, check, reference, mesh;
  double found = 0, exact = 0;
  double error() const { return found / exact - 1; }
};

// Appends a line to the file that PERCAL_TABLE names (docs/verification/make_closed_forms.py reads it); without it, nothing.
inline void record_line(const std::string& section, const std::string& check, const std::string& reference,
                        const std::string& mesh, const std::string& found, const std::string& exact,
                        const std::string& error) {
  const char* path = std::getenv("PERCAL_TABLE");
  if (!path) return;
  std::ofstream(path, std::ios::app) << fmt::format("{}\t{}\t{}\t{}\t{}\t{}\t{}\n", section, check, reference, mesh,
                                                    found, exact, error);
}

// Returns the relative error, signed.
inline double record(const Finding& f) {
  record_line(f.section, f.check, f.reference, f.mesh, fmt::format("{:.6g}", f.found), fmt::format("{:.6g}", f.exact),
              fmt::format("{:+.2g} %", 100 * f.error()));
  return f.error();
}

// For what should be zero, or a slope: the bound that the test holds instead of an exact value.
inline void record_bound(const std::string& section, const std::string& check, const std::string& mesh, double found,
                         const std::string& bound) {
  record_line(section, check, "", mesh, fmt::format("{:.3g}", found), bound, "");
}

inline CsvTable exact_table(const std::string& name) {
  return read_csv(std::string(PERCAL_DATA) + "/verification/" + name);
}

// A value of linear_and_wave_exact.csv; `inputs` is how its row's inputs begin.
inline double linear_exact(const std::string& problem, const std::string& inputs, const std::string& quantity) {
  const CsvTable table = exact_table("linear_and_wave_exact.csv");
  std::string stated;
  for (const auto& row : table.rows) {
    const auto cells = table.cells(row);
    if (!cells[1].starts_with("same")) stated = cells[1];
    const std::string& here = cells[1].starts_with(inputs) ? cells[1] : stated;
    if (cells[0] == problem && here.starts_with(inputs) && cells[2].starts_with(quantity)) return std::stod(cells[3]);
  }
  ADD_FAILURE() << "no exact value of " << problem << ", " << inputs << ", " << quantity;
  return NAN;
}

// Moves the nodes that lie on no side by up to `amount` (a length) in each direction.
inline QuadBlock distorted(QuadBlock block, double amount, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-amount, amount);
  for (int j = 1; j < block.along; ++j)
    for (int i = 1; i < block.across; ++i)
      for (double& x : block.mesh.nodes[block.node(i, j)]) x += uniform(random);
  return block;
}

// One step of length dt from a state whose velocities, displacements and forces belong to one time, to the next such state.
template <class AnyBody, class AddContact>
void advance(AnyBody& body, double dt, AddContact&& add_contact) {
  body.step(dt / 2, dt);
  body.forces();
  add_contact();
  body.step(dt / 2, 0);
}
template <class AnyBody>
void advance(AnyBody& body, double dt) {
  advance(body, dt, [] {});
}

// The times at which a series, sampled at equal steps from time 0, passes a level; between samples on a straight line.
inline std::vector<double> crossings(const std::vector<double>& series, double step, double level) {
  std::vector<double> times;
  for (std::size_t i = 1; i < series.size(); ++i) {
    const double a = series[i - 1] - level, b = series[i] - level;
    if ((a < 0) != (b < 0)) times.push_back(step * (static_cast<double>(i) - b / (b - a)));
  }
  return times;
}

// The exponent p of error = c h^p, least squares over the logarithms.
inline double slope(const std::vector<double>& h, const std::vector<double>& error) {
  const double n = static_cast<double>(h.size());
  double x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t i = 0; i < h.size(); ++i) {
    const double a = std::log(h[i]), b = std::log(error[i]);
    x += a, y += b, xx += a * a, xy += a * b;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

}  // namespace percal
