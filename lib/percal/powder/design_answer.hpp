// The answer to percal design: the best particle and speed, and what to know about it.
#pragma once
#include <string>
#include <vector>

#include "percal/page/result.hpp"
#include "percal/powder/design.hpp"
#include "percal/powder/powder_model.hpp"

namespace percal {

struct DesignAnswer {
  std::string material, hypothesis;  // names
  double layer_depth = 0, level = 0;
  PowderDesign design;
  std::vector<BeyondFitted> beyond;  // of the best
  std::vector<std::string> findings;
  page::Cost cost;
};

// Throws BadInput where the job has no [design].
void need_design(const PowderJob& job);

// Of a job with [design].
DesignAnswer answer_design(const PowderJob& job, const ShotModel& calibration);

}  // namespace percal
