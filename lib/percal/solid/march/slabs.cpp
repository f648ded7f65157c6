#include "percal/solid/march/slabs.hpp"

#include <algorithm>

#include "percal/solid/march/flushed.hpp"

namespace percal {

template <class Real>
Slabs<Real>::Slabs(SolidBlock<Real>& block, const SolidKernel<Real>& kernel, const TargetSolid& solid, int threads)
    : block_(block),
      kernel_(kernel),
      solid_(solid),
      view_(view_of(solid_)),
      team_(std::clamp(threads, 1, block.slabs())),
      benches_(team_.workers()),
      reports_(block.slabs()) {
  for (int worker = 0; worker <= team_.workers(); ++worker) parts_.push_back(block.slabs() * worker / team_.workers());
  const int stride = block_.fields().stride;
  for (Bench& bench : benches_) {
    for (Column& column : bench.carried)
      for (auto& component : column) component.resize(stride);
    if (&bench != &benches_.front()) bench.seam.resize(3L * (block_.columns_y() + 1) * stride);
  }
}

template <class Real>
const std::vector<SlabReport>& Slabs<Real>::find_forces(int rows, double last_step) {
  team_.each([&](int worker) {
    const Flushed flushed;
    for (int i = parts_[worker]; i < parts_[worker + 1]; ++i)
      slab(i, i == parts_[worker], benches_[worker], rows, last_step);
  });
  merge(rows);
  return reports_;
}

// The inner forces of the last column of nodes are what the last column of elements has carried on.
template <class Real>
void Slabs<Real>::slab(int i, bool first_of_worker, Bench& bench, int rows, double last_step) {
  const auto& fields = block_.fields();
  const int columns = block_.columns_y(), end = whole_groups(rows) + kernel_.lanes;
  const bool apart = first_of_worker && i > 0;
  const auto inner = [&](int component, int j) {
    return apart ? bench.seam.data() + (3L * j + component) * fields.stride : fields.f[component] + block_.column(i, j);
  };
  SlabReport& report = reports_[i] = {};
  for (int j = 0; j < columns; ++j) {
    SlabForces<Real> forces{.adds = !first_of_worker, .outer_adds = j > 0};
    for (int d = 0; d < 3; ++d) {
      forces.inner[d] = inner(d, j);
      forces.from_before[d] = j > 0 ? bench.carried[j % 2][d].data() : nullptr;
      forces.to_next[d] = bench.carried[(j + 1) % 2][d].data();
      forces.outer[d] = fields.f[d] + block_.column(i + 1, j);
      forces.outer_next[d] = fields.f[d] + block_.column(i + 1, j + 1);
    }
    const int doomed = report.doomed;
    const Rows all{0, whole_groups(rows)};
    if (solid_.is_plain())
      kernel_.internal_forces(fields, block_.nodes_of(i, j), forces, all, block_.shape(i, j), block_.heights(),
                              solid_.layers.front().material, last_step, report);
    else
      kernel_.internal_forces_layered(fields, block_.nodes_of(i, j), forces, all, block_.shape(i, j), block_.heights(),
                                      view_, last_step, report);
    if (report.doomed > doomed) report.doomed_columns.push_back(j);
  }
  for (int d = 0; d < 3; ++d) {
    const Real* carried = bench.carried[columns % 2][d].data();
    Real* last = inner(d, columns);
    for (int k = 0; k < end; ++k) last[k] = first_of_worker ? carried[k] : last[k] + carried[k];
  }
}

template <class Real>
void Slabs<Real>::merge(int rows) {
  const int end = whole_groups(rows) + kernel_.lanes;
  for (int worker = 1; worker < team_.workers(); ++worker)
    for (int j = 0; j <= block_.columns_y(); ++j)
      for (int d = 0; d < 3; ++d) {
        const Real* seam = benches_[worker].seam.data() + (3L * j + d) * block_.fields().stride;
        Real* f = block_.fields().f[d] + block_.column(parts_[worker], j);
        for (int k = 0; k < end; ++k) f[k] += seam[k];
      }
}

template <class Real>
void Slabs<Real>::move(int rows, double kick, double drift) {
  team_.each([&](int worker) {
    const Flushed flushed;
    const int end =
        parts_[worker + 1] + (worker + 1 == team_.workers() ? 1 : 0);  // the last one moves the last nodes, too
    for (int i = parts_[worker]; i < end; ++i)
      for (int j = 0; j <= block_.columns_y(); ++j)
        kernel_.kick_and_drift(block_.fields(), block_.column(i, j), {0, whole_groups(rows + 1)}, block_.held(i, j),
                               kick, drift);
  });
}

template class Slabs<float>;
template class Slabs<double>;

}  // namespace percal
