// Points of parameter space that the data do not rule out: where the emulator has to be right.
#pragma once
#include "percal/calibrate/job_fit.hpp"

namespace percal {

// `count` points (all of the model's parameters) of a Metropolis walk over exp(-objective / 2 / temperature) with the weights of
// the best minimum, thinned, the best point first. The walk's steps follow the fit's own covariance. The same seed gives the
// same points.
std::vector<Eigen::VectorXd> plausible_points(const JobFit& fit, int count, double temperature, unsigned seed);

}  // namespace percal
