// The parts of the reader of calibration jobs, a file each. Each takes the root table and adds to the job what it has
// read; the order in read_calibration_job is the order in which they need each other. They throw BadInput.
#pragma once
#include <string>

#include "percal/calibrate/job.hpp"
#include "percal/text/toml.hpp"

namespace percal {

void read_parameters(const TomlTable& root, CalibrationJob& job);         // read_parameters.cpp
void read_materials(const TomlTable& root, CalibrationJob& job);          // read_parameters.cpp
void read_scatter_groups(const TomlTable& root, CalibrationJob& job);     // read_scatter.cpp
void read_shots(const TomlTable& root, CalibrationJob& job);              // read_shots.cpp
void read_job_curves(const TomlTable& root, CalibrationJob& job);         // read_job_curves.cpp
void read_hypotheses(const TomlTable& root, CalibrationJob& job);         // read_hypotheses.cpp
void read_cross_validations(const TomlTable& root, CalibrationJob& job);  // read_cross_validations.cpp
void read_published(const TomlTable& root, CalibrationJob& job);          // read_hypotheses.cpp
void read_training(const TomlTable& root, CalibrationJob& job);           // read_training.cpp

// What no single block can tell: numbers, materials and groups that nothing uses, parameters that no fitted datum
// depends on.
void check_use(const TomlTable& root, const CalibrationJob& job);  // check_use.cpp

// A share of 1: a number, or a text in percent, "5 %".
double share_from(const TomlTable& block, const std::string& key, const Range& range, double fallback);
std::optional<double> optional_share_from(const TomlTable& block, const std::string& key, const Range& range);

// Index of the block's material, and of its scatter group: `fallback` where the block names none, and made where nobody
// has declared it.
int material_index(const TomlTable& block, const CalibrationJob& job);
int group_index(const TomlTable& block, const std::string& fallback, CalibrationJob& job);

// "a, b": names of blocks, for messages.
template <class Named>
std::string names_of(const std::vector<Named>& all) {
  std::string text;
  for (const Named& one : all) text += (text.empty() ? "" : ", ") + one.name;
  return text.empty() ? "none" : text;
}

}  // namespace percal
