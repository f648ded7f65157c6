#include "percal/math/root.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>

#include <cassert>
#include <cmath>
#include <exception>
#include <limits>
#include <memory>

namespace percal {
namespace {

constexpr int most_iterations = 200;  // Brent halves at the latest

// GSL calls back from C, through which no exception may fly.
struct Callback {
  const std::function<double(double)>& function;
  std::exception_ptr failure;

  static double call(double x, void* data) {
    auto* self = static_cast<Callback*>(data);
    if (self->failure) return 0;
    try {
      return self->function(x);
    } catch (...) {
      self->failure = std::current_exception();
      return 0;
    }
  }
};

}  // namespace

double root(const std::function<double(double)>& function, double low, double high, double tolerance) {
  return root(function, low, high, [&](double, double width) { return width < tolerance; });
}

double root(const std::function<double(double)>& function, double low, double high,
            const std::function<bool(double estimate, double width)>& enough) {
  gsl_set_error_handler_off();
  Callback callback{function, nullptr};
  gsl_function called{&Callback::call, &callback};
  const std::unique_ptr<gsl_root_fsolver, decltype(&gsl_root_fsolver_free)> solver(
      gsl_root_fsolver_alloc(gsl_root_fsolver_brent), &gsl_root_fsolver_free);
  int status = gsl_root_fsolver_set(solver.get(), &called, low, high);
  for (int k = 0; k < most_iterations && status == GSL_SUCCESS && !callback.failure; ++k) {
    const double width = gsl_root_fsolver_x_upper(solver.get()) - gsl_root_fsolver_x_lower(solver.get());
    if (enough(gsl_root_fsolver_root(solver.get()), width)) break;
    status = gsl_root_fsolver_iterate(solver.get());
  }
  if (callback.failure) std::rethrow_exception(callback.failure);
  assert(status == GSL_SUCCESS);
  return status == GSL_SUCCESS ? gsl_root_fsolver_root(solver.get()) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace percal
