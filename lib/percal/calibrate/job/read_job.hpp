// The readers of a calibration job: each takes the root table and adds to the job what it has read. They throw BadInput. The order
// in read_calibration_job is the order in which they need each other.
#pragma once
#include <memory>
#include <string>

#include "percal/calibrate/job.hpp"
#include "percal/text/job_table.hpp"
#include "percal/text/toml.hpp"

namespace percal {

// read_data.cpp
void read_scatter_groups(const TomlTable& root, CalibrationJob& job);
void read_job_curves(const TomlTable& root, CalibrationJob& job);
// Of the block's material.
int material_index(const TomlTable& block, const CalibrationJob& job);
// Of the block's scatter group: `fallback` where it names none, made where nobody has declared it.
int group_index(const TomlTable& block, const std::string& fallback, CalibrationJob& job);

// read_targets.cpp
// What can be shot into: the materials, then [targets.NAME].
void read_targets(const TomlTable& root, CalibrationJob& job);
// Of the block's target, or of its material alone.
int target_index(const TomlTable& block, const CalibrationJob& job);

// read_shots.cpp
void read_shots(const TomlTable& root, CalibrationJob& job);

// read_bodies.cpp
// What the block's shots were where they were no spheres; none of spheres. One that an earlier block has, too, is the same.
std::shared_ptr<const ShotBody> body_of_block(const TomlTable& block, CalibrationJob& job);
// Of a shot with a body: what only spheres have is refused.
void check_body(const TomlTable& block, const CalibrationJob& job, const MeasuredShot& shot);
// How deep the cubes of each body's blocks go, when all shots are known; bodies are refused beside shots that tell of passing.
void settle_bodies(const TomlTable& root, CalibrationJob& job);

// layer_width.cpp
// One width in radii for all spheres, and for all shots of each other body: what some of them give, or what the widest of them needs.
void settle_width(CalibrationJob& job);

// read_hypotheses.cpp
void read_hypotheses(const TomlTable& root, CalibrationJob& job);
void read_cross_validations(const TomlTable& root, CalibrationJob& job);
void read_published(const TomlTable& root, CalibrationJob& job);
// Numbers, materials and groups that nothing uses, parameters that no fitted datum depends on.
void check_use(const TomlTable& root, const CalibrationJob& job);

// Of a parameter's value.
Dimension dimension_of(ParameterKind kind);

// "a, b": names of blocks, for messages.
template <class Named>
std::string names_of(const std::vector<Named>& all) {
  std::string text;
  for (const Named& one : all) text += (text.empty() ? "" : ", ") + one.name;
  return text.empty() ? "none" : text;
}

}  // namespace percal
