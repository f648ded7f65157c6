// What the readers of a scene share with its writer, and the particle, whose reader is a file of its own.
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
const std::vector<std::string>& run_until_words();

// rad; `range` likewise. Throws BadInput.
double angle_from(const TomlTable& table, const std::string& key, const Range& range);

// Throws BadInput.
ParticleScene particle_from(const TomlTable& table, Geometry geometry);

// The same without its speed and what bends it: shape, size, density, and in a block the direction of its flight. Throws BadInput.
ParticleScene body_from(const TomlTable& table, Geometry geometry);

}  // namespace percal
