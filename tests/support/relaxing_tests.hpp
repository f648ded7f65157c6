// Ramps and holds of a known solid that relaxes, with known noise.
#pragma once
#include <cmath>
#include <vector>

#include "percal/fit/relaxation/relaxing_curves.hpp"
#include "support/synthetic_curves.hpp"

namespace percal::test {

// Two terms that three rates tell: one that the slow ramp misses, one that the hold shows.
inline const RelaxingSolid relaxing_gel{{{{.mu = 20e3, .alpha = 5}}}, {{{0.4, 0.5}, {0.25, 20}}}};

// A ramp at a constant rate of stretch from rest, then a hold whose rows lie ever further apart.
struct RampAndHold {
  double rate = 0.1;  // 1/s
  double stretch = 0.7;
  double hold = 100;  // s
  int ramp_rows = 20, hold_rows = 30;
  Deformation deformation = Deformation::uniaxial;
};

inline void add_test(CurveData& data, const RampAndHold& test) {
  const double rest = test.deformation == Deformation::simple_shear ? 0 : 1;
  const double ramp = std::abs(test.stretch - rest) / test.rate;
  const auto add = [&](double amount, double time) {
    data.points.push_back({.strained = {test.deformation, amount}, .nominal_stress = 0, .time = time});
  };
  for (int k = 0; k <= test.ramp_rows; ++k) {
    const double share = static_cast<double>(k) / test.ramp_rows;
    add(rest + share * (test.stretch - rest), share * ramp);
  }
  const double first = 0.01 * test.hold;
  for (int k = 0; k < test.hold_rows; ++k)
    add(test.stretch, ramp + first * std::pow(test.hold / first, static_cast<double>(k) / (test.hold_rows - 1)));
}

// The stresses of the solid at every row; a relative standard deviation of noise.
inline void fill_stresses(CurveData& data, const RelaxingSolid& solid, double noise, NormalNumbers& normal) {
  const Eigen::VectorXd stress = relaxing_stress(relaxing_rows(data, histories_of(data)), solid);
  for (std::size_t i = 0; i < data.points.size(); ++i)
    data.points[i].nominal_stress = stress[static_cast<Eigen::Index>(i)] * (1 + noise * normal());
}

inline CurveData three_rates(const RelaxingSolid& solid, double noise, NormalNumbers& normal) {
  CurveData data;
  for (const double rate : {1.0, 0.1, 0.01}) add_test(data, {.rate = rate});
  fill_stresses(data, solid, noise, normal);
  return data;
}

}  // namespace percal::test
