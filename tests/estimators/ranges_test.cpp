#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include <fairlight/estimators/ranges.h>

namespace fairlight {
namespace {

TEST(RequireLength, TakesWhatIsInItsRangeAndRefusesTheRest) {
  for (double right : {1.001e-75, 1.0, 0.999e75}) EXPECT_NO_THROW(require_length(right, "it")) << right;
  for (float right : {1.001e-10f, 1.0f, 0.999e10f}) EXPECT_NO_THROW(require_length(right, "it")) << right;
  for (double wrong : {0.0, -1.0, 0.999e-75, 1.001e75, infinity<double>, std::nan("")}) {
    EXPECT_THROW(require_length(wrong, "it"), std::invalid_argument) << wrong;
  }
  for (float wrong : {0.0f, -1.0f, 0.999e-10f, 1.001e10f, infinity<float>, std::nanf("")}) {
    EXPECT_THROW(require_length(wrong, "it"), std::invalid_argument) << wrong;
  }
}

// One bad lane is enough.
TEST(RequireLength, LooksAtEveryLane) {
  std::array<float, lanes<Packet>> lengths;
  lengths.fill(1);
  EXPECT_NO_THROW(require_length(Packet::load_unaligned(lengths.data()), "it"));
  lengths.back() = -1;
  EXPECT_THROW(require_length(Packet::load_unaligned(lengths.data()), "it"), std::invalid_argument);
}

TEST(RequirePlace, LooksAtEveryCoordinate) {
  EXPECT_NO_THROW(require_place(Vec3<float>(0, -1e10f, 1), "it"));
  for (float wrong : {1.001e10f, -1.001e10f, infinity<float>, std::nanf("")}) {
    for (int i = 0; i < 3; ++i) {
      Vec3<float> place(1, 2, 3);
      place[i] = wrong;
      EXPECT_THROW(require_place(place, "it"), std::invalid_argument) << place.transpose();
    }
  }
}

TEST(RequireLength, SaysWhatIsWrongAndWhatToDo) {
  try {
    require_length(0.0f, "a radius");
    FAIL() << "not refused";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(
        error.what(),
        "a radius must be positive and finite, in floats from 1e-10 to 1e10 m, in double from 1e-75 to 1e75 m "
        "(scale the scene)");
  }
}

}  // namespace
}  // namespace fairlight
