// The deformed outline of an elastic particle, and the shortest way out of it for a node that has got inside.
#pragma once
#include <array>
#include <vector>

#include "percal/mesh/quads.hpp"

namespace percal {

// To the nearest place on an edge, `share` of its length from its first point, along a unit vector.
struct WayOut {
  int edge = 0;
  double share = 0;
  Point normal{};
};

// Of one point. The gap is a function of the point and of the outline's points; its derivatives are -normal by the former, and
// normal times the edge's two shares by the latter. So forces along them come of one energy, and balance.
struct Inside {
  double gap = 0;  // distance to the outline; 0 outside
  int ways = 0;    // 2 where two edges are equally near: half of the push goes each way
  std::array<WayOut, 2> way{};

  // Mean of the ways.
  Point normal() const;
};

// Points from the axis x = 0 at the bottom to the axis at the top, the particle on the left of each edge and x >= 0.
class Outline {
 public:
  void set(std::vector<Point> points);
  const std::vector<Point>& points() const { return points_; }
  double lowest() const { return lowest_; }
  double highest() const { return highest_; }

  // Whether the point lies in the smallest circle about the middle of the axis that holds the outline: cheap to ask first.
  bool may_hold(const Point& point) const {
    const double up = point[1] - middle_;
    return point[0] * point[0] + up * up < reach2_;
  }
  Inside inside(const Point& point) const;

 private:
  std::vector<Point> points_;
  double lowest_ = 0, highest_ = 0, middle_ = 0, reach2_ = 0;
};

}  // namespace percal
