#include "percal/impact/quad_form.hpp"

#include <cmath>

namespace percal {

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

}  // namespace percal
