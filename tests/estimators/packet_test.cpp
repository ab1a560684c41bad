#include <array>
#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fairlight/estimators/hemisphere.h>
#include <fairlight/estimators/stream.h>
#include <fairlight/estimators/vec.h>

namespace fairlight {
namespace {

using Words = xsimd::batch<std::uint32_t>;

std::array<double, lanes<Packet>> lanes_of(const Packet& x) {
  std::array<double, lanes<Packet>> values{};
  store_lanes(x, values.data());
  return values;
}

Packet ramp() {
  return xsimd::to_float(xsimd::bitwise_cast<xsimd::batch<std::int32_t>>(lane_numbers<Packet::arch_type>()));
}

TEST(Packet, CountsItsLanes) {
  const auto values = lanes_of(ramp());
  for (std::size_t i = 0; i < lanes<Packet>; ++i) EXPECT_EQ(values[i], static_cast<double>(i));
}

TEST(Packet, SelectsLaneByLane) {
  const Packet x = ramp();
  const Vec3<Packet> ones = Vec3<Packet>::Constant(Packet(1));
  const Vec3<Packet> chosen = select(x < Packet(2), ones, Vec3<Packet>(zero<Vec3<Packet>>()));
  const auto values = lanes_of(chosen.z());
  for (std::size_t i = 0; i < lanes<Packet>; ++i) EXPECT_EQ(values[i], i < 2 ? 1 : 0);
  EXPECT_TRUE(any(x == Packet(0)));
  EXPECT_FALSE(all(x == Packet(0)));
}

RC_GTEST_PROP(Packet, MultipliesWordsAsWideNumbersDo, ()) {
  const auto a = *rc::gen::arbitrary<std::uint32_t>();
  const auto b = *rc::gen::container<std::array<std::uint32_t, Words::size>>(rc::gen::arbitrary<std::uint32_t>());
  const auto [high, low] = multiply_high_low(a, Words::load_unaligned(b.data()));
  for (std::size_t i = 0; i < Words::size; ++i) {
    const std::uint64_t product = std::uint64_t{a} * b[i];
    RC_ASSERT(high.get(i) == product >> 32);
    RC_ASSERT(low.get(i) == (product & 0xFFFFFFFFu));
  }
}

// Lane i is sample first + i, whatever the width: its numbers are the words of its own Philox block, 24 bits each.
TEST(PhiloxStream, GivesEachLaneTheNumbersOfItsSample) {
  const StreamKey key(7, "lanes");
  for (const std::uint64_t first : {std::uint64_t{0}, std::uint64_t{0xFFFFFFFE}, std::uint64_t{1} << 40}) {
    PhiloxStream<Packet> stream(key, 5, first);
    std::array<std::array<double, lanes<Packet>>, 6> drawn{};
    for (auto& numbers : drawn) numbers = lanes_of(stream.next());
    for (std::size_t i = 0; i < lanes<Packet>; ++i) {
      const std::uint64_t sample = first + i;
      for (std::uint32_t block : {0u, 1u}) {
        const auto words = Philox<std::uint32_t>::draw(
            {block, static_cast<std::uint32_t>(sample), static_cast<std::uint32_t>(sample >> 32), 5}, key.words());
        for (std::size_t k = 0; k < (block == 0 ? 4u : 2u); ++k) {
          EXPECT_EQ(drawn[4 * block + k][i], (words[3 - k] >> 8) * 0x1p-24) << first << " lane " << i;
        }
      }
    }
  }
}

TEST(Packet, SamplesWhatDoubleSamples) {
  const Vec2<Packet> u(ramp() / Packet(static_cast<float>(lanes<Packet>)), Packet(0.25f));
  const Vec3<Packet> w = CosineHemisphere<Packet>().sample(u);
  const auto z = lanes_of(w.z());
  const auto y = lanes_of(w.y());
  for (std::size_t i = 0; i < lanes<Packet>; ++i) {
    const double t = static_cast<double>(i) / lanes<Packet>;
    const Vec3<double> expected = CosineHemisphere<double>().sample({t, 0.25});
    EXPECT_LE(std::abs(z[i] - expected.z()), 2e-7);
    EXPECT_LE(std::abs(y[i] - expected.y()), 2e-7);
  }
}

}  // namespace
}  // namespace fairlight
