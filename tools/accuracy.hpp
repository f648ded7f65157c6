// percal impact --accuracy: the setting that the scene's study advises for an error.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "commands.hpp"
#include "percal/store/store.hpp"
#include "percal/study/advised_setting.hpp"

namespace percal::tools {

// "2%" or "0.02" -> 0.02. Throws BadInput.
double parse_accuracy(const std::string& text);

struct AccuracyChoice {
  AdvisedSetting advice;
  LadderOptions ladder;
  bool study_was_kept = false;  // else it was run for this
  CampaignCost study_cost;
  bool can_be_run() const;  // found, and not far beyond the ladder's finest mesh
  std::string refusal() const;
};

// From the study that the store keeps of this scene; where there is none the default ladder is run, and kept.
AccuracyChoice choose_setting(const Scene& scene, double target, Store& store, const Common& common);

// The scene with the advised mesh, replicates, time step and arithmetic.
Scene with_setting(const Scene& scene, const AccuracyChoice& choice);

nlohmann::json accuracy_to_json(const AccuracyChoice& choice);

}  // namespace percal::tools
