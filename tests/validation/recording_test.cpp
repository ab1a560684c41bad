#include <array>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include <fairlight/validation/recording.h>

namespace fairlight {
namespace {

const StreamKey key(1, "recording_test");

std::array<double, lanes<Packet>> lanes_of(const Packet& x) {
  std::array<double, lanes<Packet>> values{};
  store_lanes(x, values.data());
  return values;
}

TEST(Recording, HasTheFloatsDigitsAndAsManyOthers) {
  Recording recording(key, 32);
  StreamNumbers<Packet> floats(recording);
  std::set<double> others;
  for (std::size_t dimension = 0; dimension < 7; ++dimension) {
    const auto coarse = lanes_of(floats.next());
    for (std::size_t lane = 0; lane < lanes<Packet>; ++lane) {
      const double digits = recording.in_double(dimension, lane) * 0x1p24;
      EXPECT_EQ(std::floor(digits) * 0x1p-24, coarse[lane]);
      const double other = digits - std::floor(digits);
      EXPECT_EQ(std::floor(other * 0x1p24), other * 0x1p24);
      EXPECT_NE(other, coarse[lane]);
      others.insert(other);
    }
  }
  EXPECT_EQ(others.size(), 7 * lanes<Packet>);  // two of them agree once in 2^24 / 28^2 times
}

TEST(Recording, IsOfTheSamplesThatAStreamHas) {
  Recording recording(key, 32);
  StreamNumbers<Packet> recorded(recording), alone(key, 32);
  for (int dimension = 0; dimension < 7; ++dimension) {
    EXPECT_EQ(lanes_of(recorded.next()), lanes_of(alone.next()));
  }
}

// A lane in double may need numbers that no lane of the packet came to, and a copy of a source repeats what it has had.
TEST(Recording, GoesOnBeyondWhatWasDrawnAndKeepsNothingTwice) {
  Recording drawn(key, 0), asked(key, 0);
  StreamNumbers<Packet> floats(drawn);
  floats.next();
  StreamNumbers<Packet> copy = floats;
  floats.next();
  copy.next();
  for (std::size_t dimension = 0; dimension < 12; ++dimension) {
    EXPECT_EQ(drawn.in_double(dimension, 1), asked.in_double(dimension, 1)) << dimension;
  }
  StreamNumbers<double> lane(key, drawn, 1);
  EXPECT_EQ(lane.next(), asked.in_double(0, 1));
  EXPECT_EQ(lane.next(), asked.in_double(1, 1));
}

TEST(StreamNumbers, AreThoseOfTheStreamInDouble) {
  StreamNumbers<double> numbers(key, 5);
  PhiloxStream<double> stream(key, 0, 5);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(numbers.next(), stream.next());
}

}  // namespace
}  // namespace fairlight
