// What the atlas expects of an impact that is about to be run: how deep, how much one run scatters, and where a search should begin.
//                                                                                                docs/theory/atlas.md
#pragma once
#include <functional>
#include <optional>

#include "percal/atlas/atlas.hpp"
#include "percal/invert/modulus.hpp"
#include "percal/observe/penetration.hpp"
#include "percal/problem/problem.hpp"

namespace percal {

// The one that tells of this impact: of its setting but for the wall, which both have as far away as the shot asks for (usual_width());
// null where there is none.
const Atlas* atlas_about(const Problem& problem);

struct ExpectedDepth {
  double log_depth = 0;  // ln of the reach in radii, the mean over the mesh phase
  double deviation = 0;  // standard deviation of that
  double noise = 0;      // of one run about it
};

// On the problem's own elements. Nothing where the atlas is not sure: where a run would tell more of the depth than all of its runs near by, and
// on elements larger or smaller than any of theirs.
std::optional<ExpectedDepth> expected_depth(const Problem& problem);

// The same in SI, for a sphere of this radius in m.
AtlasDepth in_metres(const ExpectedDepth& expected, double radius);

struct ExpectedRoot {
  double log_value = 0;
  double slope = 0;  // d ln depth/d ln value there, below 0
  ExpectedDepth at;
};

// Where ln of the depth in radii is expected to be `log_depth`, as a number falls with which the depth falls: within `farthest` of `from`, both
// ln. Nothing where the atlas is not sure there.
std::optional<ExpectedRoot> expected_root(const std::function<Problem(double log_value)>& problem, double log_depth,
                                          double from, double farthest);

// A search (invert/modulus.hpp) that begins there, takes the slope for its steps and as a part of its line, and counts on the noise of one run an answer. Its line has no more
// answers than make its error small beside `others`, a standard deviation of ln depth, and no more than it had.
void begin_at(const ExpectedRoot& root, double others, InversionOptions& options);

}  // namespace percal
