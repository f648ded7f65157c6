// Curves of a known Ogden solid with known noise, for tests of the statistics.
#pragma once
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "percal/fit/points/curve_data.hpp"

namespace percal::test {

inline constexpr Ogden gel{.mu = 11640, .alpha = 9};

// Standard normal numbers, the same with every standard library (Box and Muller).
class NormalNumbers {
 public:
  explicit NormalNumbers(unsigned seed) : engine_(seed) {}
  double operator()() {
    const double radius = std::sqrt(-2 * std::log(1 - uniform()));
    return radius * std::cos(2 * std::numbers::pi * uniform());
  }

 private:
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  std::mt19937_64 engine_;
};

// Standard deviation sqrt((relative true stress)^2 + absolute^2).
struct Noise {
  double relative = 0;
  double absolute = 0;  // Pa

  double at(double stress) const { return std::hypot(relative * stress, absolute); }
};

// Equal steps of stretch from low to high; the undeformed state, should it be among them, is left out.
struct Stretches {
  Deformation deformation = Deformation::uniaxial;
  int points = 26;
  double low = 0.65, high = 1.3;
};

inline std::vector<Strained> states(const Stretches& stretches) {
  std::vector<Strained> all;
  for (int k = 0; k < stretches.points; ++k) {
    const double stretch = stretches.low + k * (stretches.high - stretches.low) / (stretches.points - 1);
    if (std::abs(stretch - 1) > 1e-9) all.push_back({stretches.deformation, stretch});
  }
  return all;
}

inline CurveData noisy_curve(const Ogden& solid, const std::vector<Strained>& states, const Noise& noise,
                             NormalNumbers& normal) {
  CurveData data;
  for (const auto& strained : states) {
    const double stress = nominal_stress(solid, strained);
    StressPoint point{};
    point.strained = strained;
    point.nominal_stress = stress + noise.at(stress) * normal();
    data.points.push_back(point);
  }
  return data;
}

}  // namespace percal::test
