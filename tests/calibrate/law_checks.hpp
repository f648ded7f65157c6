// What tests of a material's laws check of a job's model and of a job's file.
#pragma once
#include <gtest/gtest.h>

#include <string>

#include "percal/base/error.hpp"
#include "percal/calibrate/job.hpp"
#include "percal/estimate/least_squares.hpp"

namespace percal::test {

// The Jacobian of an answer beside differences of its values at this point.
template <class Values>
void expect_derivatives(const Values& values, const Eigen::VectorXd& at) {
  const ModelAnswer here = values(at);
  for (Eigen::Index k = 0; k < at.size(); ++k) {
    const Eigen::VectorXd step = 1e-5 * Eigen::VectorXd::Unit(at.size(), k);
    const Eigen::VectorXd slope = (values(at + step).value - values(at - step).value) / 2e-5;
    EXPECT_LT((slope - here.jacobian.col(k)).cwiseAbs().maxCoeff(), 1e-5 * (1 + slope.cwiseAbs().maxCoeff())) << k;
  }
}

// A job of one tension curve of a gel, with lines of its own in the parameters, the material and the curve.
inline std::string job_of_a_curve(const std::string& parameters, const std::string& material,
                                  const std::string& curve) {
  return R"(
[parameters.mu]
kind = "modulus"
low = "50 kPa"
high = "900 kPa"
)" + parameters +
         R"(
[materials.gel]
density = "1010 kg/m3"
mu = "mu"
alpha = 8
erosion_strain = 0.8
)" + material +
         R"(
[[curves]]
name = "tension"
material = "gel"
file = "curve.csv"
mode = "uniaxial"
)" + curve;
}

// What a job's reader says against a file; "read" where it says nothing.
inline std::string said_of_job(const std::string& file) {
  try {
    read_calibration_job(file);
  } catch (const BadInput& error) {
    return error.what();
  }
  return "read";
}

}  // namespace percal::test
