// Finished runs of spheres over the box that users live in, the same for every gel, skin and ball: what is learnt from them need not be run
// again.                                                                                          docs/theory/atlas.md
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "percal/invert/emulator.hpp"

namespace percal {

struct Atlas {
  std::string name;     // of its file
  std::string setting;  // setting_of() its runs: problems of another setting learn nothing from them
  std::vector<TrainingRun> runs;

  // Of a run of one layer: whether it stopped there. Others have a reach behind it (invert/reach.hpp).
  static bool stopped(const TrainingRun& run) { return run.log_depth < run.at.log_layer_depth; }
};

// As data/atlas has it; `name` is what messages call it. Throws BadInput.
Atlas parse_atlas(const std::string& text, const std::string& name);
std::string atlas_text(const std::string& setting, const std::vector<TrainingRun>& runs);

// Those that percal carries.
const std::vector<Atlas>& own_atlases();
// The one for this setting; null where there is none, as after a change of the solver.
const Atlas* own_atlas(const std::string& setting);

// The `most` runs of the smallest distance, in their order. The same input gives the same runs.
std::vector<TrainingRun> nearest_runs(const std::vector<TrainingRun>& runs, std::size_t most,
                                      const std::function<double(const TrainingRun&)>& distance);

// How far a run is from a sphere for what it tells of it: squares over the lengths that depths vary over.
std::function<double(const TrainingRun&)> feature_distance(const SphereInputs& at);

// The runs about a sphere, and what they say of its reach on elements of size h: an emulator of its own for each place, which costs a tenth
// of a second or two, and afterwards microseconds for each answer near by.
Emulator emulator_near(const Atlas& atlas, const SphereInputs& at);

// The same with the hyperparameters of the whole atlas in place of the region's own, in milliseconds: for a first look.
Emulator roughly_near(const Atlas& atlas, const SphereInputs& at);

}  // namespace percal
