// Which particle and which speed put most of the mass into a band of depth.                        docs/theory/powder.md
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "percal/powder/dose.hpp"

namespace percal {

// Ends of a search, SI.
struct SearchRange {
  double low = 0, high = 0;
};

// Shares of the mass.
struct DoseLimits {
  std::optional<double> bounced, passed;
  std::optional<double> deeper_than, deeper;  // m, and the share that may end below it or pass
  std::optional<double> most_impact;          // kg/(m s), of the middle particle
  std::optional<double> beyond;               // share of particles that the model has not seen
};

struct DesignQuestion {
  SearchRange radius, speed;      // of the middle particle
  std::vector<double> densities;  // of it; empty: the powder's own
  DoseLimits limits;
  int map = 21;         // points of the map along either axis
  double enough = 0.9;  // of the best dose: a tolerance ends where less is left
};

// Means over the draws, of the mass.
struct DesignShares {
  double dose = 0, bounced = 0, passed = 0, deeper = 0;
  double beyond = 0;  // of particles that the model has not seen
};

struct DesignPoint {
  PowderParticle middle;
  DesignShares shares;
  bool allowed = true;  // by the limits
};

// A number may leave the best one as far as this; open: as far as was looked.
struct Tolerance {
  double low = 0, high = 0;
  bool low_open = false, high_open = false;
};

// The dose of the best where the powder or the device spreads otherwise.
struct OtherSpread {
  std::string of;  // "size", "speed"
  double geometric_deviation = 1;
  double dose = 0;
};

struct PowderDesign {
  std::vector<DesignPoint> map;         // of the best density; the speed goes fastest
  std::vector<DesignPoint> line;        // for each radius of the map the speed of the largest allowed dose; may be none
  std::vector<DesignPoint> by_density;  // the best of each density, as far as any is allowed
  std::optional<DesignPoint> best;      // nothing: no point is within the limits
  DoseEstimate dose, bounced, passed, deeper;  // of the best
  Tolerance best_speed;                        // at its radius, for the parameters that are not ruled out
  Tolerance radius, speed;                     // one at a time
  std::vector<OtherSpread> spreads;
};

// The powder's distributions are moved along their logarithms to each middle particle. `question.band` says where the dose is wanted. (10)
PowderDesign design_of(const Powder& powder, const ForwardModel& model, const DoseQuestion& question,
                       const DesignQuestion& design);

}  // namespace percal
