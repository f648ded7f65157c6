// [target.erosion] and [below.erosion] of a scene's file.     docs/formats/scene.md
#pragma once
#include <string>

#include "percal/scene/scene.hpp"
#include "percal/text/toml.hpp"

namespace percal {

// Sets what the first layer's table says: criteria, size, length. Without a table nothing erodes.
void read_erosion(const TomlTable& target, const ParticleScene& particle, LayerScene& layer);

// The limits of a layer below, by criteria that the first layer has.
void read_lower_erosion(const TomlTable& table, const LayerScene& first, LowerLayerScene& layer);

// Which of the two keys of the length is given; empty: neither.
std::string erosion_length_key(const TomlTable& erosion);

}  // namespace percal
