#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fairlight/stats/seed.h>

namespace fairlight {
namespace {

TEST(Seed, IsPrintedAsSixteenDigits) {
  EXPECT_EQ(seed_text(0), "0000000000000000");
  EXPECT_EQ(seed_text(0xFEDCBA9876543210u), "fedcba9876543210");
}

RC_GTEST_PROP(Seed, IsReadAsItWasPrinted, (std::uint64_t seed)) { RC_ASSERT(parse_seed(seed_text(seed)) == seed); }

TEST(Seed, MayBeShort) { EXPECT_EQ(parse_seed("2A"), 42u); }

TEST(Seed, RefusesWhatIsNotHexadecimal) {
  for (const char* text : {"", "0x1", "-1", "g", "1 ", "11111111111111111"}) {
    EXPECT_THROW(parse_seed(text), std::invalid_argument) << text;
  }
}

TEST(Seed, IsFreshEachTime) { EXPECT_NE(fresh_seed(), fresh_seed()); }

}  // namespace
}  // namespace fairlight
