// What a record of a shot's flight through its target says of it, as from high-speed video.    docs/theory/calibration.md, Records
#pragma once
#include <optional>
#include <string>

#include "percal/text/toml.hpp"

namespace percal {

// One number of the record, for its frames are no data apart from each other.
struct RecordedShot {
  enum class End {
    stopped,      // the record shows the sphere stop: its deepest depth
    half_speed,   // it ends before, with less than half of the speed left: the depth at half of it
    still_faster  // before that, too: how deep the sphere was last seen
  } end = End::still_faster;
  double depth = 0;           // m
  double standard_error = 0;  // m: of the record's reading; 0 where the depth is a bound
};

// The point's `trajectory`, a CSV file; nothing where it has none. Throws BadInput for the keys of one beside it.
std::optional<std::string> record_path(const TomlTable& point);

// That file: times with depths of the tip below the surface, or with speeds from the impact on, in columns that the point's keys
// trajectory_time, trajectory_depth and trajectory_speed name ("time", "depth" where it does not). `speed`: at impact, m/s.
// Throws BadInput by file and line.
RecordedShot recorded_shot(const std::string& path, const TomlTable& point, double speed);

}  // namespace percal
