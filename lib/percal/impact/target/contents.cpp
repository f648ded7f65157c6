#include "percal/impact/target/contents.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "percal/impact/kernel/general_solid.hpp"
#include "percal/impact/target/initial_stretch.hpp"

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

ElasticSolid instantaneous_solid(const TargetSolid& solid, int row) {
  const MaterialConstants& material = solid.of_row(row);
  return {{material.mu, material.bulk, material.alpha, solid.pressure_law}, material.fibres};
}

// When all that can relax has relaxed.
ElasticSolid lasting_solid(const TargetSolid& solid, int row) {
  ElasticSolid lasting = instantaneous_solid(solid, row);
  lasting.matrix.mu *= solid.lasting_share();
  return lasting;
}

// What has not relaxed yet: overstress of the Prony series on top of the share that lasts, docs/theory/target.md (6).
template <class Real>
scalar::Piola<double> unrelaxed(const Block<Real>& block, long element, const scalar::Gradient<double>& F) {
  scalar::Symmetric<double> overstress{};
  for (int k = 0; k < block.relaxing_terms(); ++k) {
    const TensorField<const Real> H = block.overstress(k);
    overstress = overstress + scalar::Symmetric<double>{H.rr[element], H.rz[element], H.zz[element], H.hoop[element]};
  }
  return scalar::pushed(F, overstress);
}

// Over the unstretched solid.
template <class Real>
scalar::Gradient<double> whole_gradient(const Block<Real>& block, const TargetSolid& solid, int column, int row) {
  const InitialStretch& initial = solid.of_row(row).initial;
  const auto F = element_gradient(block, column, row);
  return {F.rr * initial.r, F.rz * initial.z, F.zr * initial.r, F.zz * initial.z, F.hoop * initial.hoop};
}

template <class Real>
CellState state_of(const Block<Real>& block, const TargetSolid& solid, int column, int row) {
  const ElasticSolid lasting = lasting_solid(solid, row);
  const auto F = whole_gradient(block, solid, column, row);
  const auto P = lasting.first_piola(F) + unrelaxed(block, block.at(column, row), F);
  CellState state = cell_state(F, P, lasting.energy_density(F));
  state.stress[3] = 0 - state.stress[3];  // z is downwards, y upwards
  return state;
}

// What erosion can be judged by.
struct Measures {
  double squared_stretch, tension, energy;  // the energy as if nothing had relaxed
  // (lambda^2 - 1), tension and energy over their limits.
  std::array<double, 3> over(const MaterialConstants& limits) const {
    const scalar::SharesOfLimits per = scalar::per_limits(limits);
    return {(squared_stretch - 1) * per.stretch, tension * per.stress, energy * per.energy};
  }
};

template <class Real>
Measures measures_of(const Block<Real>& block, const TargetSolid& solid, int column, int row) {
  const CellState state = state_of(block, solid, column, row);
  const auto& [rr, zz, hoop, rz, r_hoop, z_hoop] = state.stress;
  return {state.stretches[0] * state.stretches[0], std::max(0.5 * (rr + zz) + std::hypot(0.5 * (rr - zz), rz), hoop),
          instantaneous_solid(solid, row).energy_density(whole_gradient(block, solid, column, row))};
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
  const ElasticSolid lasting = lasting_solid(solid, row);
  const auto& view = block.view();
  const auto& shape = block.shapes()[column];
  const auto corner = corners_of(block, column, row);
  const double width = shape.width, height = shape.height, thickness = shape.thickness, per_radius = shape.per_radius,
               volume = thickness * width * height;

  const InitialStretch& initial = solid.of_row(row).initial;
  const double unstretched_volume = volume / initial.jacobian();
  const auto F = whole_gradient(block, solid, column, row);
  double mode_r = 0, mode_z = 0;
  for (int a = 0; a < 4; ++a) {
    mode_r += hourglass_mode[a] * view.u_r[corner[a]];
    mode_z += hourglass_mode[a] * view.u_z[corner[a]];
  }
  const double stiffness =
      solid.hourglass_kind == HourglassKind::stiffness ? scalar::hourglass_stiffness(solid.of_row(row), shape) : 0;
  ElementEnergy energy;
  energy.elastic = unstretched_volume * lasting.energy_density(F);
  if (!initial.is_none()) energy.elastic -= unstretched_volume * lasting.energy_density(gradient_of(initial));
  energy.hourglass = 0.5 * stiffness * (mode_r * mode_r + mode_z * mode_z);
  if (last_step > 0) {
    const auto P = lasting.first_piola(F);
    double power = 0;
    for (int a = 0; a < 4; ++a) {
      const double nr = initial.r * along_r[a] / width, nz = initial.z * along_z[a] / height,
                   nh = initial.hoop * per_radius / 4;
      const double fr =
          -unstretched_volume * (P.rr * nr + P.rz * nz + P.hoop * nh) - stiffness * hourglass_mode[a] * mode_r;
      const double fz = -unstretched_volume * (P.zr * nr + P.zz * nz) - stiffness * hourglass_mode[a] * mode_z;
      power += fr * view.v_r[corner[a]] + fz * view.v_z[corner[a]];
    }
    energy.last_work = 0.5 * last_step * power;
  }
  return energy;
}

