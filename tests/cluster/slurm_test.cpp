#include "percal/cluster/slurm.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "percal/cluster/coordinator.hpp"

namespace percal {
namespace {

using testing::HasSubstr;

TEST(Slurm, AScriptSaysWhatTheOptionsSayAndNoMore) {
  const SlurmOptions options{.folder = "/shared/it's here", .program = "/opt/percal", .level = "x86_64_v3"};
  const std::string plain = array_script(options, "7-1-0", 12);
  EXPECT_THAT(plain, HasSubstr("#SBATCH --array=0-11\n"));
  EXPECT_THAT(plain, HasSubstr("--requeue"));
  EXPECT_THAT(plain, HasSubstr("export PERCAL_ISA=x86_64_v3\n"));
  EXPECT_THAT(plain,
              HasSubstr("exec '/opt/percal' work '/shared/it'\\''s here/todo/7-1-0'/\"$SLURM_ARRAY_TASK_ID\"\n"));
  for (const char* word : {"--partition", "--time", "%4"}) EXPECT_THAT(plain, Not(HasSubstr(word)));
  SlurmOptions all = options;
  all.partition = "short";
  all.time = "30";
  all.at_once = 4;
  for (const char* line : {"#SBATCH --partition=short\n", "#SBATCH --time=30\n", "#SBATCH --array=0-11%4\n"})
    EXPECT_THAT(array_script(all, "7-1-0", 12), HasSubstr(line));
}

TEST(Slurm, TasksInTheQueueAreThoseOfTheFolderAlone) {
  const std::string own = job_prefix("/shared/a"), other = job_prefix("/shared/b");
  EXPECT_NE(own, other);
  const auto tasks = tasks_in(
      "somebody N/A\n" + own + "1-2-0 3\n" + other + "1-2-0 4\nsqueue: error: slow\n" + own + "1-2-0 10\n", own);
  EXPECT_THAT(tasks, testing::ElementsAre(SlurmTask{"1-2-0", 3}, SlurmTask{"1-2-0", 10}));
}

TEST(Slurm, ATaskHasAMinutesWorkOrABatch) {
  Problem p;
  p.pi4 = 10;
  p.density_ratio = 8;
  p.alpha = 8;
  p.erosion = StrainErosion{0.8};
  std::vector<Problem> problems(100, p);
  const double minute = 60 * 80e6;
  const auto tasks = in_tasks(problems, {});
  std::size_t runs = 0;
  for (const auto& task : tasks) {
    runs += task.size();
    EXPECT_TRUE(task.size() == 1 || static_cast<double>(task.size()) * work_of(p) <= minute);
  }
  EXPECT_EQ(runs, 100);
  EXPECT_EQ(in_tasks(problems, {.batch = 30}).size(), 4);
}

}  // namespace
}  // namespace percal
