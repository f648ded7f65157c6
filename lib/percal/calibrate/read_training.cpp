// [training].
#include <algorithm>

#include "percal/calibrate/read_job.hpp"
#include "percal/invert/emulator.hpp"

namespace percal {
namespace {

constexpr int most_elements_per_radius = 1000, most_runs = 1000000;
constexpr int least_initial_runs = 2 * sphere_inputs;  // fewer make no emulator
const Range share{.low = 0, .high = 1, .words = "a share from 0 to 1, as 0.15 or \"15 %\""};
const Range some_share{
    .low = 0, .high = 1, .low_open = true, .words = "a share above 0 and up to 1, as 0.5 or \"50 %\""};

}  // namespace

void read_training(const TomlTable& root, CalibrationJob& job) {
  const auto block = root.optional_table("training");
  if (!block) return;
  TrainingSettings& t = job.training;
  t.coarse = block->integer("coarse", 1, most_elements_per_radius, t.coarse);
  t.fine = block->integer("fine", 1, most_elements_per_radius, t.fine);
  t.verify = block->integer("verify", 1, most_elements_per_radius, t.verify);
  if (t.fine < t.coarse) block->refuse("fine", "a mesh coarser than coarse", "as many elements per radius or more");
  if (t.verify < t.fine) block->refuse("verify", "a mesh coarser than fine", "as many elements per radius or more");
  t.initial = block->integer("initial", least_initial_runs, most_runs, t.initial);
  t.batch = block->integer("batch", 1, most_runs, t.batch);
  t.most = block->integer("most", t.initial, most_runs, std::max(t.most, t.initial));
  t.fine_share = share_from(*block, "fine_share", share, t.fine_share);
  t.accuracy = share_from(*block, "accuracy", some_share, t.accuracy);
  t.failures_tolerated = share_from(*block, "failures_tolerated", share, t.failures_tolerated);
  t.verify_replicates = block->integer("verify_replicates", 1, 100, t.verify_replicates);
  t.seed = static_cast<unsigned>(block->integer("seed", 0, 2147483647, static_cast<int>(t.seed)));
}

}  // namespace percal
