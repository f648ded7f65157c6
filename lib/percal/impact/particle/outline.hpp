// The deformed outline of an elastic particle, and the shortest way out of it for a node that has got inside.
#pragma once
#include <array>
#include <vector>

#include "percal/mesh/quads.hpp"

namespace percal {

// Across one edge. The gap is a function of the point and of the edge's two ends; these are its derivatives, by the point with
// the sign changed. They sum to nothing, so that forces along them come of one energy and balance.
struct WayOut {
  int edge = 0;
  double share = 0;  // where on the edge, from its first end
  Point away{};
  std::array<Point, 2> by_end{};
};

// Of one point.
struct Inside {
  double gap = 0;  // to the outline; 0 outside
  int ways = 0;    // 2 where two edges are equally near: half of the push goes each way
  std::array<WayOut, 2> way{};

  // Mean of the ways, all but a unit vector.
  Point away() const;
};

// Points from the axis x = 0 at the bottom to the axis at the top, the particle on the left of each edge and x >= 0. Edges are parabolas that
// stand out in the middle by the share `bulge` of their length: as chords of a circle at tan(angle/4)/2.
class Outline {
 public:
  explicit Outline(double bulge = 0) : bulge_(bulge) {}
  void set(std::vector<Point> points);
  const std::vector<Point>& points() const { return points_; }
  double lowest() const { return lowest_; }
  double highest() const { return highest_; }

  // Whether the point lies in the smallest circle about the middle of the axis that holds the points: cheap to ask first.
  bool may_hold(const Point& point) const {
    const double up = point[1] - middle_;
    return point[0] * point[0] + up * up < reach2_;
  }
  Inside inside(const Point& point) const;

 private:
  bool surrounds(const Point& point) const;

  double bulge_;
  std::vector<Point> points_;
  double lowest_ = 0, highest_ = 0, middle_ = 0, reach2_ = 0;
};

}  // namespace percal
