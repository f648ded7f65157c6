// What a training begins with: runs of the atlas, and of other jobs that the store has.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "percal/atlas/atlas.hpp"
#include "percal/calibrate/shot_problem.hpp"
#include "percal/calibrate/training.hpp"
#include "percal/campaign/sphere_runs.hpp"
#include "percal/math/draws.hpp"
#include "percal/problem/replicates.hpp"
#include "percal/text/sha256.hpp"

namespace percal {
namespace {

constexpr int most_foreign = 600;
constexpr std::size_t most_of_atlas = 600;
constexpr int places_for_each = 64;     // of a shot's layer in the parameters' box, to be near to
constexpr double coarsest_foreign = 6;  // elements, as the job's settings count them, that are fine enough for any job

}  // namespace

std::string foreign_note(const CalibrationJob& job, const std::string& key_prefix) {
  return fmt::format("calibration {} {}", sha256(job.text), key_prefix);
}

std::string Training::setting() const {
  std::vector<double> natural;
  for (const auto& [kind, free] : job_.parameters) natural.push_back(free.natural(free.middle()));
  const MeasuredShot& shot = job_.shots[shots_of_body(0).front()];
  const CoveredMaterial material = target_at(job_, hypothesis_, job_.targets[shot.target], natural);
  return setting_of(shot_problem(job_, shot, material, mesh_of(shot, material, job_.training.coarse)));
}

// Those whose sphere went about as deep as a measured one of about that density, at an exponent and a strain that the job allows: whatever
// the modulus, which is what the job is about.
void Training::take_runs_of_atlas() {
  const Atlas* atlas = own_atlas(setting());
  if (!atlas) return;
  struct Sought {
    SphereInputs at;
    double log_depth;
  };
  std::vector<Sought> sought;
  const Eigen::MatrixXd points = sobol_points(places_for_each, static_cast<int>(job_.parameters.size()), 0);
  for (const MeasuredShot& shot : job_.shots) {
    if (!tells_depth(shot) || shot.body) continue;
    for (Eigen::Index k = 0; k < points.rows(); ++k)
      sought.push_back(
          {shot_inputs(shot, target_at(job_, hypothesis_, job_.targets[shot.target], numbers_at(points.row(k)))).at,
           std::log(shot.depth / shot.radius)});
  }
  const auto distance = [&](const TrainingRun& run) {
    double least = INFINITY;
    for (const auto& [at, log_depth] : sought) {
      const double by_depth = (run.log_depth - log_depth) / 0.5, by_density = run.at.log_pi5 - at.log_pi5,
                   by_alpha = (run.at.alpha - at.alpha) / 4,
                   by_layer = (run.at.log_layer_depth - at.log_layer_depth) / 2,
                   by_strain = std::log(run.at.erosion_strain / at.erosion_strain) / 0.6,
                   by_length = (run.at.log_erosion_length - at.log_erosion_length) / 0.7;
      least = std::min(least, by_depth * by_depth + by_density * by_density + by_alpha * by_alpha +
                                  by_layer * by_layer + by_strain * by_strain + by_length * by_length);
    }
    return least;
  };
  std::vector<TrainingRun> usable;
  for (const TrainingRun& run : atlas->runs)
    if (run.log_depth >= least_learnt_ && (learns_passage(job_) || Atlas::stopped(run))) usable.push_back(run);
  learnt_[{}].runs = nearest_runs(usable, most_of_atlas, distance);
  report_.from_atlas = static_cast<int>(learnt_[{}].runs.size());
}

void Training::take_foreign_runs() {
  if (!store_) return;
  const std::string name = foreign_note(job_, stored_spheres_prefix());
  std::vector<StoredSphere> stored = stored_spheres(*store_);
  std::sort(stored.begin(), stored.end(), [](const auto& a, const auto& b) { return a.key < b.key; });
  const std::string setting = this->setting();
  const auto usable = [&](const StoredSphere& s) {
    return s.reach && std::log(*s.reach) >= least_learnt_ && s.problem.below.size() <= covers_of(job_) &&
           (learns_passage(job_) || s.outcome == word(Outcome::stopped)) && setting_of(s.problem) == setting &&
           s.problem.elements_per_radius >=
               std::min(job_.training.coarse, coarsest_foreign) / erosion_length(s.problem).value_or(1) -
                   phase_span / 2;
  };
  if (!store_->note(name)) {
    std::string keys;
    int count = 0;
    for (const auto& s : stored)
      if (usable(s) && count++ < most_foreign) keys += s.key + "\n";
    store_->put_note(name, keys);
  }
  std::istringstream keys(*store_->note(name));
  for (std::string key; std::getline(keys, key);) {
    const auto found = std::lower_bound(stored.begin(), stored.end(), key,
                                        [](const auto& s, const std::string& k) { return s.key < k; });
    if (found == stored.end() || found->key != key || !usable(*found)) continue;
    taken_.push_back(key);
    learnt_[{}].runs.push_back(training_run(found->problem, *found->reach));
    ++report_.foreign;
  }
}

}  // namespace percal
