// What a curve fit makes small: weighted points, and a model's residuals with their derivatives.
// docs/theory/curves.md
#pragma once
#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "percal/fit/points/curve_data.hpp"
#include "percal/material/hyperelastic.hpp"

namespace percal {

// What is squared and summed: (sigma - sigma_hat)/sigma as in Guha 2009, Eq. 3-4, where points of zero stress are left
// out; sigma - sigma_hat in Pa; or (sigma - sigma_hat)/error, where points without an error above zero are left out.
enum class Residual { relative, absolute, error };

// How tests count against each other. A test is what one file says of one deformation; uniaxial tension and compression
// are two tests.
struct EqualPoints {};  // every point counts the same
struct EqualTests {     // every test counts the same, however many points it has; `of_test` are exceptions
  // A word of a deformation, "tension" or "compression", or a file's name without its folder and ending -> share, > 0.
  std::vector<std::pair<std::string, double>> of_test;
};
using Weighting = std::variant<EqualPoints, EqualTests>;

struct CurveTest {
  std::string name;  // "uniaxial tension", "planar"; with the file's name in front where there are several files
  std::string file;
  int source = 0;  // index of the file
  Deformation deformation = Deformation::uniaxial;
  int points = 0;     // used
  double rows = 0;    // that they stand for
  double weight = 1;  // of each point's square: 1 with EqualPoints; the mean over all points is 1
};

// Whether a point belongs to a test, and whether a name of EqualTests means it.
bool belongs(const StressPoint& point, const CurveData& data, const CurveTest& test);
bool is_meant(const std::string& name, const CurveTest& test);

// A residual is weight * (stress - model).
struct WeightedPoint {
  PrincipalPair pair;
  double stress;  // in a scale that makes it about 1
  double
      weight;  // 1 over what the residual is relative to, in the same scale, times the root of the test's weight and of its rows
  int test = 0;  // index of its CurveTest
};

struct CurveProblem {
  std::vector<WeightedPoint> points;
  std::vector<std::size_t> rows = {};  // of each point: its index in CurveData::points
  std::vector<CurveTest> tests;
  double scale = 1;           // Pa: stress of 1 above
  double objective_unit = 1;  // of a sum of squared residuals: scale^2 where they are in Pa
  Residual residual = Residual::relative;
  std::map<Deformation, int> points_of_mode;  // used
  int different = 0;                          // deformed points that differ
  int left_out_zero_stress = 0;               // relative residuals
  int left_out_no_error = 0;                  // error-weighted residuals
};

// Throws BadInput: no stress that differs from zero, no error column where errors are asked for, a weight for a test
// that is not there. An empty set of points has an empty problem.
CurveProblem curve_problem(const CurveData& data, Residual residual, const Weighting& weighting = EqualPoints{});

// Residuals (number of points) and their derivatives with respect to ln mu_1, .., ln mu_K and then, where the model
// leaves them free, alpha_1, .., alpha_K. The solid's moduli are in Pa; the residuals carry no unit, those in Pa are
// over the problem's scale.
struct CurveResiduals {
  Eigen::VectorXd value;
  Eigen::MatrixXd jacobian;
};
CurveResiduals residuals_of(const CurveProblem& problem, Model model, const Hyperelastic& solid);

// n ln(S/n) + 2 k + 2 k (k + 1)/(n - k - 1), k the parameters and the scatter; none with too few points or an exact fit.     (19)
std::optional<double> aicc(double sum_of_squares, std::size_t points, int parameters);

std::string word(Residual residual);  // "relative", "absolute", "error"

}  // namespace percal
