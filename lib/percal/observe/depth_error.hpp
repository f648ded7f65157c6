// How far a depth may be from the one that finer settings would give, by source.     docs/theory/errors.md, The error of one depth
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "percal/observe/penetration.hpp"
#include "percal/problem/problem.hpp"
#include "percal/scene/scene.hpp"

namespace percal {

enum class DepthErrorSource { mesh_phase, mesh_size, wall, time_step, bulk };
std::string word(DepthErrorSource source);  // "mesh phase", "mesh size", "wall", "time step", "K"

inline constexpr double depth_error_level = 0.95;  // of every half width

struct ErrorPart {
  DepthErrorSource source;
  std::optional<double> half_width;  // m; nothing: not known as a number
  std::string how;                   // where the number comes from, or why there is none
  bool by_rule = false;              // a bound from other scenes' runs: this scene's own may replace it
};

struct DepthError {
  std::vector<ErrorPart> parts;  // one a source
  std::string belongs_to;        // "elements of 1/10 radius"; empty where the depth is that of h = 0
  // What h/l leaves in the depth, by rule; nothing without an erosion length, or at h = 0.
  std::optional<ErrorPart> bias;

  // m: the root of the sum of squares of the known parts, without the bias; nothing where none is known.
  std::optional<double> half_width() const;
  const ErrorPart& of(DepthErrorSource source) const;
};

// What a better setting did to the depth, replicate by replicate on the same meshes at the same speeds.
struct MeasuredEffect {
  DepthErrorSource source;    // wall, time_step or bulk
  double difference = 0;      // m, mean change of the depth
  double standard_error = 0;  // m, of that mean, from the pairs
  int pairs = 0;              // two or more
};

// The better settings that are measured: half the time step, the wall 1.5 times as far, twice K.
inline constexpr double finer_step = 0.5, farther_wall = 1.5, stiffer_bulk = 2;

// A depth at h = 0 from two phase means, by a parabola in h. docs/theory/errors.md (14)
struct Extrapolation {
  double depth = 0;           // m
  double standard_error = 0;  // m, of the phases
  double model_error = 0;     // m, how much farther a line would go, or a share of the depth
  double elements_per_radius = 0, finer_elements_per_radius = 0;
  double mesh_depth = 0, finer_depth = 0;  // m, the phase means
  int replicates = 0;                      // on each
};

struct ErrorEvidence {
  std::vector<MeasuredEffect> effects = {};  // sources without one go by rule
  std::optional<Extrapolation> extrapolation = {};
  // Shares of the depth, standard errors, where a study of the scene says so: of the element's size, and of the runs' mean.
  std::optional<double> discretisation = {}, noise = {};
  std::vector<std::string> notes = {};  // what was asked for and could not be measured, and why
};

// Of replicates that all stopped: penetration.depth is there.
DepthError depth_error(const Scene& scene, const Reduction& reduction, const Penetration& penetration,
                       const ErrorEvidence& evidence = {});

// Half width of the mean of `runs` whose mean has this standard error: Student's t. Nothing for fewer than two.
std::optional<double> phase_half_width(std::optional<double> standard_error, int runs);

}  // namespace percal
