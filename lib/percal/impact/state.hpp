// The moving state of a run: nodes, elements and the sphere.
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "percal/impact/kernel.hpp"
#include "percal/mesh/graded.hpp"
#include "percal/problem/problem.hpp"

namespace percal {

// Depth and speed downwards are positive. The tip starts on the surface, at 0.
struct Sphere {
  double tip = 0;
  double speed = 1;
  double mass = 0;  // per radian, as all masses and forces here: (2/3) rho_p/rho_t
  double centre() const { return tip - 1; }
};

// Columns of nodes and elements (kernel.hpp, FieldsView) with their storage. Masses are lumped, a quarter of each element's to
// each corner, and stay on the nodes when elements go.
template <class Real>
class Block {
 public:
  Block(const Problem& problem, const GradedMesh& mesh, double contact_stiffness_per_mass, int lanes);

  const FieldsView<Real>& view() const { return view_; }
  const std::vector<ColumnShape>& shapes() const { return shapes_; }
  const GradedMesh& mesh() const { return mesh_; }
  long at(int column, int row) const { return static_cast<long>(column) * view_.stride + row; }
  double mass(int column, int row) const { return column_mass_[column] * (row == 0 || row == mesh_.rows ? 0.5 : 1); }

  // Takes an element out; calls freed(node column, node row) for each corner that thereby loses its last element, before its
  // contact stiffness is cleared.
  template <class Freed>
  void take_out(int column, int row, Freed freed) {
    view_.alive[at(column, row)] = 0;
    for (int i = column; i <= column + 1; ++i)
      for (int j = row; j <= row + 1; ++j)
        if (--live_elements_[at(i, j)] == 0) {
          freed(i, j);
          view_.contact_stiffness[at(i, j)] = 0;
        }
  }
  bool has_live_element(int column, int row) const { return live_elements_[at(column, row)] > 0; }

 private:
  struct Free {
    void operator()(void* memory) const;
  };
  GradedMesh mesh_;
  std::vector<ColumnShape> shapes_;
  std::vector<double> column_mass_;  // of an inner node of each column
  std::vector<std::uint8_t> live_elements_;
  std::unique_ptr<void, Free> memory_;
  FieldsView<Real> view_;
};

}  // namespace percal
