// calibrate: curves and depths together.
//
// Moduli, exponents and erosion strains, free, held or shared between materials, in every hypothesis of the data that the
// job names; checked by fresh runs.
//
//     const percal::CalibrationJob job = percal::read_calibration_job("joint.toml");
//     const percal::CalibrationResult found =
//         percal::calibrate(job, store, campaign, {.budget_seconds = 60}, [](const std::string& sentence) {});
//
// See docs/formats/calibrate.md, docs/theory/calibration.md.
#pragma once
#include "percal/calibrate/calibration.hpp"
#include "percal/calibrate/job.hpp"
#include "percal/calibrate/page/page.hpp"
#include "percal/calibrate/result.hpp"
