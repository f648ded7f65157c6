#include "percal/math/draws.hpp"

#include <gsl/gsl_qrng.h>

#include <cassert>
#include <memory>
#include <new>

#include "percal/math/distributions.hpp"

namespace percal {

// The middle of one of 2^53 equal parts of (0, 1).
double Draws::uniform() { return (static_cast<double>(engine_() >> 11) + 0.5) * 0x1p-53; }

double Draws::normal() { return normal_quantile(uniform()); }

int Draws::index(int count) { return static_cast<int>(uniform() * count); }

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
