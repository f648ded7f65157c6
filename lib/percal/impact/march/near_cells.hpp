// Which elements take the short time step. A cell is one group of lanes of one column; nodes of a near element move with it.
#pragma once
#include <cstdint>
#include <vector>

#include "percal/impact/kernel/kernel.hpp"

namespace percal {

class NearCells {
 public:
  NearCells() = default;
  NearCells(int columns, int padded_rows, int lanes);

  void clear();
  void add(int column, int row);  // the cell of that element
  void add(int column_begin, int column_end, Rows rows);
  void close();  // after the last add: elements() and nodes() hold until the next clear()

  bool empty() const { return count_ == 0; }
  bool has(int column, int row) const { return cells_[index(column, row)] != 0; }
  // Calls changed(row) for every cell of a column that is near here or there but not both; row is its first.
  template <class Changed>
  void differences(const NearCells& other, int column, Changed changed) const {
    for (int g = 0; g < groups_; ++g)
      if (cells_[index(column, g * lanes_)] != other.cells_[index(column, g * lanes_)]) changed(g * lanes_);
  }
  double elements_in_all() const { return static_cast<double>(count_) * lanes_; }
  // Runs of near rows, from top to bottom: of a column of elements, of a column of nodes.
  const std::vector<Rows>& elements(int column) const { return element_rows_[column]; }
  const std::vector<Rows>& nodes(int column) const { return node_rows_[column]; }
  // The same, of near cells that may never have been laid out.
  const std::vector<Rows>& nodes_or_none(int column) const {
    static const std::vector<Rows> none;
    return node_rows_.empty() ? none : node_rows_[column];
  }

 private:
  long index(int column, int row) const { return static_cast<long>(column) * groups_ + row / lanes_; }
  bool near_node_group(int column, int group) const;
  int columns_ = 0, groups_ = 0, lanes_ = 1;
  long count_ = 0;
  int first_ = 0, last_ = -1;  // groups that have near cells, in any column
  std::vector<std::uint8_t> cells_;
  std::vector<std::vector<Rows>> element_rows_, node_rows_;
};

// Calls take(rows) for each run that is left of [0, end) between the given runs.
template <class Take>
void between(const std::vector<Rows>& runs, int end, Take take) {
  int begin = 0;
  for (const Rows& run : runs) {
    if (begin < run.begin) take(Rows{begin, run.begin < end ? run.begin : end});
    begin = run.end;
    if (begin >= end) return;
  }
  if (begin < end) take(Rows{begin, end});
}

}  // namespace percal
