// Where a body may meet the target in three dimensions, and what happens there once a step: docs/theory/impact.md, "Contact".
#pragma once
#include <algorithm>
#include <vector>

#include "percal/impact/settings.hpp"
#include "percal/solid/particle/body.hpp"

namespace percal {

template <class Real, class Body>
class SpaceContact {
 public:
  SpaceContact(SolidBlock<Real>& block, const SolidKernel<Real>& kernel, Body& body)
      : block_(block), kernel_(kernel), body_(body) {
    found_.resize(block_.fields().stride + kernel_.lanes);
  }

  double force() const { return force_; }  // upwards, on the body, in the last step
  double collisions() const { return collisions_; }

  // Columns and rows that the body may meet until the next search, `margin` of way later. Rows as in ContactZone::search().
  void search(int rows_moving, double margin) {
    const auto& grid = block_.grid();
    const double reach = body_.reach() + beside_ + margin;
    along_x_ = range(grid.x, body_.sideways() - reach, body_.sideways() + reach);
    along_y_ = range(grid.y, 0, body_.half_thickness() + beside_);
    const double top = body_.top() - margin, bottom = body_.tip() + margin;
    int first = rows_moving, behind = 0;
    each_column([&](int i, int j) {
      const long column = block_.column(i, j);
      const auto depth = [&](int k) { return grid.z[k] + block_.fields().u[2][column + k]; };
      for (int k = 0; k < first; ++k)
        if (touches(column + k) && depth(k) > top) first = k;
      for (int k = rows_moving; k >= behind; --k)
        if (touches(column + k) && depth(k) < bottom) behind = k + 1;
    });
    rows_ = {first / kernel_.lanes * kernel_.lanes, behind};
  }

  // Nodes have been moved over `drift` behind a kick by their forces; those that are inside the body then are pushed back.
  void close(double kick, double drift) {
    body_.foresee(drift);
    touches_.clear();
    columns_ = {};
    each_column([&](int i, int j) { look(i, j, drift); });
    for (Touch& touch : touches_) {
      const auto& f = block_.fields().f;
      const double along =
          touch.away_x * f[0][touch.node] + touch.away_y * f[1][touch.node] + touch.away_z * f[2][touch.node];
      touch.now = velocity_along(touch);
      touch.before = touch.now - kick * along * block_.fields().inverse_mass[touch.node];
    }
    collisions_ += body_.meet(touches_, columns_);
    push(drift);
    double upwards = 0;
    for (const Touch& touch : touches_) upwards += touch.impulse * touch.away_z;
    force_ = upwards / drift;
  }

  // Half a kick alone has moved velocities: nodes that pushed in the last step stay with the body.
  void hold() {
    std::vector<Touch> last;
    last.swap(touches_);
    body_.foresee(0);
    for (Touch touch : last) {
      if (touch.impulse == 0 || !touches(touch.node)) continue;
      touch.impulse = 0;
      touch.now = velocity_along(touch);
      const PointVelocity body = body_.velocity_at(touch.x, touch.z);
      touch.rate = touch.away_x * body.x + touch.away_z * body.z - touch.now;
      if (touch.rate > 0) touches_.push_back(touch);
    }
    body_.meet(touches_, columns_);
    push(0);
    touches_.swap(last);
  }

 private:
  static constexpr double beside_ = search_radius - 1;  // radii beside the body

  static ContactColumns range(const std::vector<double>& planes, double low, double high) {
    const auto place = [&](auto at) { return static_cast<int>(at - planes.begin()); };
    return {place(std::ranges::lower_bound(planes, low)), place(std::ranges::upper_bound(planes, high))};
  }
  template <class Work>
  void each_column(const Work& work) const {
    for (int i = along_x_.begin; i < along_x_.end; ++i)
      for (int j = along_y_.begin; j < along_y_.end; ++j) work(i, j);
  }

  bool touches(long node) const { return block_.has_live_element(node) && block_.fields().inverse_mass[node] > 0; }

  double velocity_along(const Touch& touch) const {
    const auto& v = block_.fields().v;
    return touch.away_x * v[0][touch.node] + touch.away_y * v[1][touch.node] + touch.away_z * v[2][touch.node];
  }

  void look(int i, int j, double drift) {
    if (rows_.empty()) return;
    const auto& grid = block_.grid();
    const SolidBlock<Real>& block = block_;
    const int count = body_.find(kernel_, block, block_.contact_nodes(i, j, rows_), found_.data());
    const auto held = block_.held(i, j);
    bool some = false;
    for (int q = 0; q < count; ++q) {
      const int k = found_[q];
      const long n = block_.at(i, j, k);
      if (!touches(n)) continue;
      const auto& u = block.fields().u;
      const std::array<double, 3> at{grid.x[i] + u[0][n], grid.y[j] + u[1][n], grid.z[k] + u[2][n]};
      const auto [gap, normal] = body_.overlap(at);
      Touch touch{.column = columns_.end, .node = n, .mass = block_.mass(i, j, k)};
      touch.x = at[0];
      touch.z = at[2];
      touch.away_x = held[0] ? 0 : normal[0];
      touch.away_y = held[1] ? 0 : normal[1];
      touch.away_z = normal[2];
      if (gap <= 0 || touch.steepness() < flattest_way_out) continue;
      touch.rate = gap / drift;
      touches_.push_back(touch);
      some = true;
    }
    columns_.end += some ? 1 : 0;
  }

  void push(double drift) {
    const auto& fields = block_.fields();
    for (const Touch& touch : touches_) {
      if (touch.impulse == 0) continue;
      const double by = touch.impulse / touch.mass;
      const std::array<double, 3> change{by * touch.away_x, by * touch.away_y, by * touch.away_z};
      for (int d = 0; d < 3; ++d) {
        fields.v[d][touch.node] += static_cast<Real>(change[d]);
        fields.u[d][touch.node] += static_cast<Real>(change[d] * drift);
      }
    }
  }

  SolidBlock<Real>& block_;
  const SolidKernel<Real>& kernel_;
  Body& body_;
  ContactColumns along_x_, along_y_;
  Rows rows_{0, 0};
  std::vector<int> found_;
  std::vector<Touch> touches_;  // of the last step
  ContactColumns columns_;      // that have touches, counted in their order
  double force_ = 0, collisions_ = 0;
};

}  // namespace percal
