// The shots of a calibration as scenes at what it found, for `percal impact`.
#pragma once
#include <string>
#include <vector>

#include "percal/calibrate/result.hpp"
#include "percal/scene/scene.hpp"

namespace percal {

struct BestScene {
  std::string name;  // of a file, without its extension: "1_steel_1"
  Scene scene;
};

// Each shot at each hypothesis' best point, on the mesh and with the replicates of the fresh runs beside it: an erosion strain holds
// for the element size that it was found with. None where nothing was fitted.
std::vector<BestScene> best_scenes(const CalibrationJob& job, const CalibrationResult& result);

}  // namespace percal
