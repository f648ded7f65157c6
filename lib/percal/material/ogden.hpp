// The one-term Ogden solid, incompressible here; impact/ has the compressible form that the solver uses.
//   W = (2 mu/alpha^2) (lambda_1^alpha + lambda_2^alpha + lambda_3^alpha - 3)      Guha 2009, Eq. 3-2
// mu is the small-strain shear modulus.
#pragma once
#include <cmath>

namespace percal {

// T is double or a number that carries its derivatives (ceres::Jet).
template <class T>
struct OgdenOf {
  T mu;     // Pa
  T alpha;  // any real number; 0 is the limit W = mu (sum ln^2 lambda)
};
using Ogden = OgdenOf<double>;

// sinh(x)/x, 1 at x = 0; the series below |x| = 1 keeps the derivative exact too.        docs/theory/curves.md (4)
template <class T>
T sinh_over(const T& x) {
  using std::sinh;
  if (x > -1.0 && x < 1.0) {
    const T square = x * x;
    T sum = T(1.0);
    for (int k = 10; k >= 1; --k) sum = T(1.0) + sum * square / T(2.0 * k * (2.0 * k + 1.0));
    return sum;
  }
  return sinh(x) / x;
}

// Difference of two principal Cauchy stresses, sigma_i - sigma_j = (2 mu/alpha) (lambda_i^alpha - lambda_j^alpha), Pa,
// from the logarithms of the two stretches. Exact also at alpha = 0 and near lambda = 1. docs/theory/curves.md (3)
template <class T>
T cauchy_difference(const OgdenOf<T>& solid, double log_i, double log_j) {
  using std::exp;
  return solid.mu * (2 * (log_i - log_j)) * exp(solid.alpha * ((log_i + log_j) / 2)) *
         sinh_over(T(solid.alpha * ((log_i - log_j) / 2)));
}

}  // namespace percal
