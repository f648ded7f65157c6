// A test followed along its rows: where its stretch turns, where it is held, where its stress peaks.      docs/formats/csv.md
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "percal/fit/points/curve_data.hpp"

namespace percal {

inline constexpr double turning = 0.05;        // of the largest strain: a smaller way back is noise
inline constexpr double standing = 1e-3;       // of it: the stretch is held
inline constexpr double fallen = 0.9;          // of the largest stress, behind a peak
inline constexpr std::size_t fewest_rows = 8;  // to tell a shape from

// A point as it is met along a test: how far from rest, and the stress in that direction.
struct Met {
  double strain, stress;
  std::size_t row;
};

struct Followed {
  std::string name;  // "uniaxial compression"
  std::vector<Met> points;
  double longest = 0, largest = 0;  // strain, stress
};

// Each deformation by itself, tension and compression apart, in the order of the rows; none for general biaxial points, none of fewer
// than `fewest` points.
std::vector<Followed> followed(const std::vector<StressPoint>& points, std::size_t fewest = fewest_rows);

// From one turning point to the next, both with it.
struct Branch {
  std::size_t begin, end;  // indices of Followed::points
  bool loading;
  bool anew = false;  // does not go on where the last one ended: another curve
};
std::vector<Branch> branches_of(const Followed& test);

// A stress that falls while the stretch is held.
struct HeldRows {
  std::size_t begin, end;
};
std::vector<HeldRows> holds_of(const Followed& test);

// The largest stress of the points from `begin` to `end`, and how far it has fallen at the end: a share, both averaged over a few points.
struct Top {
  std::size_t at;
  double fallen_to;
};
Top top_of(const Followed& test, std::size_t begin, std::size_t end);

}  // namespace percal
