// The stable step of a Body. The largest frequency of a mesh is at most that of its worst element with its share of the nodes'
// masses, however each mass is divided among the elements around it (share_masses_for_step: as their stiffnesses there stand). For an element it is the largest eigenvalue of m^-1 V B^T A B, which is that of A G with
//   A = dP/dF,   G = V B m^-1 B^T   (5 x 5: the components of F),
// and no eigenvalue exceeds any norm of a power of the matrix, to the root of that power. Hourglass stiffness adds its own.
#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "percal/impact/particle/body.hpp"

namespace percal {
namespace {

using Matrix5 = Eigen::Matrix<double, 5, 5>;

// Where the principal directions of an element lie: the columns of `before` in the undeformed state, of `after` now.
struct Principal {
  Eigen::Vector3d stretch;  // two in the plane, hoop
  Eigen::Matrix2d before, after;
};

Principal principal(const scalar::Gradient<double>& F, const scalar::Stretches<double>& s) {
  Principal p;
  p.stretch = {std::sqrt(s.first2), std::sqrt(s.second2), F.hoop};
  const double angle = 0.5 * std::atan2(s.shear, s.half_difference);
  p.before << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  Eigen::Matrix2d in_plane;
  in_plane << F.rr, F.rz, F.zr, F.zz;
  p.after.col(0) = (in_plane * p.before.col(0)).normalized();
  p.after.col(1) = Eigen::Vector2d(-p.after(1, 0), p.after(0, 0));
  return p;
}

// A in principal components, in the order 11, 22, hoop, 12, 21. With tau_i the principal Kirchhoff stresses,
//   lambda_i lambda_j dP_i/dlambda_j = dtau_i/dln lambda_j - delta_ij tau_i,
//   dtau_i/dln lambda_j = 2 mu (delta_ij g_i - (g_i + g_j)/3 + sum g/9) + K J^2.
Matrix5 tangent(const BodySolid& solid, const scalar::Gradient<double>& F, const scalar::Stretches<double>& s,
                const Principal& p) {
  const auto powers = scalar::isochoric_powers(F, s, solid.alpha);
  const auto stress = scalar::isochoric_stress(powers, 2 * solid.mu / solid.alpha);
  const double J = s.jacobian, pressure = scalar::kirchhoff_pressure(PressureLaw::log_quadratic, J, solid.bulk);
  const Eigen::Vector3d g(powers.first, powers.second, powers.hoop), lambda = p.stretch;
  const Eigen::Vector3d tau(stress.first + pressure, stress.second + pressure, stress.hoop + pressure);
  Matrix5 A = Matrix5::Zero();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const double own = i == j ? 2 * solid.mu * g[i] - tau[i] : 0;
      A(i, j) = (own + 2 * solid.mu * (g.sum() / 9 - (g[i] + g[j]) / 3) + solid.bulk * J * J) / (lambda[i] * lambda[j]);
    }
  const double difference = s.first2 - s.second2;
  A(3, 3) = A(4, 4) = (tau[0] - tau[1]) / difference;
  A(3, 4) = A(4, 3) = (lambda[1] / lambda[0] * tau[0] - lambda[0] / lambda[1] * tau[1]) / difference;
  return A;
}

// For each corner and direction 1/m, or 0 where it is held.
using InverseMass = std::array<Point, 4>;

// G in the same components: how component iJ of F changes with each displacement of a corner.
Matrix5 compliance_of_mass(const QuadForm& form, const InverseMass& inverse_mass, const Principal& p) {
  Matrix5 G = Matrix5::Zero();
  for (int a = 0; a < 4; ++a) {
    const Eigen::Vector2d gradient = p.before.transpose() * Eigen::Vector2d(form.dx[a], form.dy[a]);
    for (int d = 0; d < 2; ++d) {
      Eigen::Matrix<double, 5, 1> row;
      row << p.after(d, 0) * gradient[0], p.after(d, 1) * gradient[1], d == 0 ? form.hoop[a] : 0,
          p.after(d, 0) * gradient[1], p.after(d, 1) * gradient[0];
      G += form.volume * inverse_mass[a][d] * row * row.transpose();
    }
  }
  return G;
}

// No eigenvalue of X is larger; at most a fifth above the largest.
double bound_of_eigenvalues(const Matrix5& X) {
  const Matrix5 second = X * X, fourth = second * second, eighth = fourth * fourth;
  return std::sqrt(std::sqrt(std::sqrt(eighth.cwiseAbs().rowwise().sum().maxCoeff())));
}

}  // namespace

