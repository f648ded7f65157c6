// What the kernel does, element by element in plain double: the yardstick of every instruction level.
#pragma once
#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "percal/impact/kernel/element.hpp"
#include "percal/impact/kernel/kernel.hpp"
#include "percal/impact/target/block.hpp"
#include "percal/impact/target/constants.hpp"

#if defined(__x86_64__)
namespace percal::x86_64_v2 {
extern const Kernel<float> single_kernel;
extern const Kernel<double> double_kernel;
}  // namespace percal::x86_64_v2
namespace percal::x86_64_v3 {
extern const Kernel<float> single_kernel;
extern const Kernel<double> double_kernel;
}  // namespace percal::x86_64_v3
namespace percal::x86_64_v4 {
extern const Kernel<float> single_kernel;
extern const Kernel<double> double_kernel;
}  // namespace percal::x86_64_v4
#endif

namespace percal {

struct NamedKernels {
  std::string level;
  const Kernel<float>* single;
  const Kernel<double>* twice;
};

// The kernels that this processor can run.
inline std::vector<NamedKernels> kernels_here() {
#if defined(__x86_64__)
  std::vector<NamedKernels> kernels{{"x86_64_v2", &x86_64_v2::single_kernel, &x86_64_v2::double_kernel}};
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    kernels.push_back({"x86_64_v3", &x86_64_v3::single_kernel, &x86_64_v3::double_kernel});
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))
    kernels.push_back({"x86_64_v4", &x86_64_v4::single_kernel, &x86_64_v4::double_kernel});
  return kernels;
#else
  return {{instruction_level(), &kernel<float>(), &kernel<double>()}};
#endif
}

template <class Real>
const Kernel<Real>& of(const NamedKernels& kernels);
template <>
inline const Kernel<float>& of(const NamedKernels& kernels) {
  return *kernels.single;
}
template <>
inline const Kernel<double>& of(const NamedKernels& kernels) {
  return *kernels.twice;
}

// Corners: inner upper, outer upper, outer lower, inner lower.
inline constexpr int corner_column[4] = {0, 1, 1, 0}, corner_row[4] = {0, 0, 1, 1};
inline constexpr double along_r[4] = {-0.5, 0.5, 0.5, -0.5}, along_z[4] = {-0.5, -0.5, 0.5, 0.5};
inline constexpr double hourglass_mode[4] = {1, -1, 1, -1};

struct NodalForces {
  std::vector<double> r, z;  // [block.at(column, row)]
  double viscous_work = 0, largest_inverse_step = 0;
};

// Internal forces of all elements that are alive, bulk viscosity included where previous_step > 0.
template <class Real>
NodalForces reference_forces(const Block<Real>& block, const MaterialConstants& m, double previous_step) {
  const auto& view = block.view();
  const auto& mesh = block.mesh();
  const auto entries = static_cast<std::size_t>(mesh.columns() + 1) * view.stride;
  NodalForces forces{std::vector<double>(entries), std::vector<double>(entries)};
  for (int i = 0; i < mesh.columns(); ++i)
    for (int j = 0; j < mesh.rows; ++j) {
      if (!(view.alive[block.at(i, j)] > 0)) continue;
      const auto& shape = block.shapes()[i];
      const double w = shape.width, h = shape.height, thickness = shape.thickness,
                   quarter_per_radius = shape.per_radius / 4, volume = thickness * w * h;
      scalar::Gradient<double> F{1, 0, 0, 1, 1};
      double mode_r = 0, mode_z = 0;
      for (int a = 0; a < 4; ++a) {
        const long n = block.at(i + corner_column[a], j + corner_row[a]);
        const double ur = view.u_r[n], uz = view.u_z[n];
        F.rr += along_r[a] * ur / w;
        F.rz += along_z[a] * ur / h;
        F.zr += along_r[a] * uz / w;
        F.zz += along_z[a] * uz / h;
        F.hoop += ur * quarter_per_radius;
        mode_r += hourglass_mode[a] * ur;
        mode_z += hourglass_mode[a] * uz;
      }
      const auto s = scalar::stretches(F);
      const auto g = scalar::isochoric_powers(F, s, m.alpha);
      const auto t = scalar::isochoric_stress(g, 2 * m.mu / m.alpha);
      const double J = s.jacobian, old = view.jacobian[block.at(i, j)];
      const double closing = previous_step > 0 ? std::max((old - J) / (J * previous_step), 0.0) : 0;
      const double length = std::sqrt(w * h * s.in_plane_jacobian);
      const double damping = length * (m.linear_viscosity + m.quadratic_viscosity * length * closing),
                   q = damping * closing;
      const auto P = scalar::first_piola(F, s, t, m.bulk / 2 * (J * J - 1) - q * J);
      const double stiffness = m.hourglass * m.mu / 12 * (h / w + w / h) * thickness;
      for (int a = 0; a < 4; ++a) {
        const long n = block.at(i + corner_column[a], j + corner_row[a]);
        const double nr = along_r[a] / w, nz = along_z[a] / h;
        forces.r[n] -=
            volume * (P.rr * nr + P.rz * nz + P.hoop * quarter_per_radius) + stiffness * hourglass_mode[a] * mode_r;
        forces.z[n] -= volume * (P.zr * nr + P.zz * nz) + stiffness * hourglass_mode[a] * mode_z;
      }
      forces.viscous_work += volume * 0.5 * (view.viscous_pressure[block.at(i, j)] + q) * (old - J);
      const auto bound =
          scalar::step_bound(s, g, t, m.mu, m.bulk, 1 / (w * w), 1 / (h * h),
                             (shape.at_axis ? scalar::axis_hoop_share : 1) * shape.per_radius * quarter_per_radius);
      const double drag = damping * J * bound.over_stretch;
      forces.largest_inverse_step =
          std::max(forces.largest_inverse_step, std::sqrt(bound.stiffness + drag * drag) + drag);
    }
  return forces;
}

