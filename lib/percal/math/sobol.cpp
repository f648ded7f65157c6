#include "percal/math/sobol.hpp"

#include <gsl/gsl_qrng.h>

#include <cassert>
#include <memory>
#include <new>

namespace percal {

Eigen::MatrixXd sobol_points(int count, int dimensions, int skip) {
  assert(dimensions >= 1 && dimensions <= most_sobol_dimensions && count >= 0 && skip >= 0);
  const std::unique_ptr<gsl_qrng, decltype(&gsl_qrng_free)> sequence(
      gsl_qrng_alloc(gsl_qrng_sobol, static_cast<unsigned>(dimensions)), gsl_qrng_free);
  if (!sequence) throw std::bad_alloc();
  Eigen::VectorXd point(dimensions);
  for (int i = 0; i < skip; ++i) gsl_qrng_get(sequence.get(), point.data());
  Eigen::MatrixXd points(count, dimensions);
  for (int i = 0; i < count; ++i) {
    gsl_qrng_get(sequence.get(), point.data());
    points.row(i) = point.transpose();
  }
  return points;
}

}  // namespace percal
