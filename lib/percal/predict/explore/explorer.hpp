// A page to play with a finished calibration: sliders for shot and material, depths by the emulator in the browser. It holds a twin of
// the Predictor in JavaScript (model.js) and fetches nothing.                                     docs/formats/report.md
#pragma once
#include <map>
#include <string>

#include "percal/predict/shot_model.hpp"

namespace percal {

// The page's style, elements and scripts, by their names in this folder, as cmake/PercalEmbed.cmake put them in.
const std::map<std::string, std::string>& embedded_explorer();

// What the page computes from: the model's hypotheses and shots, and the emulator after its runs have been learnt from.
page::Json explorer_data(const ShotModel& model);

// `result`: the file that the model is from, as the user named it. Throws BadInput for settings with which there is no emulator.
std::string explorer_page(const ShotModel& model, const std::string& result);

}  // namespace percal
