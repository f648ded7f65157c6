// math: statistics, quasi-random points, Gaussian processes, polygons, polyhedra.
//
// Plain numerics that know nothing of materials: straight lines and power laws, Sobol points, grid convergence, a
// Gaussian process with a nugget, areas and inertias of polygons and of convex polyhedra.
//
//     const percal::Line line = percal::linear_trend(x, y);
//
// See docs/theory/emulator.md, docs/theory/errors.md.
#pragma once
#include "percal/math/distributions.hpp"
#include "percal/math/draws.hpp"
#include "percal/math/gaussian_process.hpp"
#include "percal/math/grid_convergence.hpp"
#include "percal/math/polygon.hpp"
#include "percal/math/polyhedron.hpp"
#include "percal/math/statistics.hpp"
