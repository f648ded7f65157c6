#include "percal/base/progress.hpp"

#include <gmock/gmock.h>

namespace percal {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(ProgressLine, IsNeverWiderThanTheTerminal) {
  for (int columns = 20; columns < 200; ++columns)
    EXPECT_LE(static_cast<int>(progress_line("fresh runs at the best points", 7, 400, 125, columns).size()), columns);
}

TEST(ProgressLine, GivesUpTheBarThenTheLabelThenNothing) {
  EXPECT_EQ(progress_line("runs", 15, 30, 8, 80), "runs  15/30  ###############...............  0:08 left");
  EXPECT_EQ(progress_line("runs", 15, 30, 8, 35), "runs  15/30  #####......  0:08 left");
  EXPECT_EQ(progress_line("runs", 15, 30, 8, 24), "runs  15/30  0:08 left");
  EXPECT_EQ(progress_line("runs", 15, 30, 8, 20), "ru  15/30  0:08 left");
}

}  // namespace
}  // namespace percal
