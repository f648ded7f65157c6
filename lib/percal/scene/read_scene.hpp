// The parts of the scene reader, one file each: particle_toml.cpp, profile_toml.cpp, target_toml.cpp. Each throws BadInput.
#pragma once
#include <string>
#include <vector>

#include "percal/scene/scene.hpp"
#include "percal/text/toml.hpp"

namespace percal {

// The words of a scene in the order of the enumerations they stand for.
const std::vector<std::string>& geometry_words();
const std::vector<std::string>& elasticity_words();
const std::vector<std::string>& hourglass_words();
const std::vector<std::string>& volumetric_words();
const std::vector<std::string>& eroded_node_words();

ParticleScene particle_from(const TomlTable& table, Geometry geometry);

// Shapes other than round ones; `shape` is "profile", "rhombus" or "cone". Sets shape, radius and density.
void read_profile(const TomlTable& table, const std::string& shape, Geometry geometry, ParticleScene& particle);

// "a length above the particle's radius of 1 um".
Range length_above(double low, const std::string& of_what);

// The target's layers; the particle decides how wide they must be, `depth` how deep the first.
LayerScene target_from(const TomlTable& table, const ParticleScene& particle, Geometry geometry, const Range& depth);
std::vector<LowerLayerScene> below_from(const std::vector<TomlTable>& tables, const LayerScene& first);

}  // namespace percal
