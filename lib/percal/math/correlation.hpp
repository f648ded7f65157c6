// How alike the values of a smooth function are at two points, by their distance: correlations of a Gaussian process, over
// s = sum_j ((x_j - x'_j)/length_j)^2. Both have a derivative everywhere.                      docs/theory/emulator.md (3)
#pragma once
#include <Eigen/Core>

namespace percal {

// exp(-s/2): all derivatives.
struct SquaredExponential {
  template <class Array>
  static auto value(const Array& s) {
    return (-0.5 * s).exp();
  }
  // d value / d s
  template <class Array>
  static auto slope(const Array& s) {
    return -0.5 * (-0.5 * s).exp();
  }
};

// (1 + r + r^2/3) exp(-r), r^2 = 5 s: two derivatives.
struct Matern52 {
  template <class Array>
  static typename Array::PlainObject value(const Array& s) {
    const typename Array::PlainObject r = (5 * s).sqrt();
    return (1 + r + r.square() / 3) * (-r).exp();
  }
  template <class Array>
  static typename Array::PlainObject slope(const Array& s) {
    const typename Array::PlainObject r = (5 * s).sqrt();
    return -5.0 / 6 * (1 + r) * (-r).exp();
  }
  // Both by one exponential.
  template <class Array>
  static void both(const Array& s, Array& value, Array& slope) {
    const Array r = (5 * s).sqrt(), decay = (-r).exp();
    value = (1 + r + r.square() / 3) * decay;
    slope = -5.0 / 6 * (1 + r) * decay;
  }
};

// s of every row of `a` (n x d) with every row of `b` (m x d): n x m. Lengths not 0.
inline Eigen::ArrayXXd scaled_squared_distances(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b,
                                                const Eigen::VectorXd& length) {
  const Eigen::MatrixXd first = a * length.cwiseInverse().asDiagonal();
  const Eigen::MatrixXd second = b * length.cwiseInverse().asDiagonal();
  Eigen::MatrixXd squares = -2 * first * second.transpose();
  squares.colwise() += first.rowwise().squaredNorm();
  squares.rowwise() += second.rowwise().squaredNorm().transpose();
  return squares.array().max(0.0);
}

}  // namespace percal
