#include "percal/calibrate/read_job.hpp"

#include "percal/scene/scene_toml.hpp"
#include "percal/text/file.hpp"

namespace percal {
namespace {

const Range confidence{.low = 0.5, .high = 0.9999, .words = "a confidence from 0.5 to 0.9999"};

SolverScene read_solver(const TomlTable& root) {
  const auto block = root.optional_table("solver");
  if (!block) return {};
  const SolverScene solver = solver_from(*block);
  if (solver.end_time)
    block->refuse("end_time", "a time for all spheres, small and large",
                  "no end_time in a job: runs end when the sphere stops");
  return solver;
}

}  // namespace

CalibrationJob read_calibration_job(const std::string& path) {
  CalibrationJob job;
  job.file = path;
  job.text = read_file(path);
  const TomlTable root = parse_toml(job.text, path);
  job.title = root.text("title", path);
  job.level = root.number("level", confidence, job.level);
  job.bootstrap = root.integer("bootstrap", 0, 100000, job.bootstrap);
  job.dehn = root.flag("dehn", job.dehn);
  job.solver = read_solver(root);
  read_training(root, job);
  read_parameters(root, job);
  read_materials(root, job);
  read_scatter_groups(root, job);
  read_shots(root, job);
  read_job_curves(root, job);
  read_hypotheses(root, job);
  read_cross_validations(root, job);
  read_published(root, job);
  root.finish();
  check_use(root, job);
  return job;
}

}  // namespace percal
