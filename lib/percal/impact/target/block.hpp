// The moving state of the target: nodes and elements.
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "percal/impact/kernel/kernel.hpp"
#include "percal/mesh/graded.hpp"
#include "percal/problem/problem.hpp"

namespace percal {

// Which rows of elements belong to one layer, and what it is made of.
struct LayerRows {
  int begin, end;
  double density;  // over the first layer's
};

// Numbers that a block keeps for each element or node, besides a byte.
int fields_per_element(const Problem& problem);

// Columns of nodes and elements (kernel.hpp, FieldsView) with their storage. Masses are lumped, a quarter of each
// element's to each corner, and stay on the nodes when elements go.
template <class Real>
class Block {
 public:
  Block(const Problem& problem, const GradedMesh& mesh, int lanes);

  // Only who holds a block that is not const may write to its fields; others look.
  const FieldsView<Real>& view() { return view_; }
  const FieldsView<const Real>& view() const { return look_; }
  // Forces of the elements that take the long step, and of those that take the short one with the particle's.
  const NodeForces<Real>& far_forces() { return far_; }
  NodeForces<const Real> far_forces() const { return {far_.r, far_.z}; }
  const NodeForces<Real>& near_forces() { return near_; }
  // What only some targets need (TargetSolid); null where this one does not.
  const HourglassView<Real>& hourglass_velocity() { return hourglass_velocity_; }
  const RelaxationView<Real>& relaxation() { return relaxation_; }
  int relaxing_terms() const { return relaxation_.terms; }
  TensorField<const Real> overstress(int term) const {
    const TensorField<Real>& H = relaxation_.overstress[term];
    return {H.rr, H.rz, H.zz, H.hoop};
  }
  const std::vector<ColumnShape>& shapes() const { return shapes_; }
  const std::vector<LayerRows>& layers() const { return layers_; }
  const GradedMesh& mesh() const { return mesh_; }
  bool is_whole() const { return mesh_.radius.front() < 0; }
  long at(int column, int row) const { return static_cast<long>(column) * view_.stride + row; }
  double mass(int column, int row) const { return column_mass_[column] * row_density_[row]; }
  ColumnMasses masses(int column) const {
    return {column_mass_[column], row_density_.data(), live_elements_.data() + at(column, 0)};
  }
  std::size_t bytes() const { return bytes_; }

  // Displacements and velocities of all nodes, to be put back to the last bit.
  std::vector<Real> motion() const;
  void put_back(const std::vector<Real>& motion);

  // Takes an element out. Nodes that thereby lose their last one meet the particle no more unless `keep_contact`.
  void take_out(int column, int row, bool keep_contact) {
    view_.alive[at(column, row)] = 0;
    for (int i = column; i <= column + 1; ++i)
      for (int j = row; j <= row + 1; ++j)
        if (--live_elements_[at(i, j)] == 0 && !keep_contact) view_.touchable[at(i, j)] = 0;
  }
  bool has_live_element(int column, int row) const { return live_elements_[at(column, row)] > 0; }

 private:
  struct Free {
    void operator()(void* memory) const;
  };
  void allocate(int lanes, const Problem& problem);
  void fill(const Problem& problem);

  GradedMesh mesh_;
  std::vector<ColumnShape> shapes_;
  std::vector<LayerRows> layers_;
  std::vector<double> column_mass_;  // of an inner node of each column at density 1
  std::vector<double> row_density_;  // mean density of the two elements above and below a node; 0 outside and behind
  std::vector<std::uint8_t> live_elements_;
  std::size_t entries_ = 0, bytes_ = 0;
  std::unique_ptr<void, Free> memory_;
  FieldsView<Real> view_;
  FieldsView<const Real> look_;  // the same
  NodeForces<Real> far_, near_;
  HourglassView<Real> hourglass_velocity_;
  RelaxationView<Real> relaxation_;
  std::vector<double> looked_at_;
};

}  // namespace percal
