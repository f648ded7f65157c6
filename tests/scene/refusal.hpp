// How a scene is refused, and a target for blocks that is not.
#pragma once
#include <string>

#include "percal/base/error.hpp"
#include "percal/scene/scene_toml.hpp"

namespace percal::test {

inline const std::string block_target =
    "[target]\ndensity = \"1 t/m3\"\nmu = \"1 MPa\"\nalpha = 9\ndepth = \"75 mm\"\nwidth = \"12 mm\"\n";

// The message, in which the file is scene.toml; "accepted" where there is none.
inline std::string refusal(const std::string& scene) {
  try {
    parse_scene(scene, "scene.toml");
    return "accepted";
  } catch (const BadInput& error) {
    return error.what();
  }
}

}  // namespace percal::test
