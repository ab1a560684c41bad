#include <algorithm>
#include <set>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fairlight/estimators/latin_hypercube.h>

namespace fairlight {
namespace {

// Allows for one step of the grid of numbers, as a stratum may begin between two numbers.
RC_GTEST_PROP(LatinHypercube, HasOnePointInEachStratumOfEveryDimension,
              (std::uint64_t seed, std::uint32_t replicate)) {
  const std::uint32_t n = *rc::gen::inRange<std::uint32_t>(1, 500);
  const LatinHypercube<double> set(StreamKey(seed, "test"), replicate, n);
  std::vector<std::vector<double>> at(20);
  for (std::uint32_t i = 0; i < n; ++i) {
    auto source = set.source(i);
    for (auto& dimension : at) dimension.push_back(source.next());
  }
  for (auto& dimension : at) {
    std::sort(dimension.begin(), dimension.end());
    for (std::uint32_t i = 0; i < n; ++i) {
      RC_ASSERT(dimension[i] >= i / double(n) - 0x1p-53);
      RC_ASSERT(dimension[i] <= (i + 1.0) / n);
    }
  }
}

TEST(LatinHypercube, OrdersEveryDimensionAnew) {
  const LatinHypercube<double> set(StreamKey(1, "test"), 0, 64);
  std::set<std::vector<int>> orders;
  for (int d = 0; d < 20; ++d) {
    std::vector<int> order;
    for (std::uint32_t i = 0; i < set.size(); ++i) {
      auto source = set.source(i);
      for (int skipped = 0; skipped < d; ++skipped) source.next();
      order.push_back(static_cast<int>(source.next() * 64));
    }
    orders.insert(order);
  }
  EXPECT_EQ(orders.size(), 20u);
}

}  // namespace
}  // namespace fairlight
