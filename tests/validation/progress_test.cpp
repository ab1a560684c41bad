#include <gtest/gtest.h>

#include <fairlight/validation/app/progress.h>

namespace fairlight {
namespace {

TEST(ProgressLine, SaysHowMuchIsDoneAndHowLongItWillTake) {
  EXPECT_EQ(progress_line("verify", 0.5, 20), "verify [###############...............] 50 %, 20 s left");
  EXPECT_EQ(progress_line("verify", 0.25, 20), "verify [#######.......................] 25 %, 60 s left");
  EXPECT_EQ(progress_line("verify", 0.1, 60), "verify [###...........................] 10 %, 9 min left");
}

}  // namespace
}  // namespace fairlight
