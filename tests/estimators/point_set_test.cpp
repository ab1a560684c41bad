#include <cmath>
#include <set>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fairlight/estimators/latin_hypercube.h>
#include <fairlight/estimators/sobol.h>
#include <fairlight/estimators/stratified.h>

// Tests for all point sets.
namespace fairlight {
namespace {

static_assert(PointSet<OwenSobol<double>> && PointSet<OwenSobol<Packet>>);
static_assert(PointSet<Stratified<double>> && PointSet<Stratified<Packet>>);
static_assert(PointSet<LatinHypercube<double>> && PointSet<LatinHypercube<Packet>>);
static_assert(!PointSet<PhiloxStream<double>>);

template <template <class> class Set>
struct Family {
  template <class Real>
  using Points = Set<Real>;
};

template <class F>
class EveryPointSet : public ::testing::Test {};
using Families = ::testing::Types<Family<OwenSobol>, Family<Stratified>, Family<LatinHypercube>>;
TYPED_TEST_SUITE(EveryPointSet, Families);

// The first numbers of a point; 80 go beyond Sobol's own dimensions.
template <class Set>
std::vector<double> numbers(const Set& set, std::uint32_t point, int count = 80) {
  PointSource<Set> source = set.source(point);
  std::vector<double> all;
  for (int d = 0; d < count; ++d) all.push_back(source.next());
  return all;
}

std::uint32_t any_size() { return *rc::gen::inRange<std::uint32_t>(1, 5000); }

TYPED_TEST(EveryPointSet, GivesAFunctionOfItsAddressInTheUnitInterval) {
  using Set = typename TypeParam::template Points<double>;
  EXPECT_TRUE(rc::check([](std::uint64_t seed, std::uint32_t replicate) {
    const std::uint32_t n = any_size();
    const std::uint32_t point = *rc::gen::inRange<std::uint32_t>(0, n);
    const StreamKey key(seed, "test");
    const auto here = numbers(Set(key, replicate, n), point);
    RC_ASSERT(here == numbers(Set(key, replicate, n), point));
    for (double u : here) RC_ASSERT(u >= 0 && u < 1);
  }));
}

TYPED_TEST(EveryPointSet, DiffersWhenAnyPartOfItsAddressDoes) {
  using Set = typename TypeParam::template Points<double>;
  EXPECT_TRUE(rc::check([](std::uint64_t seed, std::uint32_t replicate) {
    const std::uint32_t n = 1 + any_size();
    const auto here = numbers(Set(StreamKey(seed, "a"), replicate, n), 0, 2);
    RC_ASSERT(here != numbers(Set(StreamKey(seed + 1, "a"), replicate, n), 0, 2));
    RC_ASSERT(here != numbers(Set(StreamKey(seed, "b"), replicate, n), 0, 2));
    RC_ASSERT(here != numbers(Set(StreamKey(seed, "a"), replicate + 1, n), 0, 2));
    RC_ASSERT(here != numbers(Set(StreamKey(seed, "a"), replicate, n), 1, 2));
  }));
}

TYPED_TEST(EveryPointSet, HasNoTwoDimensionsAlike) {
  using Set = typename TypeParam::template Points<double>;
  const auto point = numbers(Set(StreamKey(1, "test"), 0, 16), 0, 200);
  EXPECT_EQ(std::set<double>(point.begin(), point.end()).size(), point.size());
}

TYPED_TEST(EveryPointSet, GivesPacketsTheSameNumbersInTwentyFourDigits) {
  using Doubles = typename TypeParam::template Points<double>;
  using Packets = typename TypeParam::template Points<Packet>;
  EXPECT_TRUE(rc::check([](std::uint64_t seed, std::uint32_t replicate) {
    const std::uint32_t n = any_size();
    const std::uint32_t first = *rc::gen::inRange<std::uint32_t>(0, n);
    const StreamKey key(seed, "test");
    const Packets set(key, replicate, n);
    PointSource<Packets> source = set.source(first);
    std::vector<std::vector<double>> expected;
    for (std::uint32_t i = 0; i < lanes<Packet>; ++i) {
      expected.push_back(numbers(Doubles(key, replicate, n), (first + i) % n));
    }
    for (std::size_t d = 0; d < expected[0].size(); ++d) {
      std::array<double, lanes<Packet>> u{};
      store_lanes(source.next(), u.data());
      for (std::size_t i = 0; i < u.size(); ++i) {
        RC_ASSERT(u[i] < 1);
        RC_ASSERT(u[i] == std::floor(expected[i][d] * 0x1p24) * 0x1p-24);
      }
    }
  }));
}

TYPED_TEST(EveryPointSet, RefusesNoPointsAndTooMany) {
  using Set = typename TypeParam::template Points<double>;
  const StreamKey key(1, "test");
  EXPECT_THROW(Set(key, 0, 0), std::invalid_argument);
  EXPECT_THROW(Set(key, 0, (1u << 28) + 1), std::invalid_argument);
  const Set largest(key, 0, 1u << 28);
  EXPECT_EQ(largest.size(), 1u << 28);
  for (double u : numbers(largest, (1u << 28) - 1)) EXPECT_TRUE(u >= 0 && u < 1) << u;
}

}  // namespace
}  // namespace fairlight
