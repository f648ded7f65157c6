#include "percal/solid/target/contents.hpp"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "percal/solid/kernel/kernel.hpp"

namespace percal {
namespace {

using scalar::hex::Corners8;
using scalar::hex::Modes;
using scalar::hex::Tensor;

// Modes of each component of a field of nodes.
template <class Real>
std::array<Modes<double>, 3> modes_at(const SolidBlock<Real>& block, const std::array<const Real*, 3>& field, int i,
                                      int j, int k) {
  const auto nodes = block.nodes_of(i, j);
  std::array<Modes<double>, 3> modes;
  for (int component = 0; component < 3; ++component) {
    Corners8<double> corners;
    for (int c = 0; c < 4; ++c) {
      corners.upper[c] = field[component][nodes[c] + k];
      corners.lower[c] = field[component][nodes[c] + k + 1];
    }
    modes[component] = scalar::hex::modes_of(corners);
  }
  return modes;
}

// Inverse sides and volume of an element.
struct Brick {
  double per_x, per_y, per_z, volume;
};
template <class Real>
Brick brick_at(const SolidBlock<Real>& block, int i, int j, int k) {
  const auto [width_x, width_y] = block.shape(i, j);
  const double height = block.grid().z[k + 1] - block.grid().z[k];
  return {1 / width_x, 1 / width_y, 1 / height, width_x * width_y * height};
}

Tensor<double> gradient_of(const std::array<Modes<double>, 3>& m, const Brick& brick) {
  const double x = brick.per_x / 4, y = brick.per_y / 4, z = brick.per_z / 4;
  return {m[0].x * x + 1, m[0].y * y, m[0].z * z, m[1].x * x,    m[1].y * y + 1,
          m[1].z * z,     m[2].x * x, m[2].y * y, m[2].z * z + 1};
}

template <class Real>
int layer_of(const SolidBlock<Real>& block, int row) {
  const auto own = [row](const LayerRows& layer) { return row < layer.end; };
  return static_cast<int>(std::ranges::find_if(block.layers(), own) - block.layers().begin());
}

// Of a live element; z upwards.
template <class Real>
CellState state_of(const SolidBlock<Real>& block, const TargetSolid& solid, int i, int j, int k) {
  const MaterialConstants& material = solid.of_row(k);
  const auto F = whole_gradient(block, solid, i, j, k);
  const auto d = scalar::hex::deformation_of(F);
  const auto tau = kirchhoff(material, F, d);
  Eigen::Matrix3d b;
  b << d.B.xx, d.B.xy, d.B.xz, d.B.xy, d.B.yy, d.B.yz, d.B.xz, d.B.yz, d.B.zz;
  const Eigen::Vector3d squares = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(b).eigenvalues().array() + d.mean;
  CellState state{.energy_density = energy_density(material, F)};
  for (int p = 0; p < 3; ++p) state.stretches[p] = std::sqrt(std::max(0.0, squares[2 - p]));
  state.stress = {tau.xx, tau.yy, tau.zz, tau.xy, -tau.yz, -tau.xz};
  for (double& component : state.stress) component *= d.inverse_jacobian;
  return state;
}

}  // namespace

template <class Real>
Tensor<double> element_gradient(const SolidBlock<Real>& block, int i, int j, int k) {
  return gradient_of(modes_at(block, block.fields().u, i, j, k), brick_at(block, i, j, k));
}

template <class Real>
Tensor<double> whole_gradient(const SolidBlock<Real>& block, const TargetSolid& solid, int i, int j, int k) {
  const auto F = element_gradient(block, i, j, k);
  const InitialStretch& initial = solid.of_row(k).initial;
  const double x = initial.r, y = initial.hoop, z = initial.z;
  return {F.xx * x, F.xy * y, F.xz * z, F.yx * x, F.yy * y, F.yz * z, F.zx * x, F.zy * y, F.zz * z};
}

template <class Real>
Criterion leading_criterion(const SolidBlock<Real>& block, const TargetSolid& solid, int i, int j, int k) {
  const auto shares = shares_of_limits(solid, k, whole_gradient(block, solid, i, j, k));
  return static_cast<Criterion>(std::ranges::max_element(shares) - shares.begin());
}

template <class Real>
bool take_initial_state(SolidBlock<Real>& block, const TargetSolid& solid) {
  bool whole = true;
  for (int k = 0; k < block.grid().rows(); ++k) {
    const InitialStretch& initial = solid.of_row(k).initial;
    const double measure = erosion_measure(solid, k, gradient_of_stretch(initial));
    whole &= measure < solid.limit_of(solid.of_row(k));
    for (int i = 0; i < block.slabs(); ++i)
      for (int j = 0; j < block.columns_y(); ++j) {
        block.fields().jacobian[block.at(i, j, k)] = static_cast<Real>(initial.jacobian());
        block.fields().erosion_measure[block.at(i, j, k)] = static_cast<Real>(measure);
      }
  }
  return whole;
}

template <class Real>
ElementEnergy element_energy(const SolidBlock<Real>& block, const TargetSolid& solid, int i, int j, int k,
                             double last_step) {
  const MaterialConstants& material = solid.of_row(k);
  const Brick brick = brick_at(block, i, j, k);
  const auto u = modes_at(block, block.fields().u, i, j, k), v = modes_at(block, block.fields().v, i, j, k);
  const InitialStretch& initial = material.initial;
  const double unstretched_volume = brick.volume / initial.jacobian();
  const auto F = whole_gradient(block, solid, i, j, k);
  const auto P = first_piola(material, F);
  const auto spring =
      scalar::hex::hourglass_stiffness(material.hourglass * material.mu * brick.volume, brick.per_x * brick.per_x,
                                       brick.per_y * brick.per_y, brick.per_z * brick.per_z);
  const auto sprung = [&](const Modes<double>& a, const Modes<double>& b) {
    return spring.xy * a.xy * b.xy + spring.xz * a.xz * b.xz + spring.yz * a.yz * b.yz + spring.xyz * a.xyz * b.xyz;
  };
  const auto along = [&](const Modes<double>& m, double x, double y, double z) {
    return (x * m.x * brick.per_x * initial.r + y * m.y * brick.per_y * initial.hoop +
            z * m.z * brick.per_z * initial.z) /
           4;
  };
  ElementEnergy energy{.elastic = unstretched_volume * energy_density(material, F)};
  if (!initial.is_none()) energy.elastic -= unstretched_volume * energy_density(material, gradient_of_stretch(initial));
  double power = -unstretched_volume *
                 (along(v[0], P.xx, P.xy, P.xz) + along(v[1], P.yx, P.yy, P.yz) + along(v[2], P.zx, P.zy, P.zz));
  for (int component = 0; component < 3; ++component) {
    energy.hourglass += 0.5 * sprung(u[component], u[component]);
    power -= sprung(u[component], v[component]);
  }
  energy.last_work = 0.5 * last_step * power;
  return energy;
}

template <class Real>
EnergyLedger stored_energy(const SolidBlock<Real>& block, const TargetSolid& solid, int rows) {
  const LayeredSolidView view = view_of(solid);
  EnergyLedger ledger;
  const auto& fields = block.fields();
  const auto& kernel = solid_kernel<Real>();
  for (int i = 0; i <= block.slabs(); ++i)
    for (int j = 0; j <= block.columns_y(); ++j) {
      const long first = block.column(i, j);
      double live = 0, freed = 0;
      for (int k = 0; k <= rows; ++k) {
        double twice = 0;
        for (const Real* v : fields.v) twice += block.mass(i, j, k) * v[first + k] * v[first + k];
        (block.has_live_element(first + k) ? live : freed) += 0.5 * twice;
      }
      ledger.live_kinetic += live;
      ledger.freed_mass += freed;
      if (i == block.slabs() || j == block.columns_y()) continue;
      const StoredEnergy stored =
          kernel.stored_energy(fields, block.nodes_of(i, j), rows, block.shape(i, j), block.heights(), view);
      ledger.elastic += stored.elastic;
      ledger.hourglass += stored.hourglass;
    }
  return ledger;
}

template <class Real>
double momentum(const SolidBlock<Real>& block) {
  double sum = 0;
  for (int i = 0; i <= block.slabs(); ++i)
    for (int j = 0; j <= block.columns_y(); ++j)
      for (int k = 0; k <= block.grid().rows(); ++k)
        sum += block.mass(i, j, k) * block.fields().v[2][block.at(i, j, k)];
  return sum;
}

template <class Real>
TargetPiece cut_piece(const SolidBlock<Real>& block, const TargetSolid& solid) {
  TargetPiece piece;
  const auto& grid = block.grid();
  const auto& fields = block.fields();
  const int rows = grid.rows(), middle = static_cast<int>(std::ranges::lower_bound(grid.y, 0.0) - grid.y.begin());
  for (int i = 0; i <= block.slabs(); ++i)
    for (int k = 0; k <= rows; ++k) {
      const long n = block.at(i, middle, k);
      const Point u{static_cast<double>(fields.u[0][n]), -static_cast<double>(fields.u[2][n])};
      piece.position.push_back({grid.x[i] + u[0], u[1] - grid.z[k]});
      piece.displacement.push_back(u);
      piece.velocity.push_back({static_cast<double>(fields.v[0][n]), -static_cast<double>(fields.v[2][n])});
    }
  for (int i = 0; i < block.slabs(); ++i)
    for (int k = 0; k < rows; ++k) {
      const int upper = i * (rows + 1) + k, beside = upper + rows + 1;
      for (const int corner : {upper + 1, beside + 1, beside, upper}) piece.corners.push_back(corner);
      piece.ends.push_back(static_cast<int>(piece.corners.size()));
      const bool eroded = !(fields.alive[block.at(i, middle, k)] > 0);
      piece.eroded.push_back(eroded ? 1 : 0);
      piece.layer.push_back(layer_of(block, k));
      piece.volume.push_back((grid.x[i + 1] - grid.x[i]) * (grid.z[k + 1] - grid.z[k]));
      CellState state;
      if (!eroded) {
        state = state_of(block, solid, i, middle, k);
        auto& [xx, yy, zz, xy, yz, xz] = state.stress;  // of the cut: x, up, out of the plane
        std::swap(yy, zz);
        std::swap(xy, xz);
      }
      piece.states.push_back(state);
    }
  return piece;
}

template <class Real>
SpaceTarget space_piece(const SolidBlock<Real>& block, const TargetSolid& solid) {
  SpaceTarget piece;
  const auto& grid = block.grid();
  const auto& fields = block.fields();
  const int rows = grid.rows(), across = block.columns_y() + 1;
  for (int i = 0; i <= block.slabs(); ++i)
    for (int j = 0; j < across; ++j)
      for (int k = 0; k <= rows; ++k) {
        const long n = block.at(i, j, k);
        const auto upwards = [n](const std::array<const Real*, 3>& f) {
          return SpacePoint{f[0][n], f[1][n], -static_cast<double>(f[2][n])};
        };
        const SpacePoint u = upwards(fields.u);
        piece.position.push_back({grid.x[i] + u[0], grid.y[j] + u[1], u[2] - grid.z[k]});
        piece.displacement.push_back(u);
        piece.velocity.push_back(upwards(fields.v));
      }
  const auto node = [&](int i, int j, int k) { return (i * across + j) * (rows + 1) + k; };
  for (int i = 0; i < block.slabs(); ++i)
    for (int j = 0; j < block.columns_y(); ++j)
      for (int k = 0; k < rows; ++k) {
        for (const int level : {k + 1, k})
          for (const auto& [x, y] : {std::pair(i, j), {i + 1, j}, {i + 1, j + 1}, {i, j + 1}})
            piece.corners.push_back(node(x, y, level));
        piece.ends.push_back(static_cast<int>(piece.corners.size()));
        const bool eroded = !(fields.alive[block.at(i, j, k)] > 0);
        piece.eroded.push_back(eroded ? 1 : 0);
        piece.layer.push_back(layer_of(block, k));
        piece.volume.push_back(brick_at(block, i, j, k).volume / solid.of_row(k).initial.jacobian());
        piece.states.push_back(eroded ? CellState{} : state_of(block, solid, i, j, k));
      }
  return piece;
}

template Tensor<double> element_gradient(const SolidBlock<float>&, int, int, int);
template Tensor<double> element_gradient(const SolidBlock<double>&, int, int, int);
template ElementEnergy element_energy(const SolidBlock<float>&, const TargetSolid&, int, int, int, double);
template ElementEnergy element_energy(const SolidBlock<double>&, const TargetSolid&, int, int, int, double);
template EnergyLedger stored_energy(const SolidBlock<float>&, const TargetSolid&, int);
template EnergyLedger stored_energy(const SolidBlock<double>&, const TargetSolid&, int);
template Tensor<double> whole_gradient(const SolidBlock<float>&, const TargetSolid&, int, int, int);
template Criterion leading_criterion(const SolidBlock<float>&, const TargetSolid&, int, int, int);
template bool take_initial_state(SolidBlock<float>&, const TargetSolid&);
template double momentum(const SolidBlock<float>&);
template Tensor<double> whole_gradient(const SolidBlock<double>&, const TargetSolid&, int, int, int);
template Criterion leading_criterion(const SolidBlock<double>&, const TargetSolid&, int, int, int);
template bool take_initial_state(SolidBlock<double>&, const TargetSolid&);
template double momentum(const SolidBlock<double>&);
template TargetPiece cut_piece(const SolidBlock<float>&, const TargetSolid&);
template TargetPiece cut_piece(const SolidBlock<double>&, const TargetSolid&);
template SpaceTarget space_piece(const SolidBlock<float>&, const TargetSolid&);
template SpaceTarget space_piece(const SolidBlock<double>&, const TargetSolid&);

}  // namespace percal
