#include <algorithm>
#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fairlight/render/settings.h>

namespace fairlight {
namespace {

TEST(SampleLedger, JoinsAdjacentRangesInAnyOrder) {
  SampleLedger ledger;
  ledger.add(1, {10, 20});
  ledger.add(1, {30, 40});
  ledger.add(1, {20, 30});
  EXPECT_EQ(ledger.json().dump(), R"({"0000000000000001":[[10,40]]})");
  EXPECT_EQ(ledger.next(1), 40u);
  EXPECT_EQ(ledger.next(2), 0u);
}

TEST(SampleLedger, RefusesToCountASampleTwice) {
  SampleLedger ledger;
  ledger.add(1, {10, 20});
  EXPECT_THROW(ledger.add(1, {0, 11}), std::invalid_argument);
  EXPECT_THROW(ledger.add(1, {19, 30}), std::invalid_argument);
  EXPECT_THROW(ledger.add(1, {12, 13}), std::invalid_argument);
  EXPECT_THROW(ledger.add(1, {0, 30}), std::invalid_argument);
  EXPECT_NO_THROW(ledger.add(2, {10, 20}));
  EXPECT_THROW(ledger.add(1, {50, 50}), std::invalid_argument);
}

TEST(SampleLedger, RefusesMoreSamplesThanItCounts) {
  constexpr std::uint64_t half = std::uint64_t{1} << 63;
  SampleLedger ledger;
  ledger.add(1, {0, half});
  ledger.add(2, {0, half - 1});
  EXPECT_EQ(ledger.total(), 2 * half - 1);
  EXPECT_THROW(ledger.add(3, {0, 1}), std::invalid_argument);
}

TEST(SampleLedger, KnowsItsOnlySeed) {
  SampleLedger ledger;
  ledger.add(7, {0, 1});
  EXPECT_EQ(ledger.seed(), 7u);
  ledger.add(8, {0, 1});
  EXPECT_THROW((void)ledger.seed(), std::invalid_argument);
}

RC_GTEST_PROP(SampleLedger, IsTheSetOfItsSamples, ()) {
  const int n = *rc::gen::inRange(1, 40);
  std::vector<int> order(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) order[static_cast<std::size_t>(i)] = i;
  for (std::size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1], order[*rc::gen::inRange<std::size_t>(0, i)]);
  SampleLedger ledger;
  for (int i : order) ledger.add(3, {static_cast<std::uint64_t>(i), static_cast<std::uint64_t>(i) + 1});
  SampleLedger whole;
  whole.add(3, {0, static_cast<std::uint64_t>(n)});
  RC_ASSERT(ledger.json() == whole.json());
  RC_ASSERT(SampleLedger::from_json(ledger.json()).json() == ledger.json());
}

}  // namespace
}  // namespace fairlight
