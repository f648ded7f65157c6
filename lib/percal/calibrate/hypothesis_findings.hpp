// What a reader must know about one hypothesis beside its numbers, in sentences.
#pragma once
#include "percal/calibrate/job_fit.hpp"

namespace percal {

std::vector<std::string> hypothesis_findings(const CalibrationJob& job, const JobFit& fit,
                                             const HypothesisResult& result);

// About all hypotheses together: what they hold that the others contradict, how far the choices move the result, where the closed
// form does better.
std::vector<std::string> overall_findings(const CalibrationJob& job, const CalibrationResult& result);

}  // namespace percal
