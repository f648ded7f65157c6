// mesh: graded meshes of quads.
//
// Square elements near the axis, columns that grow geometrically to the wall.
//
// See docs/theory/impact.md.
#pragma once
#include "percal/mesh/graded.hpp"
#include "percal/mesh/quads.hpp"
