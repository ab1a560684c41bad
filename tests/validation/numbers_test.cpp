#include <array>
#include <cmath>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

#include <fairlight/estimators/latin_hypercube.h>
#include <fairlight/validation/checks/numbers.h>

namespace fairlight {
namespace {

const StreamKey key(1, "numbers_test");

std::array<double, lanes<Packet>> lanes_of(const Packet& x) {
  std::array<double, lanes<Packet>> values{};
  store_lanes(x, values.data());
  return values;
}

TEST(NumberSource, GivesTheNumbersOfTheStream) {
  IndependentSamples<double> numbers(key);
  numbers.move_to(5);
  NumberSource<double> source(numbers);
  PhiloxStream<double> stream(key, 0, 5);
  for (int i = 0; i < 7; ++i) EXPECT_EQ(source.next(), stream.next());
  EXPECT_EQ(source.drawn(), 7u);
}

TEST(NumberSource, GivesTheNumbersOfPointsOfASet) {
  using Set = LatinHypercube<double>;
  PointNumbersOf<Set> numbers;
  numbers.begin(key, 3, 8);
  const Set set(key, 3, 8);
  for (const std::uint32_t point : {2u, 5u}) {
    numbers.move_to(point);
    NumberSource<double> source(numbers);
    auto expected = set.source(point);
    for (int i = 0; i < 5; ++i) EXPECT_EQ(source.next(), expected.next());
  }
}

TEST(NumberSource, RepeatsItsNumbersInACopy) {
  IndependentSamples<Packet> numbers(key);
  NumberSource<Packet> source(numbers);
  source.next();
  NumberSource<Packet> copy = source;
  for (int i = 0; i < 9; ++i) EXPECT_EQ(lanes_of(source.next()), lanes_of(copy.next()));
}

// Another source of the same numbers goes on at dimension 3, whether or not all three were used.
TEST(NumberSource, LeavesNumbersToAnother) {
  IndependentSamples<double> numbers(key);
  NumberSource<double> source(numbers), whole(numbers);
  NumberSource<double> taken = source.take(3);
  EXPECT_EQ(taken.next(), whole.next());
  EXPECT_EQ(taken.next(), whole.next());
  whole.next();
  EXPECT_EQ(source.next(), whole.next());
  taken.next();
  EXPECT_THROW(taken.next(), std::out_of_range);
}

TEST(FinerNumbers, HaveTheFloatsDigitsAndAsManyOthers) {
  IndependentSamples<Packet> floats(key, 32);
  FinerNumbers<Packet> finer(floats, key, 32);
  std::set<double> others;
  for (std::size_t dimension = 0; dimension < 7; ++dimension) {
    const auto coarse = lanes_of(floats.at(dimension));
    for (std::size_t lane = 0; lane < lanes<Packet>; ++lane) {
      const double digits = finer.at(dimension, lane) * 0x1p24;
      EXPECT_EQ(std::floor(digits) * 0x1p-24, coarse[lane]);
      const double other = digits - std::floor(digits);
      EXPECT_EQ(std::floor(other * 0x1p24), other * 0x1p24);
      EXPECT_NE(other, coarse[lane]);
      others.insert(other);
    }
  }
  EXPECT_EQ(others.size(), 7 * lanes<Packet>);  // two of them agree once in 2^24 / 28^2 times
}

// A lane in double may need numbers that no lane of the packet came to.
TEST(FinerNumbers, GoOnBeyondWhatThePacketDrew) {
  IndependentSamples<Packet> drawn(key), asked(key);
  NumberSource<Packet> source(drawn);
  source.next();
  FinerNumbers<Packet> of_drawn(drawn, key, 0), of_asked(asked, key, 0);
  LaneNumbers<Packet> lane(of_drawn, 1);
  NumberSource<double> in_double(lane);
  for (std::size_t dimension = 0; dimension < 12; ++dimension) {
    EXPECT_EQ(in_double.next(), of_asked.at(dimension, 1)) << dimension;
  }
}

}  // namespace
}  // namespace fairlight
