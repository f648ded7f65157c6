// How large a run is, before anything of it is made.     docs/formats/scene.md
#pragma once
#include <string>

#include "percal/problem/problem.hpp"

namespace percal {

// Numbers that a block in three dimensions keeps for each node, besides a byte.
inline constexpr int fields_per_brick = 14;

// In double, so that no scene is too large to be counted. The steps are an estimate from above: the particle needs no longer than
// twice the target's depth at impact speed, and the mean step is about a quarter of the first.
struct RunSize {
  double columns = 0, rows = 0, elements = 0;
  double bytes = 0;  // of elements and nodes
  double steps = 0;  // about
};
RunSize size_of(const Problem& problem);

// What a file calls the numbers that make a run large.
struct SizeKeys {
  std::string mesh = "mesh.elements_per_radius", depth = "target.depth", width = "mesh.fine_width";
};

// Whether a run would not fit into this machine's memory, or would be called off after most_steps (impact/settings.hpp).
bool is_too_large(const Problem& problem);

// Throws BadInput where a run is too large. `file` is where the problem came from.
void refuse_what_is_too_large(const Problem& problem, const std::string& file, const SizeKeys& keys = {});

// "28350 elements (27 columns, 1050 rows), 1.68 MB, up to about 3.7e+04 steps".
std::string in_words(const RunSize& size);

}  // namespace percal
