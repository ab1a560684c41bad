#include <gtest/gtest.h>

#include <fairlight/stats/replicates.h>

namespace fairlight {
namespace {

const Trial trial{"replicates", 1, 1e-6, 0.01, 0.05};

double alternating(std::uint64_t r) { return r % 2 == 0 ? 0.9 : 1.1; }

TEST(Replicates, AreTheDraws) {
  EXPECT_EQ(test_replicates(trial, Reference{1, 0, 2}, alternating).verdict, Verdict::certified);
  EXPECT_EQ(test_replicates(trial, Reference{1.2, 0, 2.5}, alternating).verdict, Verdict::biased);
  EXPECT_EQ(test_replicates(trial, 1.0, alternating).verdict, Verdict::certified);
  EXPECT_EQ(test_replicates(trial, 1.2, alternating).verdict, Verdict::biased);
}

}  // namespace
}  // namespace fairlight