// A small block: 3 fine and 2 graded columns, 37 rows, so that no group of lanes ends with the column.
inline Problem small_problem(double alpha) {
  Problem p;
  p.pi4 = 0.5;
  p.density_ratio = 16.8;
  p.alpha = alpha;
  p.depth = 37.0 / 3;
  p.width = 3;
  p.elements_per_radius = 3;
  p.graded_columns = 2;
  return p;
}

inline MaterialConstants constants_of(const Problem& p) {
  return {.mu = p.mu(),
          .bulk = p.bulk(),
          .alpha = p.alpha,
          .hourglass = p.hourglass,
          .linear_viscosity = 0.4,
          .quadratic_viscosity = 1.44,
          .erosion_stretch = 1e9,
          .smallest_jacobian = 1e-3,
          .largest_inverse_step = 1e9};
}

// Displaces every node by up to `amount` row heights in each direction (the axis along itself only). The numbers drawn fit a
// float, so that blocks of both kinds stand in the same place.
template <class Real>
void displace(Block<Real>& block, double amount, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto& view = block.view();
  for (int i = 0; i <= block.mesh().columns(); ++i)
    for (int j = 0; j <= block.mesh().rows; ++j) {
      const auto r = static_cast<float>(amount * block.mesh().row_height * uniform(random));
      const auto z = static_cast<float>(amount * block.mesh().row_height * uniform(random));
      view.u_r[block.at(i, j)] = static_cast<Real>(i == 0 ? 0.0f : r);
      view.u_z[block.at(i, j)] = static_cast<Real>(z);
    }
}

// Where the kernel puts the forces of one column of elements, when the columns are taken from the first to the last.
template <class Real>
ColumnForces<Real> column_forces(Block<Real>& block, int column) {
  const auto& forces = block.far_forces();
  const long inner = block.at(column, 0), outer = block.at(column + 1, 0);
  return {forces.r + inner, forces.z + inner, forces.r + outer, forces.z + outer, column == 0};
}

// Runs the kernel over one column of elements; earlier columns must have been run.
template <class Real>
void column_internal_forces(const Kernel<Real>& kernel, Block<Real>& block, int column, const MaterialConstants& m,
                            double previous_step, ColumnReport& report) {
  const int groups = (block.mesh().rows + kernel.lanes - 1) / kernel.lanes;
  std::vector<unsigned char> flags(groups);
  kernel.internal_forces(block.view(), column_forces(block, column), column, {0, groups * kernel.lanes},
                         block.shapes()[column], m, previous_step, {1e30, flags.data()}, report);
}

// Over the whole block: the forces are in block.far_forces().
template <class Real>
ColumnReport all_internal_forces(const Kernel<Real>& kernel, Block<Real>& block, const MaterialConstants& m,
                                 double previous_step) {
  ColumnReport report;
  for (int i = 0; i < block.mesh().columns(); ++i) column_internal_forces(kernel, block, i, m, previous_step, report);
  return report;
}

}  // namespace percal
