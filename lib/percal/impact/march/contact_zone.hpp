// Where the particle may meet the target, and what happens there once a step: docs/theory/impact.md, "Contact".
#pragma once
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "percal/impact/march/near_cells.hpp"
#include "percal/impact/particle/particle.hpp"
#include "percal/impact/settings.hpp"

namespace percal {

// Nodes around the particle meet it once a short step, the others once a long one. Each of the two keeps the touches of its last
// step.
template <class Real, class ParticleRun>
class ContactZone {
 public:
  ContactZone(Block<Real>& block, const Kernel<Real>& kernel, ParticleRun& particle, double friction_coefficient = 0)
      : block_(block),
        kernel_(kernel),
        particle_(particle),
        friction_coefficient_(friction_coefficient) {
    const auto& x = block_.mesh().radius;
    while (x[columns_.begin] < -search_radius) ++columns_.begin;
    columns_.end = columns_.begin;
    while (columns_.end <= block_.mesh().columns() && x[columns_.end] < search_radius) ++columns_.end;
    seen_.resize(columns_.end);
    for (int i = columns_.begin; i < columns_.end; ++i) seen_[i].found.resize(block_.view().stride + kernel_.lanes);
  }

  ContactColumns columns() const { return columns_; }
  // Upwards, on the particle: of the last steps.
  double force() const { return far_.force + near_.force; }
  double collisions() const { return collisions_; }
  double friction() const { return friction_; }

  // Rows above the first are, and stay until the next search `margin` of depth later, higher than the particle's top; those from
  // lifted_rows_ on are lower than its tip, though they may have been lifted by more than a radius.
  void search(int rows_moving, double margin) {
    const double height = block_.mesh().row_height;
    const double top = particle_.top() - margin, bottom = particle_.tip() + margin;
    const auto& view = block_.view();
    int first = rows_moving;
    lifted_rows_ = 0;
    for (int i = columns_.begin; i < columns_.end; ++i) {
      const auto touches = [&](int j) { return view.touchable[block_.at(i, j)] > 0; };
      const auto depth = [&](int j) { return j * height + view.u_z[block_.at(i, j)]; };
      for (int j = 0; j < first; ++j)
        if (touches(j) && depth(j) > top) first = j;
      for (int j = rows_moving; j >= lifted_rows_; --j)
        if (touches(j) && depth(j) < bottom) lifted_rows_ = j + 1;
    }
    rows_.begin = first / kernel_.lanes * kernel_.lanes;
  }

  // Nodes outside the near cells move over `drift`: open_far before, look_far for each column that has, and close_far, which pushes back
  // those that are inside the particle then. Columns may be looked at side by side.
  void open_far(int rows_moving, double drift) {
    const int deepest = static_cast<int>((particle_.tip() + 1) / block_.mesh().row_height) + 2;
    rows_.end = std::min(rows_moving + 1, std::max(deepest, lifted_rows_));
    open(drift);
  }
  void look_far(const NearCells& near, int column) {
    if (has(column)) between(near.nodes_or_none(column), rows_.end, [&](Rows run) { look(column, run); });
  }
  void close_far(double kick) { close(far_, block_.far_forces(), kick); }

  // The same of the nodes of near cells.
  void open_near(double drift) { open(drift); }
  void look_near(const NearCells& near, int column) {
    if (!has(column)) return;
    for (const Rows& run : near.nodes(column)) look(column, run);
  }
  void close_near(double kick) { close(near_, block_.near_forces(), kick); }

  // Half a kick alone has moved velocities: nodes that pushed in the last steps stay with the particle.
  void hold() {
    for (const Meeting* meeting : {&far_, &near_}) {
      std::vector<Touch> touches;
      particle_.foresee(0);
      for (Touch touch : meeting->touches) {
        if (touch.impulse == 0 || !(block_.view().touchable[touch.node] > 0)) continue;
        touch.impulse = touch.rub = 0;
        touch.now = velocity_along(touch);
        const PointVelocity particle = particle_.velocity_at(touch.x, touch.z);
        touch.rate = touch.away_x * particle.x + touch.away_z * particle.z - touch.now;
        if (touch.rate > 0) touches.push_back(touch);
      }
      particle_.meet(touches, columns_);
      push_nodes(block_.view(), touches, 0);
    }
  }