template <class Real>
double erosion_measure(const Block<Real>& block, const TargetSolid& solid, int column, int row) {
  const Measures measures = measures_of(block, solid, column, row);
  switch (solid.erosion_kind) {
    case ErosionKind::stretch: return measures.squared_stretch;
    case ErosionKind::stress: return measures.tension;
    case ErosionKind::several: {
      const auto [strain, stress, energy] = measures.over(solid.of_row(row));
      return std::max({strain, stress, energy});
    }
    case ErosionKind::energy:
    case ErosionKind::averaged_energy: break;
  }
  return measures.energy;
}

template <class Real>
Criterion leading_criterion(const Block<Real>& block, const TargetSolid& solid, int column, int row) {
  const auto [strain, stress, energy] = measures_of(block, solid, column, row).over(solid.of_row(row));
  if (strain >= std::max(stress, energy)) return Criterion::strain;
  return stress >= energy ? Criterion::stress : Criterion::energy;
}

template <class Real>
EnergyLedger stored_energy(const Block<Real>& block, const TargetSolid& solid, int rows) {
  const auto& view = block.view();
  const Kernel<Real>& lanes = kernel<Real>();
  const int columns = block.mesh().columns();
  const bool is_plain = solid.is_plain();
  EnergyLedger energy;
  for (int i = 0; i <= columns; ++i) {
    const KineticEnergy kinetic = lanes.kinetic_energy(view, i, rows + 1, block.masses(i));
    energy.live_kinetic += kinetic.live;
    energy.freed_mass += kinetic.freed;
  }
  const auto add = [&](const auto& stored) {
    energy.elastic += stored.elastic;
    energy.hourglass += stored.hourglass;
  };
  for (int i = 0; i < columns; ++i) {
    if (is_plain) {
      add(lanes.stored_energy(view, i, rows, block.shapes()[i], solid.layers.front().material));
      continue;
    }
    for (int j = 0; j < rows; ++j)
      if (view.alive[block.at(i, j)] > 0) add(element_energy(block, solid, i, j, 0));
  }
  return energy;
}

CellState cell_state(const scalar::Gradient<double>& F, const scalar::Piola<double>& P, double energy_density) {
  const auto s = scalar::stretches(F);
  const auto tau = scalar::kirchhoff(F, P);
  const double J = s.jacobian;
  CellState state{.stretches = {std::sqrt(s.first2), std::sqrt(s.second2), F.hoop},
                  .stress = {tau.rr / J, tau.zz / J, tau.hoop / J, tau.rz / J, 0, 0},
                  .energy_density = energy_density};
  std::sort(state.stretches.rbegin(), state.stretches.rend());
  return state;
}

template <class Real>
TargetPiece target_piece(const Block<Real>& block, const TargetSolid& solid) {
  const GradedMesh& mesh = block.mesh();
  const auto& view = block.view();
  TargetPiece piece;
  for (int i = 0; i <= mesh.columns(); ++i)
    for (int j = 0; j <= mesh.rows; ++j) {
      const long n = block.at(i, j);
      const Point u{view.u_r[n], -view.u_z[n]};
      piece.position.push_back({mesh.radius[i] + u[0], -j * mesh.row_height + u[1]});
      piece.displacement.push_back(u);
      piece.velocity.push_back({view.v_r[n], -view.v_z[n]});
    }
  const auto point = [&](int i, int j) { return i * (mesh.rows + 1) + j; };
  for (int i = 0; i < mesh.columns(); ++i) {
    const ColumnShape& shape = block.shapes()[i];
    for (int j = 0; j < mesh.rows; ++j) {
      for (const int corner : {point(i, j + 1), point(i + 1, j + 1), point(i + 1, j), point(i, j)})
        piece.corners.push_back(corner);
      piece.ends.push_back(static_cast<int>(piece.corners.size()));
      const bool eroded = !(view.alive[block.at(i, j)] > 0);
      piece.eroded.push_back(eroded);
      piece.states.push_back(eroded ? CellState{} : state_of(block, solid, i, j));
      int layer = 0;
      while (j >= block.layers()[layer].end) ++layer;
      piece.layer.push_back(layer);
      piece.volume.push_back(shape.thickness * shape.width * shape.height / solid.of_row(j).initial.jacobian());
    }
  }
  return piece;
}

template scalar::Gradient<double> element_gradient(const Block<float>&, int, int);
template scalar::Gradient<double> element_gradient(const Block<double>&, int, int);
template ElementEnergy element_energy(const Block<float>&, const TargetSolid&, int, int, double);
template ElementEnergy element_energy(const Block<double>&, const TargetSolid&, int, int, double);
template double erosion_measure(const Block<float>&, const TargetSolid&, int, int);
template double erosion_measure(const Block<double>&, const TargetSolid&, int, int);
template Criterion leading_criterion(const Block<float>&, const TargetSolid&, int, int);
template Criterion leading_criterion(const Block<double>&, const TargetSolid&, int, int);
template EnergyLedger stored_energy(const Block<float>&, const TargetSolid&, int);
template EnergyLedger stored_energy(const Block<double>&, const TargetSolid&, int);
template TargetPiece target_piece(const Block<float>&, const TargetSolid&);
template TargetPiece target_piece(const Block<double>&, const TargetSolid&);

}  // namespace percal
