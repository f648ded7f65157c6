// How a scene is refused.
#pragma once
#include <string>

#include "percal/base/error.hpp"
#include "percal/scene/scene_toml.hpp"

namespace percal::test {

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
