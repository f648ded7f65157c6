// What the force of a history adds up to.
#pragma once
#include <vector>

#include "percal/impact/result.hpp"

namespace percal {

inline double impulse_of(const std::vector<HistoryPoint>& history) {
  double impulse = 0;
  for (std::size_t k = 1; k < history.size(); ++k)
    impulse += 0.5 * (history[k].force + history[k - 1].force) * (history[k].time - history[k - 1].time);
  return impulse;
}

}  // namespace percal
