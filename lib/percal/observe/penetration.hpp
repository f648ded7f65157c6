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
};

// Mean of every term.
EnergyLedger mean_energy(const std::vector<EnergyLedger>& energies);

Penetration summarise(const std::vector<Evaluation>& replicates, const Problem& problem, const Scales& scales);

// Warnings that a reader of the depth needs: mixed outcomes, runs that ended for a reason of their own, collisions and
// viscosity with most of the energy, distorted elements.
std::vector<std::string> warnings(const Penetration& penetration, const std::vector<Evaluation>& replicates);

// Collisions and viscosity take 0.1 to 0.45 of the impact energy where the target erodes, whatever the mesh: what the recoil of
// surfaces that erosion has bared brings, and shocks (docs/theory/impact.md, "Energy"). Above this the summary says so.
inline constexpr double tolerated_numerical_loss = 0.5;

}  // namespace percal
