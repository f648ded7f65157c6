// What a ladder of meshes says: how far each mesh is from the finest, the noise of a run and, where depths have a limit in the
// element's size, that limit and the error of every mesh. Formulas: docs/theory/errors.md.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "percal/math/grid_convergence.hpp"
#include "percal/study/ladder.hpp"

namespace percal {

inline constexpr std::array<int, 3> replicate_counts{1, 3, 10};  // whose means' errors are listed
inline constexpr double error_level = 0.95;                      // of every interval
inline constexpr std::uint64_t resampling_seed = 2014;           // of the noise drawn anew

struct ErrorBand {
  double value = 0, low = 0, high = 0;  // low to high: error_level
};

// Errors are shares of the extrapolated depth.
struct RungError {
  ErrorBand signed_error;             // of the mean that was found here
  double fitted_depth = 0;            // m
  std::optional<double> uncertainty;  // m, of grid_convergence(); not there for a mesh left out of the fit
  double discretisation = 0;          // the largest of this mesh and all finer ones, noise taken off
  std::array<ErrorBand, 3> combined;  // with the noise of a mean of replicate_counts runs
};

// A change of a numerical setting: the share by which it changes the depth, with its standard error.
struct Change {
  double elements_per_radius = 0;
  std::optional<double> share, standard_error;  // not there unless both stopped
  double cost_ratio = 0;                        // processor time over that without the change
  bool is_significant() const;                  // more than two standard errors
};

Change change(const Rung& from, const Rung& to);

// The spread of a run over its depth. Where elements erode it goes as their size, a column more or less in the channel; else it is
// that of the replicates' speeds, the same on all meshes.
struct RunNoise {
  static constexpr double usual_mesh = 10;  // elements per radius
  double on_usual_mesh = 0;
  double order = 0;  // in the size of an element
  double on(double elements_per_radius) const;
};

// One view of a ladder: the one found, or one that could have been found (its noise drawn anew).
struct LadderModel {
  GridFit fit;                         // nothing to be used without a limit
  std::vector<double> discretisation;  // of each used rung; 0 without a limit
  double irregularity = 0;             // scatter of the meshes about the fit beyond the noise
  RunNoise noise;
};

struct ErrorVsTime {
  Refinement refinement =
      Refinement::any_order;  // the ladder's; without a limit nothing is fitted and there are no errors
  GridConvergence convergence;
  std::size_t first_used = 0;    // the rungs of Ladder::meshes from here on stopped
  std::size_t first_fitted = 0;  // and from here on were fitted: coarser ones do not follow the curve
  ErrorBand limit;               // m, the extrapolated depth
  LadderModel model;
  std::vector<LadderModel> resampled;
  std::vector<ErrorBand> from_finest;  // one for each used rung: its depth over the finest mesh's, less 1
  std::vector<RungError> errors;       // one for each used rung; empty where nothing could be fitted
  std::vector<Change> half_step;       // one for each of Ladder::half_steps
  Change double_precision;             // from single to double
  std::vector<std::string> findings;

  bool has_limit() const { return refinement != Refinement::no_limit; }

  // Four meshes or more stopped, and the depth that they converge to is one.
  bool is_fitted() const { return convergence.outcome == GridOutcome::fitted && convergence.fit.limit > 0; }

  // There is something to advise by: the limit, or without one the noise and cost of two meshes or more.
  bool is_answered() const { return has_limit() ? is_fitted() : from_finest.size() > 1; }
};

ErrorVsTime error_vs_time(const Ladder& ladder);

// The root of the sum of squares: of the mesh's error, and of the noise of a mean of so many runs.
double combined_error(double discretisation, double noise, int replicates);

}  // namespace percal
