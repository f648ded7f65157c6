// The runs whose mean is a depth: one walk through the phase of the mesh, each run at a speed of its own.
// docs/theory/impact.md (19a), docs/decisions/0012-mesh-and-phase.md
#pragma once
#include <vector>

#include "percal/problem/problem.hpp"

namespace percal {

// Elements per radius between the coarsest and the finest mesh of the walk, about one column more or fewer in the channel; less
// on meshes of fewer than 3.4 elements per radius.
inline constexpr double phase_span = 1.7;

// Replicate middle_replicate(count) is the problem itself where count is odd; the others lie on either side of it.
constexpr int middle_replicate(int count) { return (count - 1) / 2; }

// The span of a walk about this mesh.
double walk_span(double elements_per_radius);

// Elements per radius of replicate `index` of `count`.
double replicate_mesh(double elements_per_radius, int index, int count);

// Its speed over the scene's.
double replicate_speed(int index, int count);

// Factors of speed from the scene's own outwards: 1, 1.001, 0.999, 1.002, 0.998, ...
double replicate_speed_factor(int step);

// The replicates in the order of their meshes. The one nearest the middle keeps the problem's history, the others have none.
std::vector<Problem> replicates_of(const Problem& problem, int count);

// The mesh of the `draw`-th of many single runs whose phases shall fill the span evenly: a golden-ratio sequence that begins
// where the seed says. What learns from such runs sees the phase as scatter.
double drawn_mesh(double elements_per_radius, unsigned seed, int draw);

}  // namespace percal
