#include "percal/calibrate/run_sizes.hpp"

#include "percal/calibrate/shot_problem.hpp"

namespace percal {

RunSize largest_run(const CalibrationJob& job) {
  std::vector<double> natural;
  for (const CalibrationParameter& parameter : job.parameters) {
    const FreeParameter& p = parameter.free;
    natural.push_back(p.natural((p.searched(p.low) + p.searched(p.high)) / 2));
  }
  const Hypothesis& any = job.hypotheses.front();
  RunSize largest;
  for (const MeasuredShot& shot : job.shots) {
    const Problem problem = shot_problem(job, shot, material_at(job, any, shot.material, natural), job.training.verify);
    refuse_what_is_too_large(problem, job.file, {"training.verify", "shots.layer_depth", "shots.layer_width"});
    if (const RunSize size = size_of(problem); size.elements > largest.elements) largest = size;
  }
  return largest;
}

}  // namespace percal
