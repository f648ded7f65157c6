// Whether the data of a job say one thing: each material fitted once with its curves and its depths joined by a rate factor that is
// free, and that factor set beside the job's.                                                    docs/theory/calibration.md
#pragma once
#include "percal/calibrate/job_fit.hpp"
#include "percal/calibrate/result.hpp"

namespace percal {

// Data contradict each other where an interval of this level says so: one in twenty of the usual ones does by chance.
inline constexpr double level_of_contradiction = 0.999;
// A scatter about the model above this is none that shots or curves have: the model does not describe them.
inline constexpr double most_scatter = 0.4;
// Engineering. Soft gels and skin have torn before four times their length.
inline constexpr double most_erosion_strain = 3;

// What is known of one hypothesis after its fit. No runs are made.
Verdict verdict_of(const CalibrationJob& job, int hypothesis, const JobModel& model, const JobFit& fit);

// Of the hypothesis that contradicts itself least.
DataAgreement least_contradicted(const std::vector<HypothesisResult>& hypotheses);

}  // namespace percal
