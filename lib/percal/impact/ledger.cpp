#include "percal/impact/ledger.hpp"

#include <algorithm>
#include <array>

#include "percal/impact/uniform_solid.hpp"
#include "percal/impact/volumetric_law.hpp"

namespace percal {
namespace {

// Corners: inner upper, outer upper, outer lower, inner lower. Gradient in r and z of each corner's shape function, times the
// element's width and height: -+1/2.
constexpr double along_r[4] = {-0.5, 0.5, 0.5, -0.5}, along_z[4] = {-0.5, -0.5, 0.5, 0.5};
constexpr double hourglass_mode[4] = {1, -1, 1, -1};

template <class Real>
std::array<long, 4> corners_of(const Block<Real>& block, int column, int row) {
  return {block.at(column, row), block.at(column + 1, row), block.at(column + 1, row + 1), block.at(column, row + 1)};
}

}  // namespace

template <class Real>
scalar::Gradient<double> element_gradient(const Block<Real>& block, int column, int row) {
  const auto& view = block.view();
  const auto& shape = block.shapes()[column];
  const auto corner = corners_of(block, column, row);
  scalar::Gradient<double> F{1, 0, 0, 1, 1};
  for (int a = 0; a < 4; ++a) {
    const double ur = view.u_r[corner[a]], uz = view.u_z[corner[a]];
    F.rr += along_r[a] * ur / shape.width;
    F.rz += along_z[a] * ur / shape.height;
    F.zr += along_r[a] * uz / shape.width;
    F.zz += along_z[a] * uz / shape.height;
    F.hoop += ur * shape.per_radius / 4;
  }
  F.hoop = std::max(F.hoop, 1e-3);
  return F;
}

template <class Real>
ElementEnergy element_energy(const Block<Real>& block, const TargetSolid& solid, int column, int row,
                             double last_step) {
  const MaterialConstants& material = solid.of_row(row);
  const auto& view = block.view();
  const auto& shape = block.shapes()[column];
  const auto corner = corners_of(block, column, row);
  const double width = shape.width, height = shape.height, thickness = shape.thickness, per_radius = shape.per_radius,
               volume = thickness * width * height;

  const auto F = element_gradient(block, column, row);
  double mode_r = 0, mode_z = 0;
  for (int a = 0; a < 4; ++a) {
    mode_r += hourglass_mode[a] * view.u_r[corner[a]];
    mode_z += hourglass_mode[a] * view.u_z[corner[a]];
  }
  const auto s = scalar::stretches(F);
  const auto g = scalar::isochoric_powers(F, s, material.alpha);
  const double J = s.jacobian, alpha = material.alpha, mu = material.mu * solid.lasting_share();
  const double density = 2 * mu / (alpha * alpha) * (g.first + g.second + g.hoop - 3) +
                         scalar::volumetric_energy(solid.pressure_law, J, material.bulk);
  const double stiffness =
      solid.hourglass_kind == HourglassKind::stiffness ? scalar::hourglass_stiffness(material, shape) : 0;
  ElementEnergy energy;
  energy.elastic = volume * density;
  energy.hourglass = 0.5 * stiffness * (mode_r * mode_r + mode_z * mode_z);
  if (last_step > 0) {
    const auto P = scalar::first_piola(F, s, scalar::isochoric_stress(g, 2 * mu / alpha),
                                       scalar::kirchhoff_pressure(solid.pressure_law, J, material.bulk));
    double power = 0;
    for (int a = 0; a < 4; ++a) {
      const double nr = along_r[a] / width, nz = along_z[a] / height;
      const double fr =
          -volume * (P.rr * nr + P.rz * nz + P.hoop * per_radius / 4) - stiffness * hourglass_mode[a] * mode_r;
      const double fz = -volume * (P.zr * nr + P.zz * nz) - stiffness * hourglass_mode[a] * mode_z;
      power += fr * view.v_r[corner[a]] + fz * view.v_z[corner[a]];
    }
    energy.last_work = 0.5 * last_step * power;
  }
  return energy;
}

template <class Real>
EnergyLedger stored_energy(const Block<Real>& block, const TargetSolid& solid, int rows) {
  const auto& view = block.view();
  const auto& mesh = block.mesh();
  EnergyLedger energy;
  for (int i = 0; i <= mesh.columns(); ++i)
    for (int j = 0; j <= rows; ++j) {
      const double vr = view.v_r[block.at(i, j)], vz = view.v_z[block.at(i, j)];
      const double kinetic = 0.5 * block.mass(i, j) * (vr * vr + vz * vz);
      (block.has_live_element(i, j) ? energy.live_kinetic : energy.freed_mass) += kinetic;
    }
  for (int i = 0; i < mesh.columns(); ++i)
    for (int j = 0; j < rows; ++j)
      if (view.alive[block.at(i, j)] > 0) {
        const auto element = element_energy(block, solid, i, j, 0);
        energy.elastic += element.elastic;
        energy.hourglass += element.hourglass;
      }
  return energy;
}

template scalar::Gradient<double> element_gradient(const Block<float>&, int, int);
template scalar::Gradient<double> element_gradient(const Block<double>&, int, int);
template ElementEnergy element_energy(const Block<float>&, const TargetSolid&, int, int, double);
template ElementEnergy element_energy(const Block<double>&, const TargetSolid&, int, int, double);
template EnergyLedger stored_energy(const Block<float>&, const TargetSolid&, int);
template EnergyLedger stored_energy(const Block<double>&, const TargetSolid&, int);

}  // namespace percal
