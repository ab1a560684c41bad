#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fairlight/estimators/stratified.h>

namespace fairlight {
namespace {

using Cell = std::pair<int, int>;

// The cells of dimensions 2k and 2k + 1, point by point.
std::vector<Cell> cells(const Stratified<double>& set, int k) {
  std::vector<Cell> visited;
  for (std::uint32_t i = 0; i < set.size(); ++i) {
    auto source = set.source(i);
    for (int skipped = 0; skipped < k; ++skipped) next_pair<double>(source);
    const Vec2<double> u = next_pair<double>(source);
    visited.emplace_back(static_cast<int>(u.x() * set.columns()), static_cast<int>(u.y() * set.rows()));
  }
  return visited;
}

TEST(Stratified, ChoosesAGridThatHoldsItsPoints) {
  const auto grid = [](std::uint32_t n) {
    const Stratified<double> set(StreamKey(1, "test"), 0, n);
    return std::pair(set.columns(), set.rows());
  };
  EXPECT_EQ(grid(1), std::pair(1u, 1u));
  EXPECT_EQ(grid(2), std::pair(2u, 1u));
  EXPECT_EQ(grid(12), std::pair(4u, 3u));
  EXPECT_EQ(grid(16), std::pair(4u, 4u));
  EXPECT_EQ(grid(17), std::pair(5u, 4u));
  EXPECT_EQ(grid(1u << 28), std::pair(1u << 14, 1u << 14));
}

RC_GTEST_PROP(Stratified, LeavesFewerCellsThanColumnsEmpty, ()) {
  const std::uint32_t n = *rc::gen::inRange<std::uint32_t>(1, 1u << 28);
  const Stratified<double> set(StreamKey(1, "test"), 0, n);
  RC_ASSERT(set.columns() * set.rows() >= n);
  RC_ASSERT(set.columns() * set.rows() - n < set.columns());
}

// Uses grids whose cells begin at exact doubles, so that a number identifies its cell.
RC_GTEST_PROP(Stratified, HasNoTwoPointsInOneCellOfAnyPair, (std::uint64_t seed, std::uint32_t replicate)) {
  const auto n = *rc::gen::element<std::uint32_t>(1, 2, 4, 7, 8, 13, 14, 15, 16, 61, 62, 63, 64, 1024);
  const Stratified<double> set(StreamKey(seed, "test"), replicate, n);
  for (int k = 0; k < 10; ++k) {
    const auto visited = cells(set, k);
    RC_ASSERT(std::set<Cell>(visited.begin(), visited.end()).size() == n);
  }
}

TEST(Stratified, VisitsTheCellsOfEveryPairInAnotherOrder) {
  const Stratified<double> set(StreamKey(1, "test"), 0, 64);
  std::set<std::vector<Cell>> orders;
  for (int k = 0; k < 20; ++k) orders.insert(cells(set, k));
  EXPECT_EQ(orders.size(), 20u);
}

}  // namespace
}  // namespace fairlight
