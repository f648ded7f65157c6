// percal calibrate on the command line.
#include <gmock/gmock.h>

#include "calibrate/small_job.hpp"

namespace percal {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

class CalibrateCommand : public calibrate_test::SmallJob {};

TEST_F(CalibrateCommand, CheckReadsTheJobAndRunsNothing) {
  job();
  const auto before = files();
  const auto ended = run({"calibrate", "job.toml", "--check"});
  EXPECT_EQ(ended.code, 0);
  EXPECT_THAT(ended.out,
              HasSubstr("job.toml: a job that can be run: 4 parameters, 6 shots (4 fitted), 1 curves, 2 hypotheses"));
  EXPECT_EQ(files(), before);
  const auto as_json = run({"calibrate", "job.toml", "--check", "--json"});
  const json said = json::parse(as_json.out);
  EXPECT_EQ(said["job"], "job.toml");
  EXPECT_EQ(said["valid"], true);
  EXPECT_GT(said["largest_run"]["elements"], 1000);
}

TEST_F(CalibrateCommand, ABadJobEndsWithCode2) {
  job({{"level = 0.9", "level = 95"}});
  const auto ended = run({"calibrate", "job.toml", "--check"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("job.toml:2: level: found 95"));
}

TEST_F(CalibrateCommand, ABudgetIsATimeWithItsUnit) {
  job();
  for (const char* good : {"60s", "5 min", "0.5h"})
    EXPECT_EQ(run({"calibrate", "job.toml", "--check", "--budget", good}).code, 0) << good;
  for (const char* bad : {"60", "60 m", "-5s", "0s", "soon"}) {
    const auto ended = run({"calibrate", "job.toml", "--check", "--budget", bad});
    EXPECT_EQ(ended.code, 2) << bad;
    EXPECT_THAT(ended.err, AllOf(HasSubstr("--budget"), HasSubstr("a positive time with its unit"))) << bad;
  }
}

TEST_F(CalibrateCommand, AFolderThatCannotBeWrittenEndsWithCode4BeforeAnyRun) {
  job();
  write("taken", "a file");
  const auto ended = run({"calibrate", "job.toml", "--out", "taken/out", "--store", "store"});
  EXPECT_EQ(ended.code, 4);
  EXPECT_FALSE(files().contains("store"));
}

}  // namespace
}  // namespace percal
