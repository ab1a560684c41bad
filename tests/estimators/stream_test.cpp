#include <array>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fairlight/estimators/concepts.h>
#include <fairlight/estimators/stream.h>

namespace fairlight {
namespace {

using Philox32 = Philox<std::uint32_t>;

// Known answers of philox4x32 with 10 rounds, from Random123's kat_vectors (Salmon et al. 2011).
TEST(Philox, GivesTheKnownAnswers) {
  EXPECT_EQ(Philox32::draw({0, 0, 0, 0}, {0, 0}),
            (Philox32::Counter{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  constexpr std::uint32_t ones = 0xffffffff;
  EXPECT_EQ(Philox32::draw({ones, ones, ones, ones}, {ones, ones}),
            (Philox32::Counter{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(Philox32::draw({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (Philox32::Counter{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

static_assert(UniformSource<PhiloxStream<double>, double>);

TEST(PhiloxStream, IsTheKnownBlockCutIntoDoubles) {
  const StreamKey key(1, "test");
  PhiloxStream<double> source(key, 9, (std::uint64_t{7} << 32) | 5);
  const auto block = Philox32::draw({0, 5, 7, 9}, key.words());
  const auto number = [](std::uint64_t high, std::uint64_t low) {
    return static_cast<double>((high >> 5 << 26) | low >> 6) / 9007199254740992.0;
  };
  EXPECT_EQ(source.next(), number(block[2], block[3]));
  EXPECT_EQ(source.next(), number(block[0], block[1]));
  const auto second = Philox32::draw({1, 5, 7, 9}, key.words());
  EXPECT_EQ(source.next(), number(second[2], second[3]));
}

TEST(StreamKey, HasFurtherOnesWithOtherNumbers) {
  const StreamKey key(1, "test");
  EXPECT_EQ(key.further(0).words(), key.words());
  EXPECT_EQ(key.further(2).further(3).words(), key.further(5).words());
  const auto first = [](const StreamKey& k) { return PhiloxStream<double>(k, 0, 0).next(); };
  EXPECT_NE(first(key.further(1)), first(key));
  EXPECT_NE(first(key.further(1)), first(key.further(2)));
}

RC_GTEST_PROP(PhiloxStream, IsAFunctionOfItsAddressInTheUnitInterval,
              (std::uint64_t seed, std::uint32_t unit, std::uint64_t sample)) {
  const StreamKey key(seed, "test");
  PhiloxStream<double> a(key, unit, sample);
  PhiloxStream<double> b(key, unit, sample);
  for (int i = 0; i < 9; ++i) {
    const double u = a.next();
    RC_ASSERT(u >= 0 && u < 1);
    RC_ASSERT(u == b.next());
  }
}

RC_GTEST_PROP(PhiloxStream, DiffersWhenAnyPartOfItsAddressDoes,
              (std::uint64_t seed, std::uint32_t unit, std::uint64_t sample)) {
  const auto first = [](std::uint64_t s, const char* purpose, std::uint32_t u, std::uint64_t i) {
    return PhiloxStream<double>(StreamKey(s, purpose), u, i).next();
  };
  const double here = first(seed, "a", unit, sample);
  RC_ASSERT(here != first(seed + 1, "a", unit, sample));
  RC_ASSERT(here != first(seed, "b", unit, sample));
  RC_ASSERT(here != first(seed, "a", unit + 1, sample));
  RC_ASSERT(here != first(seed, "a", unit, sample + 1));
  RC_ASSERT(here != first(seed, "a", unit, sample + (std::uint64_t{1} << 32)));
}

TEST(UnitNumber, IsBelowOneForAllBitsSet) {
  constexpr std::uint32_t ones = 0xFFFFFFFFu;
  EXPECT_EQ(unit_number(0u, 0u), 0);
  EXPECT_EQ(unit_number(0u, 1u << 11), 0x1p-53);
  EXPECT_EQ(unit_number(ones, ones), 1 - 0x1p-53);
  std::array<double, lanes<Packet>> u{};
  store_lanes(unit_number(Word<Packet>(ones), Word<Packet>(ones)), u.data());
  EXPECT_EQ(u[0], 1 - 0x1p-24);
}

}  // namespace
}  // namespace fairlight
