// One pass over the columns of a block: internal forces, or motion, on one or more threads. Sums are taken column by
// column in their order, so that the bits do not depend on the number of threads. Nobody else writes to the block's
// fields, but for what the march takes out or puts back.
#pragma once
#include <functional>
#include <vector>

#include "percal/impact/march/near_cells.hpp"
#include "percal/impact/march/team.hpp"
#include "percal/impact/target/averaged_erosion.hpp"
#include "percal/impact/target/block.hpp"
#include "percal/impact/target/constants.hpp"

namespace percal {

struct SweepReport {
  double viscous_work = 0, relaxing_work = 0;
  double far_inverse_step = 0, near_inverse_step = 0;  // largest 1/dt of the stable step
  double smallest_jacobian = 1e30;
  std::vector<int> doomed_columns;  // that have elements with alive below 0; ascending
};

template <class Real>
class Sweep {
 public:
  Sweep(const Problem& problem, Block<Real>& block, const Kernel<Real>& kernel, const TargetSolid& solid, int threads);

  // The time of the displacements, for what follows. Only what relaxes looks at it.
  void set_time(double time) { general_.time = time; }
  // Sets the far forces by the elements outside the near cells down to row `rows`, the near forces by those in them.
  SweepReport all(const NearCells& near, int rows, double last_far_step, double last_step);
  // Sets the near forces again.
  SweepReport near_only(const NearCells& near, double last_step);

  // Nodes outside the near cells: v += kick f/m, u += drift v by the far forces; the others are only kicked.
  // then(column): called for each column of nodes that has moved, by the worker that moved it.
  using Then = std::function<void(int column)>;
  void move_far(const NearCells& near, int rows, double kick, double drift, const Then& then = {});
  // Nodes of the near cells, by the near forces.
  void move_near(const NearCells& near, double kick, double drift, const Then& then = {});

  // Cells that are near and were not get what their forces do to the velocities in `late`; those that were and are not lose it.
  // After a sweep, where nothing has moved since.
  void settle(const NearCells& near, const NearCells& before, double late);

  // From here on cells with an element whose 1/dt is above `inverse_step` are remembered; add_stiff adds those seen since the
  // last call.
  void watch(double inverse_step) { watched_ = inverse_step; }
  void add_stiff(NearCells& near);

  double helper_cpu_seconds() const { return team_.helper_cpu_seconds(); }

  int whole_groups(int rows) const { return (rows + kernel_.lanes - 1) / kernel_.lanes * kernel_.lanes; }

 private:
  // Inner forces of a thread's first column stay apart until all are done.
  struct Seam {
    std::vector<Real> r, z;
  };
  // Which columns fall to which worker: those from parts[worker] to parts[worker + 1].
  using Parts = std::vector<int>;
  // As even as may be, by what each column cost at its last sweep.
  Parts parts_by(const std::vector<ColumnReport>& reports, const std::vector<ColumnReport>* more) const;
  int end_of_nodes(const Parts& parts, int worker) const;
  void far_column(int column, bool first, Seam* seam, const NearCells& near, int rows, double last_step);
  void near_column(int column, bool first, Seam* seam, const NearCells& near, double last_step);
  void take(const ColumnForces<Real>& forces, int column, Rows rows, double last_step, ColumnReport& report);
  ColumnForces<Real> targets(const NodeForces<Real>& forces, int column, bool first, Seam* seam) const;
  void merge(const NodeForces<Real>& forces, std::vector<Seam>& seams, const Parts& parts, int rows);
  void take_in(const ColumnReport& report, double& inverse_step, SweepReport& sum) const;
  bool held(int column) const { return holds_axis_ && column == 0; }

  Block<Real>& block_;
  const Kernel<Real>& kernel_;
  const TargetSolid solid_;
  const decltype(Kernel<Real>::internal_forces) plain_forces_;  // null where solid_ is not plain
  GeneralSolidView<Real> general_;                              // of solid_; used where it is not plain
  const bool holds_axis_;  // the first column of nodes stands on an axis or a plane of symmetry
  const AveragedErosion<Real> averaged_;
  Team team_;
  std::vector<Seam> far_seams_, near_seams_;  // of threads 1, 2, ...
  std::vector<ColumnReport> far_reports_, near_reports_;
  Parts all_parts_, near_parts_;  // of the block, of its near cells
  Seam cell_inner_, cell_outer_, changed_inner_, changed_outer_, changed_before_;  // of settle()
  double watched_ = 1e30;
  std::vector<unsigned char> stiff_;  // of cells, column after column
};

}  // namespace percal
