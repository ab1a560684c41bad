#include <gtest/gtest.h>

#include <fairlight/stats/text.h>

namespace fairlight {
namespace {

TEST(Text, IsFormattedAsByPrintf) {
  EXPECT_EQ(formatted("%d of %s at %.1e", 3, "five", 0.25), "3 of five at 2.5e-01");
  EXPECT_EQ(formatted("%s", ""), "");
}

TEST(Text, IsAsLongAsItTakes) {
  const std::string text = formatted("%1000d", 7);
  EXPECT_EQ(text.size(), 1000u);
  EXPECT_EQ(text.find_first_not_of(' '), 999u);
  EXPECT_EQ(text.back(), '7');
}

}  // namespace
}  // namespace fairlight
