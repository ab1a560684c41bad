#include <set>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fairlight/estimators/padded_strata.h>

namespace fairlight {
namespace {

template <class Real>
std::array<double, 5> numbers_at(const PaddedStrata& numbers, std::uint32_t pixel, std::uint32_t sample) {
  using W = Word<Real>;
  const SampleBlock<Real> block = numbers.block<Real>({W(pixel), W(sample), W(3u)}, 1);
  std::array<double, 5> first{};
  for (std::size_t d = 0; d < first.size(); ++d) {
    std::array<double, lanes<Real>> u{};
    store_lanes(block[d], u.data());
    first[d] = u[0];
  }
  return first;
}

template <class Real>
void expect_one_point_in_each_cell(std::uint64_t seed, std::uint32_t pixel) {
  const int m = *rc::gen::inRange(0, 11);
  const std::uint32_t n = 1u << m;
  const PaddedStrata numbers(StreamKey(seed, "test"), n);
  const int columns = 1 << ((m + 1) / 2), rows = 1 << (m / 2);
  std::set<std::pair<int, int>> cells, others;
  std::set<int> strata;
  for (std::uint32_t i = 0; i < n; ++i) {
    const auto u = numbers_at<Real>(numbers, pixel, 7 * n + i);
    for (const double number : u) RC_ASSERT(number >= 0 && number < 1);
    cells.insert({static_cast<int>(u[0] * columns), static_cast<int>(u[1] * rows)});
    others.insert({static_cast<int>(u[2] * columns), static_cast<int>(u[3] * rows)});
    strata.insert(static_cast<int>(u[4] * n));
  }
  RC_ASSERT(cells.size() == n);
  RC_ASSERT(others.size() == n);
  RC_ASSERT(strata.size() == n);
}

RC_GTEST_PROP(PaddedStrata, HaveOnePointInEachCell, (std::uint64_t seed, std::uint32_t pixel)) {
  expect_one_point_in_each_cell<double>(seed, pixel);
  expect_one_point_in_each_cell<Packet>(seed, pixel);
}

// A single cell gives the jitter alone. With 16 points the first two digits are the cell's, and the
// rest are the jitter's.
TEST(PaddedStrata, JitterWithinACellByIndependentNumbers) {
  const StreamKey key(1, "test");
  const auto jitter = IndependentNumbers(key).block<double>({2, 5, 3}, 1);
  EXPECT_EQ(numbers_at<double>(PaddedStrata(key, 1), 2, 5), jitter);
  const auto u = numbers_at<double>(PaddedStrata(key, 16), 2, 5);
  for (std::size_t d = 0; d < 4; ++d) EXPECT_NEAR(4 * u[d] - std::floor(4 * u[d]), jitter[d], 0x1p-50);
  EXPECT_NEAR(16 * u[4] - std::floor(16 * u[4]), jitter[4], 0x1p-48);
}

TEST(PaddedStrata, RefuseSetsThatAreNoPowersOfTwo) {
  EXPECT_THROW(PaddedStrata(StreamKey(1, "test"), 12), std::invalid_argument);
}

}  // namespace
}  // namespace fairlight
