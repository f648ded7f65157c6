// A job of percal dose and percal design: a powder, the calibration that it is shot by, and what is asked.   docs/formats/dose.md
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "percal/base/error.hpp"
#include "percal/powder/design.hpp"

namespace percal {

// A text, and where the job has it.
struct PlacedText {
  std::string text;
  Place place;
};

// A layer of the target, by its place in depth alone: the calibration's material goes through all of them.
struct DepthLayer {
  std::string name;
  double from = 0, to = 0;  // m
};

// What a measurement of the powder's depths found, to be held against.
struct MeasuredDepths {
  double mean = 0, deviation = 0;  // m: of single particles
  std::optional<int> particles;
  std::string note;  // said with the verdict
};

struct PowderJob {
  std::string file, text, title;
  PlacedText calibration, material, hypothesis;
  std::optional<double> level;        // nothing: the calibration's
  std::optional<double> layer_depth;  // m; nothing: that of the calibration's shots
  Place layer_place;
  std::optional<double> scatter;  // of ln depth of single particles; nothing: the calibration's
  Bounce bounce = Breach{};
  Powder powder;
  bool sizes_by_mass = false;  // the radii were given by the mass of what has them
  std::vector<DepthLayer> layers;
  std::optional<MeasuredDepths> measured;
  std::optional<DepthBand> band;
  std::optional<DesignQuestion> design;
};

// Throws BadInput. The calibration is not read.
PowderJob read_powder_job(const std::string& path);

}  // namespace percal
