#include "percal/impact/frame.hpp"

#include <algorithm>
#include <cmath>

#include "percal/impact/ledger.hpp"
#include "percal/impact/relaxing_stress.hpp"
#include "percal/impact/volumetric_law.hpp"

namespace percal {
namespace {

// What has not relaxed yet: overstress of the Prony series on top of the share that lasts, docs/theory/target.md (6).
template <class Real>
scalar::Piola<double> unrelaxed(const RelaxationView<Real>& relaxation, long element,
                                const scalar::Gradient<double>& F) {
  scalar::Symmetric<double> overstress{};
  for (int k = 0; k < relaxation.terms; ++k) {
    const TensorField<Real>& h = relaxation.overstress[k];
    overstress = overstress + scalar::Symmetric<double>{h.rr[element], h.rz[element], h.zz[element], h.hoop[element]};
  }
  return scalar::pushed(F, overstress);
}

template <class Real>
CellState state_of(const Block<Real>& block, const TargetSolid& solid, int column, int row) {
  const MaterialConstants& material = solid.of_row(row);
  const auto F = element_gradient(block, column, row);
  const auto s = scalar::stretches(F);
  const auto g = scalar::isochoric_powers(F, s, material.alpha);
  const double J = s.jacobian, alpha = material.alpha, mu = material.mu * solid.lasting_share();
  auto P = scalar::first_piola(F, s, scalar::isochoric_stress(g, 2 * mu / alpha),
                               scalar::kirchhoff_pressure(solid.pressure_law, J, material.bulk));
  const auto more = unrelaxed(block.relaxation(), block.at(column, row), F);
  P = {P.rr + more.rr, P.rz + more.rz, P.zr + more.zr, P.zz + more.zz, P.hoop + more.hoop};
  CellState state = cell_state(F, P,
                               2 * mu / (alpha * alpha) * (g.first + g.second + g.hoop - 3) +
                                   scalar::volumetric_energy(solid.pressure_law, J, material.bulk));
  state.stress[3] = 0 - state.stress[3];  // z is downwards, y upwards
  return state;
}

}  // namespace

CellState cell_state(const scalar::Gradient<double>& F, const scalar::Piola<double>& P, double energy_density) {
  const auto s = scalar::stretches(F);
  const auto tau = scalar::kirchhoff(F, P);
  const double J = s.jacobian;
  CellState state{.stretches = {std::sqrt(s.first2), std::sqrt(s.second2), F.hoop},
                  .stress = {tau.rr / J, tau.zz / J, tau.hoop / J, tau.rz / J},
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
      piece.volume.push_back(shape.thickness * shape.width * shape.height);
    }
  }
  return piece;
}

template TargetPiece target_piece(const Block<float>&, const TargetSolid&);
template TargetPiece target_piece(const Block<double>&, const TargetSolid&);

}  // namespace percal
