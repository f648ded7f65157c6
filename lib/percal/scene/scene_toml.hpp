// Scenes as TOML text. Every key with its unit, range and default: docs/formats/scene.md.
#pragma once
#include <string>

#include "percal/scene/scene.hpp"
#include "percal/text/toml.hpp"

namespace percal {

// Throws BadInput: missing file, malformed TOML, unknown keys, wrong units, values that make no sense together.
Scene read_scene(const std::string& path);
Scene parse_scene(const std::string& text, const std::string& name);

// The scene that a table holds, so that a job can embed one. The caller finishes the table (TomlTable::finish).
Scene scene_from(const TomlTable& table);

// Parts of a scene, for jobs that hold no whole one: `nu` or `bulk_to_shear` of a table; the keys of a [solver] table.
VolumetricChoice volumetric_from(const TomlTable& table);
// What a scene of that geometry has where it says nothing.
SolverScene usual_solver(Geometry geometry);
SolverScene solver_from(const TomlTable& table, Geometry geometry = Geometry::axisymmetric);

// What an `elements_per_radius` may be, wherever one is written.
Range elements_per_radius_range();

// Text that parse_scene reads as the same scene bit for bit, but for the names of files (`source`, `vertices_file`): every
// setting written out, in SI. A profile is written as its vertices, whatever words and file it came from.
// `comment` stands at the top, each of its lines behind "# "; it may be empty.
std::string scene_to_toml(const Scene& scene, const std::string& comment);

}  // namespace percal
