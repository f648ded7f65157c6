// The result of an impact: what was found, as the JSON that impact_page() reads.                 docs/formats/impact.md
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "percal/observe/depth_error.hpp"
#include "percal/observe/penetration.hpp"
#include "percal/page/result.hpp"
#include "percal/scene/scene.hpp"

namespace percal {

// Mesh and replicates that the scene's study, or the atlas in its place, advises for an error of the depth. Errors are shares of the depth.
struct AdvisedAccuracy {
  double target_error = 0;
  std::string why_not = "";                        // why nothing was run for it; empty: something was
  bool is_extrapolated = false;                    // beyond the meshes of the study
  std::optional<double> elements_per_radius = {};  // none: no setting reaches the error
  std::optional<int> replicates = {};
  std::optional<double> discretisation_error = {}, noise_error = {}, error = {};
  std::optional<double> cpu_seconds = {}, cpu_seconds_low = {}, cpu_seconds_high = {};
  std::optional<AtlasDepth> atlas = {};  // there: the advice is the atlas's, and there is no study
  // The study: its meshes, the runs on each, its time step; whether the store had it, and what it cost now.
  std::vector<double> studied_meshes = {};
  int studied_replicates = 0;
  double time_step_factor = 0;
  bool study_was_kept = false;
  double study_cpu_seconds = 0;
};

struct WrittenFields {
  std::string list;  // path of NAME.pvd
  std::size_t frames = 0;
};

struct ImpactFindings {
  const Scene& scene;  // as it was run
  const Reduction& reduction;
  std::vector<Evaluation> runs = {};  // the replicates; none where the accuracy asked for is out of reach
  Penetration penetration = {};       // of the runs
  page::Cost cost = {};
  std::optional<AdvisedAccuracy> accuracy = {};
  ErrorEvidence evidence = {};  // what was measured of the depth's error
  std::optional<WrittenFields> fields = {};
  std::string picture = "";  // file; empty: none
};

// Why runs that the atlas advised are not to be joined with it, in a sentence: not all stopped, or the 95 % intervals of both means, and
// what the wall may do, leave a gap. Empty where they are.
std::string against_atlas(const ImpactFindings& findings);

page::Json impact_to_json(const ImpactFindings& findings);

}  // namespace percal
