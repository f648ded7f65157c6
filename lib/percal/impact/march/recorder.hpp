// Keeps the penetration history: nothing at all, or about as many evenly spaced points as asked for. A point is made
// only where it is kept, for its energies take a walk over the mesh.
#pragma once
#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "percal/impact/result.hpp"

namespace percal {

// Keeps every stride-th point; when there are twice as many as asked for, every second one goes and the stride doubles.
class Recorder {
 public:
  // Few runs take fewer long steps; the points of the first of them would all be made only to go again.
  static constexpr long usual_steps = 1600;

  explicit Recorder(int samples)
      : most_(2 * static_cast<std::size_t>(samples)), stride_(std::max(1L, usual_steps / std::max(samples, 1))) {}

  // Asked at every long step: whether its point is to be kept.
  bool is_due() { return most_ > 0 && seen_++ % stride_ == 0; }
  void keep(const HistoryPoint& point) {
    points_.push_back(point);
    if (points_.size() < most_) return;
    std::size_t kept = 0;
    for (std::size_t k = 0; k < points_.size(); k += 2) points_[kept++] = points_[k];
    points_.resize(kept);
    stride_ *= 2;
  }
  // The last point, kept whatever the stride.
  void finish(const HistoryPoint& point) {
    if (most_ == 0) return;
    if (!points_.empty() && points_.back().time == point.time) points_.pop_back();
    points_.push_back(point);
  }
  std::vector<HistoryPoint> take() { return std::move(points_); }

 private:
  std::size_t most_;
  long seen_ = 0, stride_;
  std::vector<HistoryPoint> points_;
};

}  // namespace percal
