#include "percal/impact/march/near_cells.hpp"

#include <algorithm>

namespace percal {
namespace {

// Among the groups from `begin` to `end`.
template <class IsNear>
void collect(std::vector<Rows>& runs, int begin, int end, int lanes, IsNear is_near) {
  runs.clear();
  for (int g = begin; g < end; ++g) {
    if (!is_near(g)) continue;
    if (!runs.empty() && runs.back().end == g * lanes)
      runs.back().end += lanes;
    else
      runs.push_back({g * lanes, (g + 1) * lanes});
  }
}

}  // namespace

NearCells::NearCells(int columns, int padded_rows, int lanes)
    : columns_(columns),
      groups_(padded_rows / lanes),
      lanes_(lanes),
      cells_(static_cast<std::size_t>(columns) * groups_),
      element_rows_(columns),
      node_rows_(columns + 1) {}

void NearCells::clear() {
  std::fill(cells_.begin(), cells_.end(), std::uint8_t{0});
  count_ = 0;
  first_ = groups_;
  last_ = -1;
}

void NearCells::add(int column, int row) {
  auto& cell = cells_[index(column, row)];
  first_ = std::min(first_, row / lanes_);
  last_ = std::max(last_, row / lanes_);
  count_ += cell == 0;
  cell = 1;
}

void NearCells::add(int column_begin, int column_end, Rows rows) {
  for (int i = column_begin; i < column_end; ++i)
    for (int j = rows.begin; j < rows.end; j += lanes_) add(i, j);
}

// A node's elements are those of its row and of the row above, in its column and in the one before.
bool NearCells::near_node_group(int column, int group) const {
  for (int i = std::max(0, column - 1); i <= std::min(column, columns_ - 1); ++i)
    for (int g = std::max(0, group - 1); g <= std::min(group, groups_ - 1); ++g)
      if (cells_[static_cast<long>(i) * groups_ + g]) return true;
  return false;
}

void NearCells::close() {
  for (int i = 0; i < columns_; ++i)
    collect(element_rows_[i], first_, last_ + 1, lanes_, [&](int g) { return cells_[static_cast<long>(i) * groups_ + g] != 0; });
  for (int i = 0; i <= columns_; ++i)
    collect(node_rows_[i], first_, last_ + 2, lanes_, [&](int g) { return near_node_group(i, g); });
}

}  // namespace percal
