// The value that a series of meshes converges to, and how far each mesh is from it, where the values are noisy.
// L. Eca, M. Hoekstra: A procedure for the estimation of the numerical uncertainty of CFD calculations based on grid
// refinement studies. J. Comput. Phys. 262 (2014) 104-130. Formulas: docs/theory/errors.md.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace percal {

// A value computed on a mesh whose elements have the size h (any unit, the same for all points).
struct GridPoint {
  double h = 0;
  double value = 0;
  double standard_error = 0;  // of the value, where it is a mean of replicates; 0: not known
};

// How the error goes with h: a h^p, a h, a h^2, a h + b h^2.
enum class ErrorForm { free_order, first_order, second_order, first_and_second_order };
std::string word(ErrorForm form);

enum class GridOutcome { fitted, too_few_grids };
std::string word(GridOutcome outcome);

inline constexpr int fewest_grids = 4;  // different h: three parameters, and one degree of freedom for the scatter

// f(h) = limit + error_at(h).
struct GridFit {
  ErrorForm form = ErrorForm::free_order;
  bool fine_weighted = false;  // the fit gave fine meshes more weight, as 1/h
  double limit = 0;
  double order = 0;               // p of a h^p; 0 of a h + b h^2
  double a = 0, b = 0;            // b is 0 but for a h + b h^2
  double standard_deviation = 0;  // of the points about the fit, with n - m degrees of freedom

  double error_at(double h) const;
  double at(double h) const { return limit + error_at(h); }
};

struct GridConvergence {
  GridOutcome outcome = GridOutcome::too_few_grids;  // of which nothing below is to be used
  GridFit fit;
  double observed_order =
      0;  // of the free fit, also where it was then not used; between its search's bounds; a given form's
  bool order_is_reasonable = false;  // 0.5 to 2, or given
  double data_range = 0;             // Delta_M = (largest - smallest value)/(n - 1)
  double safety_factor = 3;
  std::vector<double> uncertainty;  // of each point: the exact value is within it, in 95 of 100 cases

  // The scatter about the fit is smaller than the data range: the values follow a curve.
  bool is_smooth() const { return fit.standard_deviation <= data_range; }
};

// Least squares of f0 + a h^p, with equal weights and with 1/h; where the order found is not between 0.5 and 2, of the forms
// with fixed orders in its place; of these the one with the smallest standard deviation. Where every point has a standard
// error, weights are also as 1/error^2. With a form given, that one with the better of the two kinds of weights. Throws BadInput where
// an h is not positive or a number is not finite.
GridConvergence grid_convergence(std::span<const GridPoint> points, std::optional<ErrorForm> form = {});

// Other series that could have been found: the fit's values with normal noise of each point's standard error, or of the
// scatter about the fit where that is larger. The same seed gives the same numbers.
std::vector<std::vector<GridPoint>> resampled(std::span<const GridPoint> points, const GridFit& fit, int count,
                                              std::uint64_t seed);

// The value below which a share of them lies, between neighbours linear. Not empty; sorts a copy.
double quantile(std::vector<double> values, double share);

}  // namespace percal
