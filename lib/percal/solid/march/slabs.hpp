// One pass over the slabs of a block: internal forces, or motion, on one or more threads. Sums are taken slab by slab in their order,
// and each node's force is a sum of the same pairs, so that the bits do not depend on the number of threads.
#pragma once
#include <vector>

#include "percal/impact/march/team.hpp"
#include "percal/solid/target/block.hpp"
#include "percal/solid/target/solid_of.hpp"

namespace percal {

struct SlabReport : ColumnReport {
  std::vector<int> doomed_columns;  // j of those that have elements with alive below 0
};

template <class Real>
class Slabs {
 public:
  Slabs(SolidBlock<Real>& block, const SolidKernel<Real>& kernel, const TargetSolid& solid, int threads);

  // Forces of all elements down to row `rows`; the reports of the slabs in their order.
  const std::vector<SlabReport>& find_forces(int rows, double last_step);
  // v += kick f/m, u += drift v.
  void move(int rows, double kick, double drift);

  int whole_groups(int rows) const { return (rows + kernel_.lanes - 1) / kernel_.lanes * kernel_.lanes; }
  double helper_cpu_seconds() const { return team_.helper_cpu_seconds(); }

 private:
  using Column = std::array<std::vector<Real>, 3>;
  // What a worker keeps between columns and, in `seam`, the inner forces of its first slab until all are done.
  struct Bench {
    std::array<Column, 2> carried;
    std::vector<Real> seam;  // of each column and component
  };
  void slab(int i, bool first_of_worker, Bench& bench, int rows, double last_step);
  void merge(int rows);

  SolidBlock<Real>& block_;
  const SolidKernel<Real>& kernel_;
  const TargetSolid solid_;
  const LayeredSolidView view_;  // of solid_
  Team team_;
  std::vector<int> parts_;  // worker w takes the slabs from parts_[w] to parts_[w + 1]
  std::vector<Bench> benches_;
  std::vector<SlabReport> reports_;
};

}  // namespace percal
