// Which elements the average of the energy around them lets go: docs/theory/impact.md (23). Every candidate of a look is judged
// by the same moment before any of them goes.
#pragma once
#include <vector>

#include "percal/impact/target/block.hpp"
#include "percal/impact/target/constants.hpp"

namespace percal {

// The bell (1 - d^2/length^2)^2 of the distance d, 0 from `length` on, averaged over the ring of radius `ring` about the axis, as
// seen from a point at distance `radius` from the axis and `apart` above or below the ring. Any one unit.
double bell_of_ring(double radius, double ring, double apart, double length);

// Of a block and a solid whose erosion is judged so, averaged_energy; of others empty.
template <class Real>
class AveragedErosion {
 public:
  AveragedErosion(const Problem& problem, const Block<Real>& block, const TargetSolid& solid);

  // Condemns the candidates among these elements around which the average exceeds largest_average(); the others are candidates no
  // more.
  void judge(Block<Real>& block, int column, Rows rows) const;

  // 1, and more by what an element is too large to be a point: averaging_allowance of settings.hpp.
  double largest_average() const { return largest_average_; }

  // The average of the foreseen energy over its limit, around a live element that can erode and over all of these within the length.
  double average_around(const Block<Real>& block, int column, int row) const;

 private:
  // Elements of a column, from as many rows above to as many below as are near enough, and zeros behind. No weights where none is.
  struct Neighbour {
    int column = -1;
    std::vector<Real> weights;
    bool is_there() const { return !weights.empty(); }
  };
  // The columns as many places to the left and to the right. They are summed first, so that the mirrored scene has mirrored bits.
  struct Pair {
    Neighbour left, right;
  };
  std::vector<Real> padded(const std::vector<double>& by_rows_between) const;
  WeightedSum sum_over(const Block<Real>& block, const Neighbour& neighbour, int row) const;

  const Kernel<Real>& kernel_ = kernel<Real>();
  double largest_average_ = 1;
  std::vector<std::vector<Pair>> pairs_;  // of each column
  std::vector<Real> per_limit_;           // of each row: 1/W_t, 0 where nothing erodes
};

}  // namespace percal
