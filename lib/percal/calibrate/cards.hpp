// Material cards of a calibration: one for each hypothesis and material, with its intervals.             docs/formats/cards.md
#pragma once
#include <vector>

#include "percal/calibrate/result.hpp"
#include "percal/card/card_material.hpp"

namespace percal {

// At the best minimum of the hypothesis, none without one. A card is named after its material, and after its hypothesis too where the
// job has several. K/mu is the largest of the runs that answer for the material's shots, least_bulk_ratio at
// least. Data: the job and its tables as far as they can be read.
std::vector<CardMaterial> calibration_cards(const CalibrationJob& job, const HypothesisResult& result);

}  // namespace percal
