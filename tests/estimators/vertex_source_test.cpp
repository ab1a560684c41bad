#include <set>
#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fairlight/estimators/concepts.h>
#include <fairlight/estimators/padded_sobol.h>
#include <fairlight/estimators/padded_strata.h>
#include <fairlight/estimators/vertex_source.h>

namespace fairlight {
namespace {

static_assert(UniformSource<VertexSource<double, IndependentNumbers>, double>);
static_assert(UniformSource<VertexSource<Packet, PaddedSobol>, Packet>);

/// Block b of a vertex is 10 b, 10 b + 1, .. 10 b + 4. Numbers that are not computed are -1.
struct CountedNumbers {
  template <class Real>
  SampleBlock<Real> block(const PathVertex<Real>&, std::uint32_t b, BlockPart part) const {
    SampleBlock<Real> numbers;
    for (std::size_t i = 0; i < 5; ++i)
      numbers[i] = Real(part == BlockPart::all || i < 2 ? 10.0 * b + static_cast<double>(i) : -1);
    return numbers;
  }
};

TEST(VertexSource, GivesAShadowRayARouletteAndABounceOneBlock) {
  const CountedNumbers numbers;
  VertexSource<double, CountedNumbers> source(numbers, {0, 0, 0});
  EXPECT_EQ(next_pair<double>(source), Vec2<double>(0, 1));
  EXPECT_EQ(source.next(), 4);
  EXPECT_EQ(next_pair<double>(source), Vec2<double>(2, 3));
  EXPECT_EQ(next_pair<double>(source), Vec2<double>(10, 11));
}

TEST(VertexSource, TakesSingleNumbersFromPairsWhereABlockHasNoMore) {
  const CountedNumbers numbers;
  VertexSource<double, CountedNumbers> source(numbers, {0, 0, 0});
  std::vector<double> drawn;
  for (int i = 0; i < 8; ++i) drawn.push_back(source.next());
  EXPECT_EQ(drawn, (std::vector<double>{0, 1, 4, 2, 3, 10, 11, 14}));
}

TEST(VertexSource, TakesPairsAloneFromBlocksOfWhichNoMoreIsMade) {
  const CountedNumbers numbers;
  VertexSource<double, CountedNumbers> source(numbers, {0, 0, 0}, BlockPart::first_pair);
  EXPECT_EQ(next_pair<double>(source), Vec2<double>(0, 1));
  EXPECT_EQ(next_pair<double>(source), Vec2<double>(10, 11));
  EXPECT_EQ(source.next(), 20);
  EXPECT_EQ(source.next(), 21);
  EXPECT_EQ(source.next(), 30);
}

TEST(IndependentNumbers, AreTheWordsOfABlock) {
  const StreamKey key(1, "test");
  const auto words = Philox<std::uint32_t>::draw({4, 5, 6, 7}, key.words());
  const SampleBlock<double> numbers = IndependentNumbers(key).block<double>({7, 5, 6}, 1);
  EXPECT_EQ(numbers[0], unit_number(words[0], words[1]));
  EXPECT_EQ(numbers[1], unit_number(words[2], words[3]));
  std::array<double, lanes<Packet>> lane{};
  const auto packets =
      IndependentNumbers(key).block<Packet>({Word<Packet>(7u), Word<Packet>(5u), Word<Packet>(6u)}, 1);
  store_lanes(packets[3], lane.data());
  EXPECT_EQ(lane[0], (words[3] >> 8) * 0x1p-24);
  store_lanes(packets[4], lane.data());
  EXPECT_EQ(lane[0], ((words[0] & 255) << 16 | (words[1] & 255) << 8 | (words[2] & 255)) * 0x1p-24);
}

// A lane's numbers equal those of a packet with the same pixel, sample and vertex in all lanes.
template <class Numbers>
void expect_lanes_to_be_alone(std::uint32_t n) {
  using W = Word<Packet>;
  const Numbers numbers(StreamKey(3, "lanes"), n);
  const W i = lane_numbers<Packet::arch_type>();
  const auto together = numbers.template block<Packet>({i * W(3u), i * W(n / 2 + 1), i * i}, 1);
  for (std::uint32_t lane = 0; lane < lanes<Packet>; ++lane) {
    const auto alone = numbers.template block<Packet>({W(3 * lane), W((n / 2 + 1) * lane), W(lane * lane)}, 1);
    for (std::size_t d = 0; d < together.size(); ++d) {
      std::array<double, lanes<Packet>> a{}, b{};
      store_lanes(together[d], a.data());
      store_lanes(alone[d], b.data());
      EXPECT_EQ(a[lane], b[0]) << lane << " " << d;
      EXPECT_EQ(a[lane], b[lanes<Packet> - 1]) << lane << " " << d;
    }
  }
}

template <class Real, class Numbers>
void expect_the_first_pair_to_be_that_of_all(std::uint32_t n) {
  using W = Word<Real>;
  const Numbers numbers(StreamKey(4, "first pairs"), n);
  for (const std::uint32_t sample : {0u, n / 2, 3 * n - 1}) {
    const PathVertex<Real> at{W(7u), W(sample), W(3u)};
    const auto all = numbers.template block<Real>(at, 1);
    const auto first = numbers.template block<Real>(at, 1, BlockPart::first_pair);
    for (std::size_t d = 0; d < 2; ++d) {
      std::array<double, lanes<Real>> a{}, b{};
      store_lanes(all[d], a.data());
      store_lanes(first[d], b.data());
      EXPECT_EQ(a, b) << sample << " " << d;
    }
  }
}

TEST(VertexSource, HasFirstPairsThatDoNotDependOnWhatElseIsMade) {
  for (const std::uint32_t n : {1u, 2u, 64u, 1024u}) {
    expect_the_first_pair_to_be_that_of_all<double, PaddedSobol>(n);
    expect_the_first_pair_to_be_that_of_all<Packet, PaddedSobol>(n);
    expect_the_first_pair_to_be_that_of_all<double, PaddedStrata>(n);
    expect_the_first_pair_to_be_that_of_all<Packet, PaddedStrata>(n);
  }
}

TEST(VertexSource, HasNumbersThatDoNotDependOnTheLane) {
  expect_lanes_to_be_alone<IndependentNumbers>(1);
  for (std::uint32_t n = 1; n <= 1024; n *= 2) {
    expect_lanes_to_be_alone<PaddedSobol>(n);
    expect_lanes_to_be_alone<PaddedStrata>(n);
  }
}

template <class Numbers>
void expect_different(std::uint64_t seed, const PathVertex<double>& at) {
  const auto first = [&](const char* purpose, const PathVertex<double>& there, std::uint32_t b) {
    return Numbers(StreamKey(seed, purpose), 16).template block<double>(there, b)[0];
  };
  const double here = first("a", at, 0);
  RC_ASSERT(here >= 0 && here < 1);
  RC_ASSERT(here == first("a", at, 0));
  RC_ASSERT(here != first("b", at, 0));
  RC_ASSERT(here != first("a", at, 1));
  RC_ASSERT(here != first("a", {at.pixel + 1, at.sample, at.vertex}, 0));
  RC_ASSERT(here != first("a", {at.pixel, at.sample ^ 1, at.vertex}, 0));
  RC_ASSERT(here != first("a", {at.pixel, at.sample + 16, at.vertex}, 0));
  RC_ASSERT(here != first("a", {at.pixel, at.sample, at.vertex + 1}, 0));
}

RC_GTEST_PROP(VertexSource, HasNumbersThatDifferWhenAnyPartOfTheirAddressDoes,
              (std::uint64_t seed, std::uint32_t pixel, std::uint32_t sample, std::uint32_t vertex)) {
  expect_different<IndependentNumbers>(seed, {pixel, sample, vertex});
  expect_different<PaddedSobol>(seed, {pixel, sample, vertex});
  expect_different<PaddedStrata>(seed, {pixel, sample, vertex});
}

TEST(SampleSets, DivideASamplesNumber) {
  const SampleSets sets(16);
  EXPECT_EQ(sets.size(), 16u);
  EXPECT_EQ(sets.set_of(37u), 2u);
  EXPECT_EQ(sets.point_of(37u), 5u);
}

TEST(SampleSets, RefuseSizesThatAreNoPowersOfTwo) {
  for (const std::uint32_t n : {0u, 3u, 1023u, 2048u, 0x80000000u})
    EXPECT_THROW(SampleSets{n}, std::invalid_argument) << n;
  for (const std::uint32_t n : {1u, 2u, 1024u}) EXPECT_NO_THROW(SampleSets{n}) << n;
}

// Expected values come from an implementation of lowbias32 in another language.
TEST(MixedBits, AreThePublishedHash) {
  EXPECT_EQ(mixed_bits(1u), 0x688990C0u);
  EXPECT_EQ(mixed_bits(0xFFFFFFFFu), 0x6768824Au);
}

RC_GTEST_PROP(Shuffled, IsAPermutation, (std::uint32_t word)) {
  const std::uint32_t bits = *rc::gen::inRange<std::uint32_t>(0, 11);
  std::set<std::uint32_t> places;
  for (std::uint32_t i = 0; i < 1u << bits; ++i) places.insert(shuffled(i, bits, word));
  RC_ASSERT(places.size() == 1u << bits);
  RC_ASSERT(*places.rbegin() == (1u << bits) - 1);
}

}  // namespace
}  // namespace fairlight
