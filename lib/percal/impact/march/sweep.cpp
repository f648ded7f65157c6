#include "percal/impact/march/sweep.hpp"

#include <algorithm>

namespace percal {
namespace {

template <class Real>
auto plain_forces_of(const Kernel<Real>& kernel, const TargetSolid& solid) -> decltype(kernel.internal_forces) {
  if (!solid.is_plain()) return nullptr;
  return solid.erosion_kind == ErosionKind::averaged_energy ? kernel.internal_forces_averaged : kernel.internal_forces;
}

template <class Real>
void clear(Real* forces, Rows rows) {
  std::fill(forces + rows.begin, forces + rows.end, Real(0));
}

}  // namespace

template <class Real>
Sweep<Real>::Sweep(const Problem& problem, Block<Real>& block, const Kernel<Real>& kernel, const TargetSolid& solid,
                   int threads)
    : block_(block),
      kernel_(kernel),
      solid_(solid),
      plain_forces_(plain_forces_of(kernel, solid_)),
      general_(solid_.view(block)),
      holds_axis_(block.mesh().radius.front() == 0),
      averaged_(problem, block, solid_),
      team_(std::clamp(threads, 1, block.mesh().columns())),
      far_seams_(team_.workers()),
      near_seams_(team_.workers()),
      far_reports_(block.mesh().columns()),
      near_reports_(block.mesh().columns()),
      all_parts_(parts_by(far_reports_, nullptr)),
      near_parts_(all_parts_),
      stiff_(static_cast<std::size_t>(block.mesh().columns()) * (block.view().stride / kernel.lanes + 1)) {
  for (auto* seams : {&far_seams_, &near_seams_})
    for (std::size_t worker = 1; worker < seams->size(); ++worker) {
      (*seams)[worker].r.resize(block.view().stride + kernel.lanes);
      (*seams)[worker].z.resize(block.view().stride + kernel.lanes);
    }
}

template <class Real>
auto Sweep<Real>::parts_by(const std::vector<ColumnReport>& reports, const std::vector<ColumnReport>* more) const
    -> Parts {
  const auto columns = static_cast<int>(reports.size());
  std::vector<long> before{0};  // what the columns before a column cost
  for (int i = 0; i < columns; ++i)
    before.push_back(before.back() + 1 + reports[i].groups + (more ? (*more)[i].groups : 0));
  Parts parts{0};
  for (long worker = 1; worker < team_.workers(); ++worker) {
    const long share = before.back() * worker / team_.workers();
    parts.push_back(static_cast<int>(std::lower_bound(before.begin(), before.end() - 1, share) - before.begin()));
  }
  parts.push_back(columns);
  return parts;
}

template <class Real>
SweepReport Sweep<Real>::all(const NearCells& near, int rows, double last_far_step, double last_step) {
  const int columns = block_.mesh().columns();
  if (team_.workers() > 1) {
    all_parts_ = parts_by(far_reports_, near.empty() ? nullptr : &near_reports_);
    near_parts_ = parts_by(near_reports_, nullptr);
  }
  team_.each([&](int worker) {
    const int begin = all_parts_[worker];
    for (int i = begin; i < all_parts_[worker + 1]; ++i) {
      far_column(i, i == begin, i > 0 ? &far_seams_[worker] : nullptr, near, rows, last_far_step);
      if (!near.empty()) near_column(i, i == begin, i > 0 ? &near_seams_[worker] : nullptr, near, last_step);
    }
  });
  merge(block_.far_forces(), far_seams_, all_parts_, whole_groups(rows));
  if (!near.empty()) merge(block_.near_forces(), near_seams_, all_parts_, whole_groups(rows));

  SweepReport sum;
  for (int i = 0; i < columns; ++i) {
    take_in(far_reports_[i], sum.far_inverse_step, sum);
    if (!near.empty()) take_in(near_reports_[i], sum.near_inverse_step, sum);
    if (far_reports_[i].doomed + (near.empty() ? 0 : near_reports_[i].doomed) > 0) sum.doomed_columns.push_back(i);
    averaged_.judge(block_, i, far_reports_[i].candidates);
    if (!near.empty()) averaged_.judge(block_, i, near_reports_[i].candidates);
  }
  return sum;
}

template <class Real>
SweepReport Sweep<Real>::near_only(const NearCells& near, double last_step) {
  const int columns = block_.mesh().columns();
  team_.each([&](int worker) {
    const int begin = near_parts_[worker];
    for (int i = begin; i < near_parts_[worker + 1]; ++i)
      near_column(i, i == begin, i > 0 ? &near_seams_[worker] : nullptr, near, last_step);
  });
  merge(block_.near_forces(), near_seams_, near_parts_, block_.view().stride - kernel_.lanes);
  SweepReport sum;
  for (int i = 0; i < columns; ++i) {
    take_in(near_reports_[i], sum.near_inverse_step, sum);
    if (near_reports_[i].doomed > 0) sum.doomed_columns.push_back(i);
    averaged_.judge(block_, i, near_reports_[i].candidates);
  }
  return sum;
}

// `seam` is where the first column of a thread that is not the block's first leaves its inner forces.
template <class Real>
ColumnForces<Real> Sweep<Real>::targets(const NodeForces<Real>& forces, int column, bool first, Seam* seam) const {
  const long inner = block_.at(column, 0), outer = block_.at(column + 1, 0);
  const bool apart = first && seam;
  return {apart ? seam->r.data() : forces.r + inner, apart ? seam->z.data() : forces.z + inner, forces.r + outer,
          forces.z + outer, first};
}

template <class Real>
void Sweep<Real>::take(const ColumnForces<Real>& forces, int column, Rows rows, double last_step,
                       ColumnReport& report) {
  unsigned char* flags = stiff_.data() + static_cast<long>(column) * (block_.view().stride / kernel_.lanes + 1);
  const ColumnShape& shape = block_.shapes()[column];
  const StiffnessWatch watch{watched_, flags};
  if (plain_forces_)
    plain_forces_(block_.view(), forces, column, rows, shape, solid_.layers.front().material, last_step, watch, report);
  else
    kernel_.internal_forces_general(block_.view(), forces, column, rows, shape, general_, last_step, watch, report);
}

// Far forces are none where the column's elements are near; the runs between them are set by the kernel.
template <class Real>
void Sweep<Real>::far_column(int column, bool first, Seam* seam, const NearCells& near, int rows, double last_step) {
  const auto forces = targets(block_.far_forces(), column, first, seam);
  far_reports_[column] = {};
  if (near.empty()) return take(forces, column, {0, whole_groups(rows)}, last_step, far_reports_[column]);
  for (const Rows& run : near.elements(column)) {
    clear(forces.outer_r, {run.begin, run.end + kernel_.lanes});
    clear(forces.outer_z, {run.begin, run.end + kernel_.lanes});
    if (!first) continue;
    clear(forces.inner_r, {run.begin, run.end + kernel_.lanes});
    clear(forces.inner_z, {run.begin, run.end + kernel_.lanes});
  }
  between(near.elements(column), whole_groups(rows),
          [&](Rows run) { take(forces, column, run, last_step, far_reports_[column]); });
}

// Near forces are cleared on all nodes that move with near elements, then set by the kernel run by run.
template <class Real>
void Sweep<Real>::near_column(int column, bool first, Seam* seam, const NearCells& near, double last_step) {
  auto forces = targets(block_.near_forces(), column, first, seam);
  near_reports_[column] = {};
  if (first)
    for (const Rows& run : near.nodes(column)) {
      clear(forces.inner_r, run);
      clear(forces.inner_z, run);
    }
  for (const Rows& run : near.nodes(column + 1)) {
    clear(forces.outer_r, run);
    clear(forces.outer_z, run);
  }
  for (const Rows& run : near.elements(column)) take(forces, column, run, last_step, near_reports_[column]);
}

template <class Real>
void Sweep<Real>::merge(const NodeForces<Real>& forces, std::vector<Seam>& seams, const Parts& parts, int rows) {
  for (int worker = 1; worker < team_.workers(); ++worker) {
    if (parts[worker] == parts[worker + 1] || parts[worker] == 0) continue;
    const long start = block_.at(parts[worker], 0);
    Seam& seam = seams[worker];
    for (int j = 0; j < rows + kernel_.lanes; ++j) {
      forces.r[start + j] += seam.r[j];
      forces.z[start + j] += seam.z[j];
    }
    std::fill(seam.r.begin(), seam.r.end(), Real(0));
    std::fill(seam.z.begin(), seam.z.end(), Real(0));
  }
}

template <class Real>
void Sweep<Real>::take_in(const ColumnReport& report, double& inverse_step, SweepReport& sum) const {
  sum.viscous_work += report.viscous_work;
  sum.relaxing_work += report.relaxing_work;
  sum.smallest_jacobian = std::min(sum.smallest_jacobian, report.smallest_jacobian);
  inverse_step = std::max(inverse_step, report.largest_inverse_step);
}

// The last worker moves the last column of nodes, too.
template <class Real>
int Sweep<Real>::end_of_nodes(const Parts& parts, int worker) const {
  return parts[worker + 1] + (worker + 1 == team_.workers() ? 1 : 0);
}

template <class Real>
void Sweep<Real>::move_far(const NearCells& near, int rows, double kick, double drift, const Then& then) {
  team_.each([&](int worker) {
    for (int i = all_parts_[worker]; i < end_of_nodes(all_parts_, worker); ++i) {
      const auto move = [&](Rows run, double far) {
        kernel_.kick_and_drift(block_.view(), block_.far_forces(), i, run, held(i), kick, far);
      };
      between(near.nodes_or_none(i), whole_groups(rows + 1), [&](Rows run) { move(run, drift); });
      for (const Rows& run : near.nodes_or_none(i)) move(run, 0);
      if (then) then(i);
    }
  });
}

template <class Real>
void Sweep<Real>::move_near(const NearCells& near, double kick, double drift, const Then& then) {
  team_.each([&](int worker) {
    for (int i = near_parts_[worker]; i < end_of_nodes(near_parts_, worker); ++i) {
      for (const Rows& run : near.nodes(i))
        kernel_.kick_and_drift(block_.view(), block_.near_forces(), i, run, held(i), kick, drift);
      if (then) then(i);
    }
  });
}

// Column by column, and each node the sum of its two columns, so that the mirrored scene has mirrored bits. Between calls the sums
// are zero.
template <class Real>
void Sweep<Real>::settle(const NearCells& near, const NearCells& before, double late) {
  const int columns = block_.mesh().columns(), lanes = kernel_.lanes;
  const auto& view = block_.view();
  for (Seam* forces : {&cell_inner_, &cell_outer_, &changed_inner_, &changed_outer_, &changed_before_}) {
    forces->r.resize(view.stride + lanes);
    forces->z.resize(view.stride + lanes);
  }
  const Rows none{view.stride, 0};
  Rows span_before = none;  // rows of nodes that the column before has added to
  for (int i = 0; i <= columns; ++i) {
    Rows span = none;
    if (i < columns)
      near.differences(before, i, [&](int row) {
        span = {std::min(span.begin, row), row + lanes + 1};
        ColumnReport report;
        take({cell_inner_.r.data(), cell_inner_.z.data(), cell_outer_.r.data(), cell_outer_.z.data(), true}, i,
             {row, row + lanes}, 0, report);
        const Real sign = near.has(i, row) ? 1 : -1;
        for (int j = row; j <= row + lanes; ++j) {
          changed_inner_.r[j] += sign * cell_inner_.r[j];
          changed_inner_.z[j] += sign * cell_inner_.z[j];
          changed_outer_.r[j] += sign * cell_outer_.r[j];
          changed_outer_.z[j] += sign * cell_outer_.z[j];
        }
      });
    const Rows both{std::min(span.begin, span_before.begin), std::max(span.end, span_before.end)};
    for (int j = both.begin; j < both.end; ++j) {
      const long n = block_.at(i, j);
      const Real kick = view.inverse_mass[n] * static_cast<Real>(late);
      if (!held(i)) view.v_r[n] += (changed_before_.r[j] + changed_inner_.r[j]) * kick;
      view.v_z[n] += (changed_before_.z[j] + changed_inner_.z[j]) * kick;
    }
    std::swap(changed_before_, changed_outer_);
    if (!both.empty())
      for (Seam* forces : {&changed_inner_, &changed_outer_}) {
        clear(forces->r.data(), both);
        clear(forces->z.data(), both);
      }
    span_before = span;
  }
}

template <class Real>
void Sweep<Real>::add_stiff(NearCells& near) {
  const long groups = block_.view().stride / kernel_.lanes + 1;
  for (std::size_t k = 0; k < stiff_.size(); ++k)
    if (stiff_[k]) {
      near.add(static_cast<int>(k / groups), static_cast<int>(k % groups) * kernel_.lanes);
      stiff_[k] = 0;
    }
}

template class Sweep<float>;
template class Sweep<double>;

}  // namespace percal
