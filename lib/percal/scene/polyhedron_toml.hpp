// The corners of a polyhedron as a scene gives them: a CSV or STL file, or an array.     docs/formats/scene.md, "[particle]"
#pragma once
#include <string>

#include "percal/math/polyhedron.hpp"
#include "percal/text/toml.hpp"

namespace percal {

// `vertices` and `stl_unit`: corners in m, as the file has them, without points that are none. Sets `file`. Throws BadInput, which names the
// line of the point, or of the triangle, where the body is not convex.
Vertices polyhedron_from(const TomlTable& table, std::string& file);

}  // namespace percal
