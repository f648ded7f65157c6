#include "percal/impact/particle/outline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace percal {
namespace {

double squared_distance(const Point& a, const Point& b) {
  return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]);
}

}  // namespace

Point Inside::away() const {
  Point mean{};
  for (int k = 0; k < ways; ++k)
    for (int d = 0; d < 2; ++d) mean[d] += way[k].away[d] / ways;
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
  double longest2 = 0;
  reach2_ = 0;
  for (std::size_t k = 0; k < points_.size(); ++k) {
    const auto& [x, y] = points_[k];
    reach2_ = std::max(reach2_, x * x + (y - middle_) * (y - middle_));
    if (k > 0) longest2 = std::max(longest2, squared_distance(points_[k - 1], points_[k]));
  }
  const double reach = std::sqrt(reach2_) + bulge_ * std::sqrt(longest2);
  reach2_ = reach * reach;
}

// The polygon: where a ray away from the axis crosses it an odd number of times.
bool Outline::surrounds(const Point& point) const {
  bool is_inside = false;
  for (std::size_t k = 0; k + 1 < points_.size(); ++k) {
    const Point &from = points_[k], &to = points_[k + 1];
    const double ex = to[0] - from[0], ey = to[1] - from[1], px = point[0] - from[0], py = point[1] - from[1];
    const bool is_upward = to[1] > point[1];
    if ((from[1] > point[1]) != is_upward && (px * ey < py * ex) == is_upward) is_inside = !is_inside;
  }
  return is_inside;
}

// With t along an edge of length L, n outwards, s the share and d the distance to the chord, inwards positive, the gap is
//   G = d + 4 bulge L s (1 - s),   dd/dx = -n,   ds/dx = t/L.
// Beyond the ends of an edge a point inside has its distance to the end.
Inside Outline::inside(const Point& point) const {
  const bool in_polygon = surrounds(point);
  Inside found;
  const auto take = [&](double gap, const WayOut& way) {
    if (!(gap > 0)) return;
    const bool is_nearer = found.ways == 0 || gap < found.gap;
    if (!is_nearer && (gap != found.gap || found.ways == 2)) return;
    if (is_nearer) found.ways = 0;
    found.gap = gap;
    found.way[found.ways++] = way;
  };
  for (std::size_t k = 0; k + 1 < points_.size(); ++k) {
    const Point &from = points_[k], &to = points_[k + 1];
    const double ex = to[0] - from[0], ey = to[1] - from[1], px = point[0] - from[0], py = point[1] - from[1];
    const double squared = ex * ex + ey * ey, s = (px * ex + py * ey) / squared;
    const int edge = static_cast<int>(k);
    if (s > 0 && s < 1) {
      const double length = std::sqrt(squared), tx = ex / length, ty = ey / length, nx = ty, ny = -tx;
      const double d = -(nx * px + ny * py);
      if ((d >= 0) != in_polygon) continue;
      const double stand = 4 * bulge_ * s * (1 - s), tilt = 4 * bulge_ * (1 - 2 * s), turn = tilt * d / length;
      const double first = (1 - s) + turn, last = s - turn, first_along = -tilt * (1 - s) - stand,
                   last_along = stand - tilt * s;
      take(d + stand * length, {edge,
                                s,
                                {nx - tilt * tx, ny - tilt * ty},
                                {Point{first * nx + first_along * tx, first * ny + first_along * ty},
                                 Point{last * nx + last_along * tx, last * ny + last_along * ty}}});
    } else if (in_polygon) {
      const int end = s >= 1;
      const double distance = std::sqrt(squared_distance(point, points_[k + end]));
      const Point away{(points_[k + end][0] - point[0]) / distance, (points_[k + end][1] - point[1]) / distance};
      take(distance, {edge, double(end), away, {end == 0 ? away : Point{}, end == 0 ? Point{} : away}});
    }
  }
  return found;
}

}  // namespace percal
