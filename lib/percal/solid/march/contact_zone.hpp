// Where a body may meet the target in three dimensions, and what happens there once a step: docs/theory/impact.md, "Contact".
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <vector>

#include "percal/impact/settings.hpp"
#include "percal/solid/particle/body.hpp"

namespace percal {

template <class Real, class Body>
class SpaceContact {
 public:
  SpaceContact(SolidBlock<Real>& block, const SolidKernel<Real>& kernel, Body& body, double friction_coefficient)
      : block_(block), kernel_(kernel), body_(body), friction_coefficient_(friction_coefficient) {
    found_.resize(block_.fields().stride + kernel_.lanes);
  }

  double force() const { return force_; }  // upwards, on the body, in the last step
  double collisions() const { return collisions_; }
  double friction() const { return friction_; }

  // Columns and rows that the body may meet until the next search, `margin` of way later. Rows as in ContactZone::search().
  void search(int rows_moving, double margin) {
    const auto& grid = block_.grid();
    const double reach = body_.reach() + beside_ + margin;
    along_x_ = range(grid.x, body_.sideways() - reach, body_.sideways() + reach);
    const auto [nearest, farthest] = body_.along_y(margin);
    along_y_ = range(grid.y, nearest - beside_, farthest + beside_);
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
      const Space away = away_of(touch);
      touch.now = dot(away, velocity_of(touch));
      touch.before = touch.now - kicked_along(touch, away, kick);
    }
    collisions_ += body_.meet(touches_, columns_);
    if (friction_coefficient_ > 0) rub(kick);
    push(drift);
    double upwards = 0;
    for (const Touch& touch : touches_) upwards += touch.impulse * touch.away_z + touch.rub * touch.along_z;
    force_ = upwards / drift;
  }

  // Half a kick alone has moved velocities: nodes that pushed in the last step stay with the body.
  void hold() {
    std::vector<Touch> last;
    last.swap(touches_);
    body_.foresee(0);
    for (Touch touch : last) {
      if (touch.impulse == 0 || !touches(touch.node)) continue;
      touch.impulse = touch.rub = 0;
      touch.now = dot(away_of(touch), velocity_of(touch));
      touch.rate = dot(away_of(touch), body_.velocity_at(place_of(touch))) - touch.now;
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

  using Space = std::array<double, 3>;
  static double dot(const Space& a, const Space& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  static Space away_of(const Touch& touch) { return {touch.away_x, touch.away_y, touch.away_z}; }
  static Space place_of(const Touch& touch) { return {touch.x, touch.y, touch.z}; }
  static Space at_node(const std::array<Real*, 3>& field, long node) {
    return {field[0][node], field[1][node], field[2][node]};
  }
  Space velocity_of(const Touch& touch) const { return at_node(block_.fields().v, touch.node); }
  // What the step's forces have changed of a node's velocity in a direction.
  double kicked_along(const Touch& touch, const Space& direction, double kick) const {
    return kick * dot(direction, at_node(block_.fields().f, touch.node)) * block_.fields().inverse_mass[touch.node];
  }

  // Impulses along the surface, against the node's sliding, for those that have one across it. What a plane of symmetry holds does not
  // slide across it: neither its velocity nor its way out has such a component.
  void rub(double kick) {
    for (Touch& touch : touches_) {
      const Space away = away_of(touch), velocity = velocity_of(touch);
      Space sliding = body_.velocity_at(place_of(touch));
      for (int d = 0; d < 3; ++d) sliding[d] -= velocity[d];
      const double across = dot(sliding, away) / touch.steepness();
      for (int d = 0; d < 3; ++d) sliding[d] -= across * away[d];
      const double speed = std::sqrt(dot(sliding, sliding));
      if (speed == 0) continue;
      for (double& component : sliding) component /= speed;
      std::tie(touch.along_x, touch.along_y, touch.along_z) = std::tie(sliding[0], sliding[1], sliding[2]);
      touch.along_now = dot(sliding, velocity);
      touch.along_before = touch.along_now - kicked_along(touch, sliding, kick);
    }
    friction_ += body_.rub(touches_, columns_, friction_coefficient_);
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
      std::tie(touch.x, touch.y, touch.z) = std::tie(at[0], at[1], at[2]);
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
      const double by = touch.impulse / touch.mass, along = touch.rub / touch.mass;
      const Space change{by * touch.away_x + along * touch.along_x, by * touch.away_y + along * touch.along_y,
                         by * touch.away_z + along * touch.along_z};
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
  const double friction_coefficient_;
  double force_ = 0;
  double collisions_ = 0, friction_ = 0;  // energies
};

}  // namespace percal
