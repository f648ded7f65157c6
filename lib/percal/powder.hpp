// powder: where a powder ends up, and which powder ends up where it is wanted.
//
// A powder as distributions, what a calibration knows of depths as a forward model, the dose over depth with its intervals.
//
//     const percal::PowderJob job = percal::read_powder_job("powder.toml");
//     const percal::ShotModel calibration = percal::kept_shot_model(result, "skin.out/result.json");
//     const percal::DoseAnswer answer = percal::answer_dose(job, calibration);
//
// See docs/theory/powder.md.
#pragma once
#include "percal/powder/design_answer.hpp"
#include "percal/powder/dose_answer.hpp"
#include "percal/powder/job.hpp"
#include "percal/powder/page/page.hpp"
