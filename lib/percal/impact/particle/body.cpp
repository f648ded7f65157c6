#include "percal/impact/particle/body.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "percal/base/error.hpp"

namespace percal {
namespace {

// `further` as in elastic_piola.
scalar::Piola<double> piola(const BodySolid& solid, const scalar::Gradient<double>& F,
                            const scalar::Stretches<double>& s, double further) {
  return scalar::elastic_piola(solid.elastic(), F, s, scalar::isochoric_powers(F, s, solid.alpha), further);
}

// Needs a convex quad with corners counter-clockwise, and in axisymmetry none left of the axis.
QuadForm quad_form(const std::array<Point, 4>& corners, Geometry geometry) {
  constexpr double xi[4] = {-1, 1, 1, -1}, eta[4] = {-1, -1, 1, 1};
  const bool round = geometry == Geometry::axisymmetric;
  QuadForm form{};
  // 2 x 2 Gauss points: the integrands are of third degree at most in each direction, so this is exact.
  for (int point = 0; point < 4; ++point) {
    const double s = xi[point] / std::sqrt(3.0), t = eta[point] / std::sqrt(3.0);
    double x_s = 0, x_t = 0, y_s = 0, y_t = 0, radius = 0;
    std::array<double, 4> N, N_s, N_t;
    for (int a = 0; a < 4; ++a) {
      N[a] = 0.25 * (1 + xi[a] * s) * (1 + eta[a] * t);
      N_s[a] = 0.25 * xi[a] * (1 + eta[a] * t);
      N_t[a] = 0.25 * eta[a] * (1 + xi[a] * s);
      x_s += N_s[a] * corners[a][0];
      x_t += N_t[a] * corners[a][0];
      y_s += N_s[a] * corners[a][1];
      y_t += N_t[a] * corners[a][1];
      radius += N[a] * corners[a][0];
    }
    const double det = x_s * y_t - x_t * y_s, weight = round ? radius : 1;
    for (int a = 0; a < 4; ++a) {
      form.dx[a] += (N_s[a] * y_t - N_t[a] * y_s) * weight;  // det cancels against 1/det of the inverse
      form.dy[a] += (N_t[a] * x_s - N_s[a] * x_t) * weight;
      form.hoop[a] += round ? N[a] * det : 0;
      form.mass_share[a] += N[a] * weight * det;
    }
    form.volume += weight * det;
    form.area += det;
  }
  double pattern_x = 0, pattern_y = 0;
  for (int a = 0; a < 4; ++a) {
    form.dx[a] /= form.volume;
    form.dy[a] /= form.volume;
    form.hoop[a] /= form.volume;
    pattern_x += xi[a] * eta[a] * corners[a][0];
    pattern_y += xi[a] * eta[a] * corners[a][1];
  }
  for (int a = 0; a < 4; ++a) form.mode[a] = xi[a] * eta[a] - pattern_x * form.dx[a] - pattern_y * form.dy[a];
  return form;
}

}  // namespace

double BodySolid::wave_speed() const { return std::sqrt(lame_modulus() / density); }

BodySolid elastic_solid(double young, double poisson, double density) {
  BodySolid solid;
  solid.mu = young / (2 * (1 + poisson));
  solid.bulk = young / (3 * (1 - 2 * poisson));
  solid.density = density;
  return solid;
}

Body::Body(const QuadMesh& mesh, Geometry geometry, const BodySolid& solid)
    : mesh_(mesh), geometry_(geometry), solid_(solid) {
  const std::size_t count = mesh.nodes.size();
  for (auto* field : {&displacement_, &velocity_, &force_}) field->assign(count, Point{});
  mass_.assign(count, 0);
  viscosity_.resize(mesh.elements.size());
  for (const auto& element : mesh.elements) {
    QuadMesh alone{{}, {{0, 1, 2, 3}}};
    for (const int node : element) alone.nodes.push_back(mesh.nodes[node]);
    if (!(worst_corner(alone) > 0))
      throw BadInput({}, "element " + std::to_string(forms_.size()) + " of a body's mesh, which is not convex",
                     "convex quads, corners counter-clockwise");
    forms_.push_back(quad_form({alone.nodes[0], alone.nodes[1], alone.nodes[2], alone.nodes[3]}, geometry));
    for (int a = 0; a < 4; ++a) mass_[element[a]] += solid.density * forms_.back().mass_share[a];
  }
  mass_in_step_.resize(mesh.elements.size());
  share_masses_for_step();
  for (const double m : mass_) inverse_mass_.push_back({1 / m, 1 / m});
  if (geometry == Geometry::axisymmetric)
    for (int n = 0; n < nodes(); ++n)
      if (mesh.nodes[n][0] == 0) hold(n, 0);
}

Point Body::position(int node) const {
  return {mesh_.nodes[node][0] + displacement_[node][0], mesh_.nodes[node][1] + displacement_[node][1]};
}

Point Body::momentum() const {
  Point sum{};
  for (int n = 0; n < nodes(); ++n)
    for (int d = 0; d < 2; ++d) sum[d] += mass_[n] * velocity_[n][d];
  return sum;
}

void Body::hold(int node, int direction) {
  inverse_mass_[node][direction] = 0;
  velocity_[node][direction] = 0;
}

scalar::Gradient<double> Body::gradient(int element) const {
  const QuadForm& form = forms_[element];
  scalar::Gradient<double> F{1, 0, 0, 1, 1};
  for (int a = 0; a < 4; ++a) {
    const Point& u = displacement_[mesh_.elements[element][a]];
    F.rr += u[0] * form.dx[a];
    F.rz += u[0] * form.dy[a];
    F.zr += u[1] * form.dx[a];
    F.zz += u[1] * form.dy[a];
    F.hoop += u[0] * form.hoop[a];
  }
  return F;
}

scalar::Piola<double> Body::first_piola(int element) const {
  const auto F = gradient(element);
  return piola(solid_, F, scalar::stretches(F), 0);
}

double Body::energy_density(int element) const {
  const auto F = gradient(element);
  const auto s = scalar::stretches(F);
  return scalar::strain_energy(solid_.elastic(), s, scalar::isochoric_powers(F, s, solid_.alpha));
}

double Body::smallest_jacobian() const {
  double smallest = std::numeric_limits<double>::infinity();
  for (int e = 0; e < elements(); ++e) smallest = std::min(smallest, scalar::stretches(gradient(e)).unbounded_jacobian);
  return smallest;
}

// f_a = -V (P_.x dx_a + P_.y dy_a + e_x P_hoop hoop_a) - k mode_a (mode . u)
void Body::forces() {
  std::fill(force_.begin(), force_.end(), Point{});
  for (int e = 0; e < elements(); ++e) {
    const QuadForm& form = forms_[e];
    const auto& corners = mesh_.elements[e];
    const auto F = gradient(e);
    const auto s = scalar::stretches(F);
    const auto P = piola(solid_, F, s, -viscous_pressure(e, s) * s.jacobian);
    Point pattern{};
    for (int a = 0; a < 4; ++a)
      for (int d = 0; d < 2; ++d) pattern[d] += form.mode[a] * displacement_[corners[a]][d];
    const double V = form.volume, k = hourglass_stiffness(e);
    for (int a = 0; a < 4; ++a) {
      Point& f = force_[corners[a]];
      f[0] -= V * (P.rr * form.dx[a] + P.rz * form.dy[a] + P.hoop * form.hoop[a]) + k * form.mode[a] * pattern[0];
      f[1] -= V * (P.zr * form.dx[a] + P.zz * form.dy[a]) + k * form.mode[a] * pattern[1];
    }
  }
  last_drift_ = 0;
}

// What full integration of (hourglass mu/2) |grad u|^2 gives to the pattern of a rectangle.
double Body::hourglass_stiffness(int element) const {
  const QuadForm& form = forms_[element];
  double gradients = 0;
  for (int a = 0; a < 4; ++a) gradients += form.dx[a] * form.dx[a] + form.dy[a] * form.dy[a];
  return solid_.hourglass * solid_.mu / 12 * form.volume * gradients;
}

// Bulk viscosity, docs/theory/impact.md (9): a pressure q against closing, from the change of J in the last step. Its work in
// that step is taken by the trapezoidal rule.
double Body::viscous_pressure(int element, const scalar::Stretches<double>& s) {
  Viscosity& state = viscosity_[element];
  if (solid_.linear_viscosity == 0 && solid_.quadratic_viscosity == 0) return 0;
  const double J = s.jacobian, opened = J - state.jacobian;
  if (last_drift_ == 0)
    state.jacobian = J;  // nothing moved by a step: the body was put here
  else {
    const double closing = std::max(0.0, -opened / (J * last_drift_));
    const double length = std::sqrt(forms_[element].area * s.in_plane_jacobian), c2 = solid_.quadratic_viscosity;
    const double q = solid_.density * length *
                     (solid_.linear_viscosity * solid_.wave_speed() + c2 * c2 * length * closing) * closing;
    viscous_work_ -= forms_[element].volume * (state.pressure + q) / 2 * opened;
    state = {J, closing, q};
  }
  return state.pressure;
}

void Body::add_force(int node, const Point& force) {
  for (int d = 0; d < 2; ++d) force_[node][d] += force[d];
}

void Body::step(double kick, double drift) {
  for (int n = 0; n < nodes(); ++n)
    for (int d = 0; d < 2; ++d) {
      velocity_[n][d] += kick * force_[n][d] * inverse_mass_[n][d];
      displacement_[n][d] += drift * velocity_[n][d];
    }
  last_drift_ = drift;
}

double Body::kinetic_energy() const {
  double energy = 0;
  for (int n = 0; n < nodes(); ++n)
    energy += mass_[n] / 2 * (velocity_[n][0] * velocity_[n][0] + velocity_[n][1] * velocity_[n][1]);
  return energy;
}

BodyEnergy Body::energy() const {
  BodyEnergy energy{.kinetic = kinetic_energy()};
  for (int e = 0; e < elements(); ++e) {
    energy.elastic += forms_[e].volume * energy_density(e);
    for (int d = 0; d < 2; ++d) {
      double pattern = 0;
      for (int a = 0; a < 4; ++a) pattern += forms_[e].mode[a] * displacement_[mesh_.elements[e][a]][d];
      energy.hourglass += hourglass_stiffness(e) / 2 * pattern * pattern;
    }
  }
  energy.viscous = viscous_work_;
  return energy;
}

}  // namespace percal
