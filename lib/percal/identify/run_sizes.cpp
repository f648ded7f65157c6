#include "percal/identify/run_sizes.hpp"

#include <algorithm>

#include "percal/identify/impacts.hpp"

namespace percal {

RunSize largest_run(const IdentifyJob& job) {
  const auto* scan = std::get_if<AlphaScan>(&job.alpha);
  const double alpha = scan ? scan->candidates.front() : std::get<AlphaGiven>(job.alpha).alpha;
  double finest = std::max(job.ridge.elements_per_radius, job.check_elements_per_radius);
  if (scan) finest = std::max(finest, scan->elements_per_radius);
  for (const double mesh : job.mesh_study) finest = std::max(finest, mesh);
  for (const PredictionSet& set : job.predictions) finest = std::max(finest, set.elements_per_radius);
  // In radii all layers are one.
  const Scene scene = impact_scene(job, job.calibration,
                                   {job.tissue.density, job.ridge.start, alpha, job.ridge.erosion_strains.front()},
                                   job.volumetric, finest);
  const Problem problem = reduce(scene).problem;
  refuse_what_is_too_large(problem, job.file,
                           {"elements_per_radius", "layer.depth_over_radius", "layer.width_over_radius"});
  return size_of(problem);
}

}  // namespace percal
