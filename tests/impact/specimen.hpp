// A piece of a target under prescribed strain, looked at by the general kernel: what options of the solid are tested
// on.
#pragma once
#include <cmath>
#include <random>

#include "percal/impact/target/constants.hpp"
#include "percal/impact/target/contents.hpp"

namespace percal {

// Three radii wide, 37 rows, so that no group of lanes ends with the column. Without bulk viscosity.
inline Problem specimen_problem() {
  Problem p;
  p.pi4 = 0.5;
  p.density_ratio = 16.8;
  p.alpha = 8.5;
  p.bulk_ratio = 10;
  p.depth = 37.0 / 3;
  p.width = 3;
  p.elements_per_radius = 3;
  p.graded_columns = 2;
  p.geometry = Geometry::plane_strain;
  p.linear_viscosity = p.quadratic_viscosity = 0;
  p.rates = 1;
  return p;
}

template <class Real = double>
class StrainedTarget {
 public:
  explicit StrainedTarget(const Problem& problem)
      : kernel_(percal::kernel<Real>()),
        block(problem, mesh_of(problem), kernel_.lanes),
        solid(problem, block.layers()),
        view_(solid.view(block)) {}

  // Every node to F x: stretches along r and z, shear of z over r. The hoop stretches with r in axisymmetry.
  void stretch(double along_r, double along_z, double shear = 0) {
    for (int i = 0; i <= block.mesh().columns(); ++i)
      for (int j = 0; j <= block.mesh().rows; ++j) {
        const double r = block.mesh().radius[i], z = j * block.mesh().row_height;
        block.view().u_r[block.at(i, j)] = Real((along_r - 1) * r);
        block.view().u_z[block.at(i, j)] = Real((along_z - 1) * z + shear * r);
      }
  }

  // One look of the kernel at all columns, `step` after the last one.
  ColumnReport look(double step) {
    view_.time += step;
    return sweep([&](const ColumnForces<Real>& forces, int i, Rows rows, ColumnReport& report) {
      kernel_.internal_forces_general(block.view(), forces, i, rows, block.shapes()[i], view_, step, watch(), report);
    });
  }
  // The same by the kernel of the plain solid.
  ColumnReport look_as_plain(double step) {
    return sweep([&](const ColumnForces<Real>& forces, int i, Rows rows, ColumnReport& report) {
      const auto plain = solid.erosion_kind == ErosionKind::averaged_energy ? kernel_.internal_forces_averaged
                                                                            : kernel_.internal_forces;
      plain(block.view(), forces, i, rows, block.shapes()[i], solid.layers.front().material, step, watch(), report);
    });
  }

  // First Piola stress of the corner element where there is no shear: its corner node has its force alone.
  double stress_r() const {
    return block.far_forces().r[0] * 2 / (block.shapes()[0].height * block.shapes()[0].thickness);
  }
  double stress_z() const {
    return block.far_forces().z[0] * 2 / (block.shapes()[0].width * block.shapes()[0].thickness);
  }
  double volume() const { return block.mesh().radius.back() * block.mesh().row_height * block.mesh().rows; }

 private:
  template <class Look>
  ColumnReport sweep(Look look) {
    const auto& forces = block.far_forces();
    const int end = (block.mesh().rows + kernel_.lanes - 1) / kernel_.lanes * kernel_.lanes;
    ColumnReport report;
    for (int i = 0; i < block.mesh().columns(); ++i) {
      const long inner = block.at(i, 0), outer = block.at(i + 1, 0);
      look(ColumnForces<Real>{forces.r + inner, forces.z + inner, forces.r + outer, forces.z + outer, i == 0}, i,
           Rows{0, end}, report);
    }
    return report;
  }
  StiffnessWatch watch() { return {1e30, flags_.data()}; }

  const Kernel<Real>& kernel_;
  std::vector<unsigned char> flags_ = std::vector<unsigned char>(1000);

 public:
  Block<Real> block;
  const TargetSolid solid;

 private:
  GeneralSolidView<Real> view_;
};

// Principal Kirchhoff stress (2 mu/alpha)(g_1 - mean g) of the isochoric solid with stretches l, by the formula.
inline double isochoric_stress_of(double mu, double alpha, double l1, double l2, double l3) {
  const double scale = std::pow(l1 * l2 * l3, -1.0 / 3);
  const double g1 = std::pow(scale * l1, alpha), g2 = std::pow(scale * l2, alpha), g3 = std::pow(scale * l3, alpha);
  return 2 * mu / alpha * (g1 - (g1 + g2 + g3) / 3);
}

// Positions and velocities of every node, the axis' but downwards; the same each time.
template <class Real>
void displace_at_random(Block<Real>& block, double amount) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-amount, amount);
  for (int i = 0; i <= block.mesh().columns(); ++i)
    for (int j = 0; j <= block.mesh().rows; ++j) {
      const long n = block.at(i, j);
      block.view().u_r[n] = i == 0 ? Real(0) : Real(uniform(random));
      block.view().u_z[n] = Real(uniform(random));
      block.view().v_r[n] = i == 0 ? Real(0) : Real(uniform(random));
      block.view().v_z[n] = Real(uniform(random));
    }
}

}  // namespace percal
