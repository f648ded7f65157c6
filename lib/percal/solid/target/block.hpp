// The moving state of a target in three dimensions: nodes and elements of its columns.
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "percal/impact/target/constants.hpp"
#include "percal/mesh/box.hpp"
#include "percal/problem/problem.hpp"
#include "percal/solid/kernel/kernel.hpp"

namespace percal {

// Columns of nodes and elements (SolidFields) with their storage. Masses are lumped, an eighth of each element's to each corner, and
// stay on the nodes when elements go.
template <class Real>
class SolidBlock {
 public:
  SolidBlock(const Problem& problem, int lanes);

  const SolidFields<Real>& fields() { return fields_; }
  const SolidFields<const Real>& fields() const { return look_; }
  const BoxGrid& grid() const { return grid_; }
  const RowHeights<Real>& heights() const { return heights_; }
  const std::vector<LayerRows>& layers() const { return layers_; }

  int columns_y() const { return grid_.columns_y(); }
  int slabs() const { return grid_.columns_x(); }  // of elements, one for each i
  long column(int i, int j) const { return (static_cast<long>(i) * (columns_y() + 1) + j) * fields_.stride; }
  long at(int i, int j, int k) const { return column(i, j) + k; }
  // The four columns of nodes around a column of elements.
  std::array<long, 4> nodes_of(int i, int j) const {
    return {column(i, j), column(i + 1, j), column(i, j + 1), column(i + 1, j + 1)};
  }
  BoxColumn shape(int i, int j) const { return {grid_.x[i + 1] - grid_.x[i], grid_.y[j + 1] - grid_.y[j]}; }
  ColumnNodes contact_nodes(int i, int j, Rows rows) const {
    return {column(i, j), grid_.x[i], grid_.y[j], grid_.z.data(), below_, rows};
  }
  double mass(int i, int j, int k) const { return share_x_[i] * share_y_[j] * share_z_[k]; }

  // What a plane of symmetry keeps from moving: nodes of x = 0 along x, of y = 0 along y.
  std::array<bool, 3> held(int i, int j) const {
    return {i == 0 && grid_.x.front() == 0, j == 0 && grid_.y.front() == 0, false};
  }

  // Displacements and velocities of all nodes, to be put back to the last bit.
  std::vector<Real> motion() const;
  void put_back(const std::vector<Real>& motion);

  void take_out(int i, int j, int k);
  bool has_live_element(long node) const { return live_elements_[node] > 0; }

 private:
  struct Free {
    void operator()(void* memory) const;
  };
  void allocate(int lanes);
  void fill(const Problem& problem);

  BoxGrid grid_;
  std::vector<LayerRows> layers_;
  // Half the widths of the elements beside a plane of nodes; of z times their densities.
  std::vector<double> share_x_, share_y_, share_z_;
  std::vector<std::uint8_t> live_elements_;  // of each node
  std::size_t entries_ = 0;
  std::unique_ptr<void, Free> memory_;
  SolidFields<Real> fields_;
  SolidFields<const Real> look_;  // the same
  RowHeights<Real> heights_;
  Real* below_ = nullptr;  // ColumnNodes::below
};

}  // namespace percal
