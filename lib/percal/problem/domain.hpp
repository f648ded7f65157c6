// The mesh of a problem, on any number of elements per radius.     docs/theory/impact.md, docs/decisions/0012-mesh-and-phase.md
#pragma once
#include "percal/mesh/box.hpp"
#include "percal/mesh/graded.hpp"
#include "percal/problem/problem.hpp"

namespace percal {

// Of the right half.
GradedMeshOptions mesh_options(const Problem& problem);

// Of geometry block.
BoxGridOptions box_options(const Problem& problem);

// Graded columns where nobody says how many: none grows by more than usual_growth. 0: all columns are even.
int usual_graded_columns(const Problem& problem);

// The same problem on square elements of side 1/elements_per_radius. Graded columns that are the usual ones are the usual ones
// again; others keep their number.
Problem on_mesh(const Problem& problem, double elements_per_radius);

// Graded columns that grow as the problem's do, on another mesh and up to another wall (radii); 1 or more.
int graded_columns_like(const Problem& problem, double elements_per_radius, double width);

// The scene with other elements. Graded columns that the scene counts out grow as they did, in another number.
Scene on_mesh(const Scene& scene, double elements_per_radius);

// What a given mesh and wall are expected to cost in depth, in words; nothing where they keep to the rules.
std::vector<std::string> mesh_warnings(const Scene& scene, const Problem& problem);

// Of a problem reduced from the scene.
MeshChoice mesh_choice(const Scene& scene, const Problem& problem);

}  // namespace percal
