// What a field measures of an impact besides the depth, of all replicates together, in SI.
// docs/theory/field_measures.md
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "percal/impact/frame.hpp"
#include "percal/observe/penetration.hpp"

namespace percal {

// Where and how the particle ended, of runs that go on past the deepest point. Numbers of different endings are never averaged.
struct FinalState {
  Ending ending = Ending::unstable;  // the common one; where they differ, the first that is not the first run's
  bool mixed = false;
  MeanOfRuns depth;                  // m, of the tip: where all rest
  std::optional<double> half_width;  // m, the largest remaining swing
  MeanOfRuns speed;                  // m/s, downwards, in free flight: where all left the same way
  EnergyLedger energy;               // mean
  double worst_closure = 0;
};

// Half the distance of the walls at channel_shares of each run's depth.
struct ChannelOfRuns {
  std::vector<double> depths;            // m, of the mean deepest tip position
  std::vector<MeanOfRuns> largest, end;  // m
};

struct FieldMeasures {
  // m/s, downwards, behind each layer: where all runs crossed its lower face.
  std::vector<MeanOfRuns> speeds_behind;
  // m/s: where all runs passed through; in free flight where they went on, else at the lowest face.
  MeanOfRuns exit_speed;
  std::optional<FinalState> final;
  std::optional<ChannelOfRuns> channel;
};

FieldMeasures field_measures(const std::vector<Evaluation>& replicates, const Problem& problem, const Scales& scales);

// Sentences for a reader of them: endings that differ, and the reasons of those that are none.
std::vector<std::string> warnings(const FieldMeasures& measures, const std::vector<Evaluation>& replicates);

// Corners of the particle's outline at its deepest position, (distance from the middle line, depth), m; closed, the first is the last.
std::vector<Point> particle_outline(const ImpactResult& run, const Problem& problem, const Scales& scales);

}  // namespace percal
