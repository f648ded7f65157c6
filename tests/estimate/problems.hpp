// Calibration problems with known answers.
#pragma once
#include <fmt/core.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "percal/estimate/least_squares.hpp"
#include "percal/math/draws.hpp"

namespace percal {

inline const SearchOptions quick{.global_evaluations = 500, .starts = 4};

// Value and derivatives of one datum's model at a searched point.
struct ValueAndGradient {
  double value;
  Eigen::VectorXd gradient;
};
using OneDatumModel = std::function<ValueAndGradient(const Eigen::VectorXd& searched, int datum)>;

inline CalibrationModel model_of(int data, const OneDatumModel& one) {
  return [data, one](const Eigen::VectorXd& searched, Want) {
    ModelAnswer answer{Eigen::VectorXd(data), Eigen::MatrixXd(data, searched.size()), {}};
    for (int i = 0; i < data; ++i) {
      const auto [value, gradient] = one(searched, i);
      answer.value[i] = value;
      answer.jacobian.row(i) = gradient.transpose();
    }
    return answer;
  };
}

inline FreeParameter linear_parameter(const std::string& name, double low, double high) {
  return {.name = name, .unit = "", .low = low, .high = high, .logarithmic = false};
}
inline FreeParameter positive_parameter(const std::string& name, double low, double high) {
  return {.name = name, .unit = "", .low = low, .high = high, .logarithmic = true};
}

// y = a + b x at x = 0, 0.5, 1, ..., with normal noise.
inline double line_x(int i) { return 0.5 * i; }
inline CalibrationProblem line_problem(int data, double a, double b, double noise, unsigned seed) {
  CalibrationProblem problem;
  problem.parameters = {linear_parameter("a", -20, 20), linear_parameter("b", -20, 20)};
  problem.groups = {{.name = "line"}};
  Draws draws(seed);
  for (int i = 0; i < data; ++i)
    problem.data.push_back({.label = fmt::format("y{}", i), .value = a + b * line_x(i) + noise * draws.normal()});
  problem.model = model_of(data, [](const Eigen::VectorXd& at, int i) {
    return ValueAndGradient{at[0] + at[1] * line_x(i), Eigen::Vector2d(1, line_x(i))};
  });
  return problem;
}

// A curve like a stiffening solid's: y = m (exp(k x) - 1), x from 0.05 to 1; ln m and k are searched.
inline double curve_x(int i, int data) { return (i + 1.0) / data; }
inline CalibrationProblem curve_problem(int data, double m, double k, double noise, unsigned seed) {
  CalibrationProblem problem;
  problem.parameters = {positive_parameter("m", 1e-2, 1e2), linear_parameter("k", 0.1, 10)};
  problem.groups = {{.name = "curve"}};
  Draws draws(seed);
  for (int i = 0; i < data; ++i)
    problem.data.push_back(
        {.label = fmt::format("p{}", i), .value = m * std::expm1(k * curve_x(i, data)) + noise * draws.normal()});
  problem.model = model_of(data, [data](const Eigen::VectorXd& at, int i) {
    const double x = curve_x(i, data), m_here = std::exp(at[0]), rise = std::expm1(at[1] * x);
    return ValueAndGradient{m_here * rise, Eigen::Vector2d(m_here * rise, m_here * x * (rise + 1))};
  });
  return problem;
}

}  // namespace percal
