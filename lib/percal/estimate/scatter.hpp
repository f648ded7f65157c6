// The scatter of each group of data about the model, found from the residuals.        docs/theory/calibration.md (4) to (8)
#pragma once
#include <Eigen/Core>
#include <vector>

#include "percal/estimate/least_squares.hpp"
#include "percal/estimate/weights.hpp"

namespace percal {

// From residuals about any point, as if nothing had been fitted to them, and no smaller than `coarse_scatter` of the range
// of the group's values: a start for what follows.
inline constexpr double coarse_scatter = 0.01;
// Of a group whose data all tell sides alone: a start, and a least one, since sides that do not overlap are told best by none.
inline constexpr double first_scatter_of_sides = 0.1, least_scatter_of_sides = 0.01;
std::vector<double> first_scatter(const CalibrationProblem& problem, const Eigen::VectorXd& residuals);

// The inverse of an information matrix over `free` (0 elsewhere). A direction that the data leave wider than the box gets the
// box's width as its standard deviation.
Eigen::MatrixXd bounded_inverse(const CalibrationProblem& problem, const Eigen::MatrixXd& information,
                                const std::vector<int>& free);

// The slope and the curvature of a fit's restricted likelihood with respect to the groups' squared scatters, at one point. 0 for
// a group that is not estimated, and for one whose data the parameters fit whatever they are.
struct RestrictedLikelihood {
  Eigen::VectorXd score;                          // d ln likelihood / d scatter^2
  Eigen::MatrixXd fisher;                         // expected information of the scatters^2
  Eigen::MatrixXd covariance;                     // of the parameters
  std::vector<Eigen::MatrixXd> covariance_slope;  // d covariance / d scatter^2 of each group
};
RestrictedLikelihood restricted_likelihood(const CalibrationProblem& problem, const ModelAnswer& answer,
                                           const Eigen::VectorXd& searched, const std::vector<double>& scatter,
                                           const std::vector<int>& free);

// The scatters that make the restricted likelihood largest at this point, from `scatter`. Fixed ones stay.
std::vector<double> restricted_scatter(const CalibrationProblem& problem, const ModelAnswer& answer,
                                       const Eigen::VectorXd& searched, std::vector<double> scatter,
                                       const std::vector<int>& free);

// The inverse of `fisher` over the directions of which the data say anything, 0 in the others.
Eigen::MatrixXd scatter_covariance(const RestrictedLikelihood& likelihood);

}  // namespace percal
