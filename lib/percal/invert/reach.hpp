// How far a sphere gets in a layer: its depth where it stops; where it passes, the depth at which its energy would be gone if it went on as
// in the layer.                                                                               docs/theory/emulator.md (1a)
#pragma once
#include <cmath>

namespace percal {

// reach = L/(1 - (v_left/v)^2); 0 <= share_left < 1 is v_left/v.
inline double reach_of_passage(double layer_depth, double share_left) {
  return layer_depth / ((1 - share_left) * (1 + share_left));
}

// v_left/v of a reach; 0 where the layer holds it.
inline double share_left(double layer_depth, double reach) {
  return reach > layer_depth ? std::sqrt(1 - layer_depth / reach) : 0;
}

// d ln reach / d (v_left/v), and the same by ln v at a v_left that is held.
inline double reach_slope(double share_left) { return 2 * share_left / ((1 - share_left) * (1 + share_left)); }
inline double reach_speed_slope(double share_left) { return -share_left * reach_slope(share_left); }

}  // namespace percal