void Body::share_masses_for_step() {
  std::vector<double> sum(mass_.size(), 0);
  for (int round = 0; round < 2; ++round)
    for (int e = 0; e < elements(); ++e)
      for (int a = 0; a < 4; ++a) {
        const QuadForm& form = forms_[e];
        const int node = mesh_.elements[e][a];
        const double stiffness =
            form.volume * (form.dx[a] * form.dx[a] + form.dy[a] * form.dy[a] + form.hoop[a] * form.hoop[a]);
        if (round == 0)
          sum[node] += stiffness;
        else
          mass_in_step_[e][a] = mass_[node] * stiffness / sum[node];
      }
}

// 1/dt^2 = omega^2/4 without viscosity.
double Body::inverse_square_step(int element, const scalar::Gradient<double>& F,
                                 const scalar::Stretches<double>& s) const {
  const QuadForm& form = forms_[element];
  const Principal p = principal(F, s);
  InverseMass inverse_mass{};
  Point pattern{};
  for (int a = 0; a < 4; ++a)
    for (int d = 0; d < 2; ++d) {
      if (held(mesh_.elements[element][a], d)) continue;
      inverse_mass[a][d] = 1 / mass_in_step_[element][a];
      pattern[d] += form.mode[a] * form.mode[a] * inverse_mass[a][d];
    }
  const Matrix5 X = tangent(solid_, F, s, p) * compliance_of_mass(form, inverse_mass, p);
  const double rounding = 1 + 1e-5;  // principal directions are known to 1e-6 where two stretches are equal
  return (rounding * bound_of_eigenvalues(X) + hourglass_stiffness(element) * std::max(pattern[0], pattern[1])) / 4;
}

// D of docs/theory/impact.md (16), with the slope of q by the rate of closing: a quarter of the damping matrix's one eigenvalue.
double Body::viscous_inverse_step(int element, const scalar::Gradient<double>& F,
                                  const scalar::Stretches<double>& s) const {
  const QuadForm& form = forms_[element];
  const double length = std::sqrt(form.area * s.in_plane_jacobian), c2 = solid_.quadratic_viscosity;
  const double slope =
      solid_.density * length *
      (solid_.linear_viscosity * solid_.wave_speed() + 2 * c2 * c2 * length * viscosity_[element].closing);
  double squares = 0;  // sum over corners of |dln J/du|^2/m
  for (int a = 0; a < 4; ++a) {
    const double by_x = (F.zz * form.dx[a] - F.zr * form.dy[a]) / s.in_plane_jacobian + form.hoop[a] / F.hoop;
    const double by_y = (F.rr * form.dy[a] - F.rz * form.dx[a]) / s.in_plane_jacobian;
    squares += (by_x * by_x + by_y * by_y) / mass_in_step_[element][a];
  }
  return slope * form.volume * s.jacobian * squares / 4;
}

double Body::stable_step() const {
  double largest = 0;
  for (int e = 0; e < elements(); ++e) {
    const auto F = gradient(e);
    const auto s = scalar::stretches(F);
    const double D = viscous_inverse_step(e, F, s);
    largest = std::max(largest, D + std::sqrt(D * D + inverse_square_step(e, F, s)));
  }
  return 1 / largest;
}

}  // namespace percal
