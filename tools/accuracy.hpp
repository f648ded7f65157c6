// percal impact --accuracy: the setting that the scene's study, or the atlas, advises for an error.
#pragma once
#include <string>

#include "commands.hpp"
#include "percal/observe/page/impact_json.hpp"
#include "percal/store/store.hpp"
#include "percal/study/advised_setting.hpp"

namespace percal::tools {

// "2%" or "0.02" -> 0.02. Throws BadInput.
double parse_accuracy(const std::string& text);

// From the study that the store keeps of this scene; where there is none from the atlas; where that does not know either the default ladder is
// run, and kept.
AdvisedAccuracy advised_accuracy(const Scene& scene, double target_error, Store& store, const Common& common);

// What the atlas advised, where the runs are not to be joined with it: as many as their scatter needs.
AdvisedAccuracy by_runs_alone(const AdvisedAccuracy& by_atlas);

// The scene with the advised mesh, replicates, time step and arithmetic, where it is to be run.
Scene with_setting(const Scene& scene, const AdvisedAccuracy& advised);

}  // namespace percal::tools
