// The job of percal scale: two systems, each given by its numbers or by a scene, and the scene to write.
#pragma once
#include <optional>
#include <string>

#include "percal/scaling/similar.hpp"
#include "percal/scaling/system_toml.hpp"
#include "percal/scene/scene.hpp"

namespace percal {

// Of a group's agreement where the job says none: about the last digit of most printed values.
inline constexpr double default_tolerance = 0.01;

struct ScaleJob {
  std::string file;
  std::string text;  // the job as it stands
  SystemInput prototype;
  SystemInput model;
  std::optional<Scene> prototype_scene;
  double tolerance = default_tolerance;
  std::string output_scene;  // empty: write none
};

// Tables [prototype] and [model] with `scene` or the keys of a system, `tolerance`, [output] with `scene`. Throws BadInput.
ScaleJob read_scale_job(const std::string& path);
ScaleJob parse_scale_job(const std::string& text, const std::string& name);

// Throws BadInput where a similar scene is asked for and the job's prototype is none.
void check_output_scene(const ScaleJob& job);

// The job's prototype made similar with its completed model, as the text of a scene. Throws BadInput where the two are not similar.
std::string similar_scene_text(const ScaleJob& job, const Completion& completion);

}  // namespace percal
