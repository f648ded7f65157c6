// The answer to percal dose: the dose, where its spread comes from, what was measured beside it.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "percal/page/result.hpp"
#include "percal/powder/powder_model.hpp"

namespace percal {

// The spread that was measured against that which is computed.
struct SpreadVerdict {
  DoseEstimate measured;       // m: the deviation with its own interval, where the particles were counted
  bool by_size_alone = false;  // its interval and that of the sizes alone meet
  bool by_all = false;         // and that of everything together
};

struct DoseAnswer {
  std::string material, hypothesis;  // names
  double layer_depth = 0, level = 0;
  double scatter = 0;  // of ln depth
  PowderParticle middle;
  Dose dose;
  std::vector<SpreadSource> spread;
  std::vector<BeyondFitted> beyond;
  std::optional<SpreadVerdict> verdict;
  std::vector<std::string> findings;
  page::Cost cost;
};

DoseAnswer answer_dose(const PowderJob& job, const ShotModel& calibration);

}  // namespace percal
