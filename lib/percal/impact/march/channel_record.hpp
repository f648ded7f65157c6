// How wide the channel is that erosion has left, row by row.          docs/theory/field_measures.md
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "percal/impact/result.hpp"
#include "percal/impact/target/block.hpp"

namespace percal {

// Half the distance of the walls in a row of elements: on either side the wall is the inner face of the last element that is joined to
// the outer edge through live ones; what is left within are fragments. 0 where the row is whole.
template <class Real>
double channel_radius(const Block<Real>& block, int row) {
  const int columns = block.mesh().columns();
  const auto& view = block.view();
  const auto is_alive = [&](int column) { return view.alive[block.at(column, row)] > 0; };
  const auto face = [&](int column) {
    const double moved = 0.5 * (static_cast<double>(view.u_r[block.at(column, row)]) + view.u_r[block.at(column, row + 1)]);
    return block.mesh().radius[column] + moved;
  };
  int right = columns, left = 0;
  while (right > 0 && is_alive(right - 1)) --right;
  if (right == 0) return 0;
  if (!block.is_whole()) return face(right);
  while (is_alive(left)) ++left;
  return 0.5 * (face(right) - face(left));
}

// The largest radius of each row that the tip has reached; no rows where nobody asks.
template <class Real>
class ChannelRecord {
 public:
  ChannelRecord(bool wanted, int rows) : largest_(wanted ? rows : 0) {}

  // Asked after every long step.
  void look(const Block<Real>& block, double tip) {
    const int end = rows_down_to(block, tip);
    for (int j = 0; j < end; ++j) largest_[j] = std::max(largest_[j], channel_radius(block, j));
  }

  // At channel_shares of this depth.
  Channel at_the_end(const Block<Real>& block, double depth) const {
    Channel channel;
    for (const double share : channel_shares) {
      if (largest_.empty()) break;
      const int row = std::max(0, rows_down_to(block, share * depth) - 1);
      channel.largest.push_back(largest_[row]);
      channel.end.push_back(channel_radius(block, row));
    }
    return channel;
  }

 private:
  int rows_down_to(const Block<Real>& block, double depth) const {
    const double rows = std::floor(depth / block.mesh().row_height) + 1;
    const auto all = static_cast<double>(largest_.size());
    return static_cast<int>(rows > 0 && rows < all ? rows : (rows > 0 ? all : 0));
  }

  std::vector<double> largest_;
};

}  // namespace percal
