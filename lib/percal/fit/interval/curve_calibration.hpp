// A curve fit as a calibration problem, and the bootstrap over its points. Its points are data on the scale of its residuals,
// where their errors are equal.                                                                  docs/theory/curves.md
#pragma once
#include "percal/estimate/intervals.hpp"
#include "percal/estimate/least_squares.hpp"
#include "percal/fit/search/fit_curves.hpp"

namespace percal {

// Where the points' errors come from: their own scatter about the model, or the standard errors that the file gives.
enum class ErrorSource { residuals, standard_errors };

// Standard errors are believed where every point counts by its own, and the best fit's misfit may be chance.           (32)
ErrorSource error_source(const CurveProblem& problem, const CurveOptions& options, double sum_of_squares, int degrees);

// Whether so small a sum of squared residuals is rounding alone.
bool lies_on_the_model(const CurveProblem& problem, double sum_of_squares);

// Mean product of residuals that are neighbours in a test, over the mean square: one for each point of the problem. None with few. (33)
std::optional<double> neighbour_correlation(const CurveProblem& problem, const Eigen::VectorXd& residual);

// Searched parameters of a solid: ln mu_k, within a factor of `modulus_reach` of the fit's (mu_k itself where the signs are
// free, up to so many times the largest), then the free alpha_k within +-largest_alpha.
inline constexpr double modulus_reach = 1e3;

// The data are weight * stress, in the order of the problem's points, all of one group. The problem must outlive the
// result.
CalibrationProblem calibration_of(const CurveProblem& problem, const CurveOptions& options, const Hyperelastic& solid,
                                  ErrorSource errors);

// The solid's place on the searched scale of that problem.
Eigen::VectorXd searched(const CalibrationProblem& problem, const Hyperelastic& solid);

// Where every point is even in alpha (planar tension, simple shear), the sign of alpha is a convention: each alpha then
// stays on its side of 0.
bool even_in_alpha(const CurveProblem& problem);

// Percentile intervals at a level from `replicates` fits that start from the minimum. Assumes nothing of the points' errors but that
// the points are independent. The same seed gives the same numbers. The groups must have been estimated or the errors
// known, as the problem says. Draws with fewer than `parameters` + 1 different points count as failed.
Bootstrap bootstrap_over_points(const CalibrationProblem& problem, const Minimum& minimum, int replicates, double level,
                                unsigned seed, const SearchOptions& options);

// The problem whose data are those at `rows`, in that order, any of them more than once. It refers to `problem`.
CalibrationProblem drawn(const CalibrationProblem& problem, const std::vector<int>& rows);

}  // namespace percal
