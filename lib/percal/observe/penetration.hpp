// What the replicates of one impact say together, in SI.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "percal/impact/result.hpp"
#include "percal/problem/problem.hpp"

namespace percal {

// One run with what it cost.
struct Evaluation {
  ImpactResult result;
  std::string instruction_level;
  double wall_seconds = 0;
  double cpu_seconds = 0;
  bool reused = false;  // taken from the store
};

// Of a number that every run has: mean, sample standard deviation and that over the root of their number. One run has no deviation.
struct MeanOfRuns {
  std::optional<double> mean = {}, spread = {}, standard_error = {};
};
MeanOfRuns mean_of_runs(const std::vector<double>& values);  // nothing of none

// The replicates of one problem (problem/replicates.hpp). Depths are averaged only where every run stopped: outcomes of different kinds are never
// mixed into one number.
struct Penetration {
  Outcome outcome = Outcome::unstable;  // the common one; where they differ, the first that is not `stopped`
  bool mixed = false;
  std::vector<Outcome> outcomes;
  std::optional<double> depth;           // m, mean
  std::optional<double> spread;          // m, sample standard deviation over phase and speed; needs two runs
  std::optional<double> standard_error;  // m, spread / sqrt(runs)
  std::optional<double> at_least;        // m: the layer's depth, where a run passed through it
  std::vector<double> depths;            // m, of each run, deepest tip position whatever the outcome
  EnergyLedger energy;                   // mean over the runs
  double worst_closure = 0;              // largest |energy closure|
  bool is_joined = false;                // depth and standard error are those of the runs and the atlas together
};

// Mean of every term.
EnergyLedger mean_energy(const std::vector<EnergyLedger>& energies);

Penetration summarise(const std::vector<Evaluation>& replicates, const Problem& problem, const Scales& scales);

// What finished runs of other scenes say of a depth, before there is a run of it.               docs/theory/atlas.md
struct AtlasDepth {
  double depth = 0;      // m, the mean over the mesh phase
  double deviation = 0;  // standard deviation of its ln
  double noise = 0;      // of the ln of one run about it
  double width = 0;      // radii: its own wall

  // m: of 100 single runs 95 lie between.
  double low() const;
  double high() const;
};

// Standard deviation of ln depth where runs and atlas are joined, each by its certainty.                             (3)
double joined_error(const AtlasDepth& atlas, int runs);
// Of runs that all stopped.
Penetration joined(const Penetration& of_runs, const AtlasDepth& atlas);
// How much of ln depth the 95 % half widths of both means leave room for.
double allowed_apart(const AtlasDepth& atlas, int runs);

// Warnings that a reader of the depth needs: mixed outcomes, runs that ended for a reason of their own, collisions and
// viscosity with most of the energy, distorted elements.
std::vector<std::string> warnings(const Penetration& penetration, const std::vector<Evaluation>& replicates);

// Collisions and viscosity take 0.1 to 0.45 of the impact energy where the target erodes, whatever the mesh: what the recoil of
// surfaces that erosion has bared brings, and shocks (docs/theory/impact.md, "Energy"). Above this the summary says so.
inline constexpr double tolerated_numerical_loss = 0.5;

}  // namespace percal