 private:
  struct Meeting {
    std::vector<Touch> touches;
    double force = 0;
  };

  // In one column.
  struct Seen {
    std::vector<int> found;  // rows: room for all of them
    std::vector<Touch> touches;
  };

  double velocity_along(const Touch& touch) const {
    const auto& view = block_.view();
    return touch.away_x * view.v_r[touch.node] + touch.away_z * view.v_z[touch.node];
  }

  // Impulses along the surface, for those that part() has given across it. The axis holds its nodes from sliding.
  void rub(Meeting& meeting, const NodeForces<Real>& forces, double kick) {
    const auto& view = block_.view();
    for (Touch& touch : meeting.touches) {
      if (block_.mesh().radius[touch.column] == 0 && !block_.is_whole()) continue;
      const double length = std::sqrt(touch.steepness());
      touch.along_x = touch.away_z / length;
      touch.along_z = -touch.away_x / length;
      const double along = touch.along_x * forces.r[touch.node] + touch.along_z * forces.z[touch.node];
      touch.along_now = touch.along_x * view.v_r[touch.node] + touch.along_z * view.v_z[touch.node];
      touch.along_before = touch.along_now - kick * along * view.inverse_mass[touch.node];
    }
    if constexpr (requires { particle_.rub(meeting.touches, columns_, friction_coefficient_); })
      friction_ += particle_.rub(meeting.touches, columns_, friction_coefficient_);
  }

  bool has(int column) const { return column >= columns_.begin && column < columns_.end; }

  void open(double drift) {
    drift_ = drift;
    for (Seen& column : seen_) column.touches.clear();
    particle_.foresee(drift);
  }

  void look(int column, Rows run) {
    const Rows rows{std::max(run.begin, rows_.begin), std::min(run.end, rows_.end)};
    if (rows.empty()) return;
    const auto& mesh = block_.mesh();
    const auto& view = block_.view();
    auto& [found, touches] = seen_[column];
    const int count = particle_.find(kernel_, std::as_const(block_), {column, mesh.radius[column], mesh.row_height, rows},
                                     found.data());
    for (int k = 0; k < count; ++k) {
      const long n = block_.at(column, found[k]);
      Touch touch{.column = column, .node = n, .mass = block_.mass(column, found[k])};
      touch.x = mesh.radius[column] + view.u_r[n];
      touch.z = found[k] * mesh.row_height + view.u_z[n];
      touch.from_x = touch.x - drift_ * view.v_r[n];
      touch.from_z = touch.z - drift_ * view.v_z[n];
      const auto [gap, away_x, away_z] = particle_.overlap(touch.x, touch.z);
      touch.away_x = mesh.radius[column] == 0 && !block_.is_whole() ? 0 : away_x;
      touch.away_z = away_z;
      if (gap <= 0 || touch.steepness() < flattest_way_out) continue;
      touch.rate = gap / drift_;
      touches.push_back(touch);
    }
  }

  void close(Meeting& meeting, const NodeForces<Real>& forces, double kick) {
    const auto& view = block_.view();
    meeting.touches.clear();
    for (const Seen& column : seen_)
      meeting.touches.insert(meeting.touches.end(), column.touches.begin(), column.touches.end());
    for (Touch& touch : meeting.touches) {
      const double along = touch.away_x * forces.r[touch.node] + touch.away_z * forces.z[touch.node];
      touch.now = velocity_along(touch);
      touch.before = touch.now - kick * along * view.inverse_mass[touch.node];
    }
    collisions_ += particle_.meet(meeting.touches, columns_);
    if (friction_coefficient_ > 0) rub(meeting, forces, kick);
    push_nodes(view, meeting.touches, drift_);
    double upwards = 0;
    for (const Touch& touch : meeting.touches) upwards += touch.impulse * touch.away_z + touch.rub * touch.along_z;
    meeting.force = upwards / drift_;
  }

  Block<Real>& block_;
  const Kernel<Real>& kernel_;
  ParticleRun& particle_;
  const double friction_coefficient_;
  ContactColumns columns_;
  Rows rows_{0, 0};
  int lifted_rows_ = 0;
  Meeting far_, near_;
  double drift_ = 0;                      // of the nodes that are looked at
  double collisions_ = 0, friction_ = 0;  // energies
  std::vector<Seen> seen_;                // of each column
};

}  // namespace percal
