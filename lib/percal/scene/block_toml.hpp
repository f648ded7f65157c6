// What geometry = "block" adds to a scene's keys, and what it does not have so far.     docs/formats/scene.md, "Three dimensions"
#pragma once
#include "percal/scene/scene.hpp"
#include "percal/text/toml.hpp"

namespace percal {

// Where a scene says nothing of its mesh: in a block six cells on the smaller of half width and half thickness of its particle, cubes in
// a box around its path.     docs/theory/solid.md (1)
MeshScene usual_mesh(const Scene& scene);
inline constexpr double usual_elements_on_smaller_half = 6;

// fine_thickness, fine_depth, growth and whole_across of a block; refused in other geometries, as graded_columns is in a block.
void read_block_mesh(const TomlTable& table, const Scene& scene, MeshScene& mesh);

// A key that only a block has.
void refuse_elsewhere(const TomlTable& table, const std::string& key, Geometry geometry);

// [target.fibres] with an angle.
FibreFamilies fibre_families_from(const TomlTable& table);

// `angle` of the particle. Refused where the geometry, or a particle that is held as it stands, has none.
void read_angle(const TomlTable& table, Geometry geometry, ParticleScene& particle);

// Keys of a block's scene that ask for what its solver does not do: a BadInput names the first.
void refuse_what_a_block_lacks(const TomlTable& scene_table, const Scene& scene);

}  // namespace percal
