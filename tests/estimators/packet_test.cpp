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

// Into lanes 1 and 2 of any packet, into all lanes, and into none.
TEST(Packet, ExpandsNumbersIntoTheLanesThatAreNamed) {
  std::array<float, lanes<Packet>> next{};
  std::array<std::uint32_t, lanes<Packet>> words{};
  for (std::size_t i = 0; i < next.size(); ++i) {
    next[i] = 100 + static_cast<float>(i);
    words[i] = 100 + static_cast<std::uint32_t>(i);
  }
  const std::uint32_t everyone = lane_bits(Packet(0) == Packet(0));
  const auto some = lanes_of(expand(0b0110, next.data(), ramp()));
  const auto all = lanes_of(expand(everyone, next.data(), ramp()));
  const auto none = lanes_of(expand(0, next.data(), ramp()));
  const Words words_some = expand(0b0110, words.data(), Words(7u));
  for (std::size_t i = 0; i < lanes<Packet>; ++i) {
    const bool named = i == 1 || i == 2;
    EXPECT_EQ(some[i], static_cast<double>(named ? 99 + i : i));
    EXPECT_EQ(all[i], static_cast<double>(100 + i));
    EXPECT_EQ(none[i], static_cast<double>(i));
    EXPECT_EQ(words_some.get(i), named ? 99 + i : 7);
  }
  const double one = 100;
  EXPECT_EQ(expand(1, &one, 5.0), 100);
  EXPECT_EQ(expand(0, &one, 5.0), 5);
}

// The five numbers of a Philox block: the upper 24 bits of its four words, and the lower 8 of the
// first three.
std::array<double, 5> numbers_of(const Philox<std::uint32_t>::Counter& words) {
  std::array<double, 5> numbers{};
  for (std::size_t k = 0; k < 4; ++k) numbers[k] = (words[k] >> 8) * 0x1p-24;
  numbers[4] = ((words[0] & 255) << 16 | (words[1] & 255) << 8 | (words[2] & 255)) * 0x1p-24;
  return numbers;
}

void expect_sample(const std::array<std::array<double, lanes<Packet>>, 7>& drawn, std::size_t lane,
                   const StreamKey& key, std::uint32_t unit, std::uint64_t sample) {
  for (std::uint32_t k = 0; k < drawn.size(); ++k) {
    const auto block = Philox<std::uint32_t>::draw(
        {k / 5, static_cast<std::uint32_t>(sample), static_cast<std::uint32_t>(sample >> 32), unit}, key.words());
    EXPECT_EQ(drawn[k][lane], numbers_of(block)[k % 5]) << sample << " number " << k;
  }
}

// Lane i is sample first + i, for any width.
TEST(PhiloxStream, GivesEachLaneTheNumbersOfItsSample) {
  const StreamKey key(7, "lanes");
  for (const std::uint64_t first : {std::uint64_t{0}, std::uint64_t{0xFFFFFFFE}, std::uint64_t{1} << 40}) {
    PhiloxStream<Packet> stream(key, 5, first);
    std::array<std::array<double, lanes<Packet>>, 7> drawn{};
    for (auto& numbers : drawn) numbers = lanes_of(stream.next());
    for (std::size_t i = 0; i < lanes<Packet>; ++i) expect_sample(drawn, i, key, 5, first + i);
  }
}

// At all boundaries of quarter turns and between them: to an ulp of 1, and exactly at the quarters.
TEST(Packet, TurnsAsDoubleDoes) {
  const auto expect_turn = [](double turn, double sine, double cosine) {
    EXPECT_LE(std::abs(sine - std::sin(2 * M_PI * turn)), 0x1p-23) << turn;
    EXPECT_LE(std::abs(cosine - std::cos(2 * M_PI * turn)), 0x1p-23) << turn;
    if (std::fmod(turn, 0.25) != 0) return;
    EXPECT_EQ(sine, std::round(std::sin(2 * M_PI * turn)));
    EXPECT_EQ(cosine, std::round(std::cos(2 * M_PI * turn)));
  };
  for (int i = 0; i <= 4096; ++i) {
    std::array<double, lanes<Packet>> turns{};  // lanes in different quarters
    for (std::size_t lane = 0; lane < lanes<Packet>; ++lane)
      turns[lane] = (i + 1024 * static_cast<int>(lane)) % 4097 / 4096.0;
    Packet turn;
    load_lanes(turns.data(), turn);
    const auto [sine, cosine] = sine_and_cosine_of_turn(turn);
    const auto sines = lanes_of(sine), cosines = lanes_of(cosine);
    for (std::size_t lane = 0; lane < lanes<Packet>; ++lane) expect_turn(turns[lane], sines[lane], cosines[lane]);
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
