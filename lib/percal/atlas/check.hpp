// Fresh runs against what the atlas says of them: whether it holds, and how well.
#pragma once
#include <vector>

#include "percal/atlas/atlas.hpp"
#include "percal/base/progress.hpp"
#include "percal/campaign/campaign.hpp"

namespace percal {

struct CheckedPoint {
  TrainingRun run;       // made now
  double log_depth = 0;  // ln reach that the atlas says for it
  double deviation = 0;  // standard deviation of one run about that, noise included
  double error() const { return log_depth - run.log_depth; }
};

// `count` points between runs of the atlas, spread evenly over them, each run once by this solver; those without a reach are left out.
std::vector<CheckedPoint> check_atlas(const Atlas& atlas, int count, Campaign& campaign, Progress& progress);

struct AtlasAgreement {
  int points = 0, within95 = 0;
  double median = 0;            // of |error|, half of all are nearer
  double root_mean_square = 0;  // of the error
  double standardised = 0;      // root mean square of error over deviation: 1 where it is stated rightly
};
AtlasAgreement agreement(const std::vector<CheckedPoint>& points);

// Not what chance alone would give one atlas in a thousand.
bool holds(const AtlasAgreement& agreement);

}  // namespace percal
