#include "percal/impact/outline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace percal {

Point Inside::normal() const {
  Point mean{};
  for (int k = 0; k < ways; ++k)
    for (int d = 0; d < 2; ++d) mean[d] += way[k].normal[d] / ways;
  return mean;
}

void Outline::set(std::vector<Point> points) {
  points_ = std::move(points);
  lowest_ = std::numeric_limits<double>::infinity();
  highest_ = -lowest_;
  for (const Point& point : points_) {
    lowest_ = std::min(lowest_, point[1]);
    highest_ = std::max(highest_, point[1]);
  }
  middle_ = (lowest_ + highest_) / 2;
  reach2_ = 0;
  for (const auto& [x, y] : points_) reach2_ = std::max(reach2_, x * x + (y - middle_) * (y - middle_));
}

// Inside is where a ray away from the axis crosses the outline an odd number of times.
Inside Outline::inside(const Point& point) const {
  Inside found;
  double nearest2 = std::numeric_limits<double>::infinity();
  bool is_inside = false;
  for (std::size_t k = 0; k + 1 < points_.size(); ++k) {
    const Point &from = points_[k], &to = points_[k + 1];
    const double ex = to[0] - from[0], ey = to[1] - from[1], px = point[0] - from[0], py = point[1] - from[1];
    if ((from[1] > point[1]) != (to[1] > point[1])) is_inside ^= px * ey < py * ex == (ey > 0);
    const double share = std::clamp((px * ex + py * ey) / (ex * ex + ey * ey), 0.0, 1.0);
    const double out_x = share * ex - px, out_y = share * ey - py;
    const double distance2 = out_x * out_x + out_y * out_y;
    if (distance2 > nearest2) continue;
    if (distance2 < nearest2) found.ways = 0;
    if (found.ways == 2) continue;
    nearest2 = distance2;
    found.way[found.ways++] = {static_cast<int>(k), share, {out_x, out_y}};
  }
  if (!is_inside || nearest2 == 0) return {};
  found.gap = std::sqrt(nearest2);
  for (int k = 0; k < found.ways; ++k)
    for (double& component : found.way[k].normal) component /= found.gap;
  return found;
}

}  // namespace percal
