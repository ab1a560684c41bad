#include <gtest/gtest.h>

#include <fairlight/estimators/bound.h>

namespace fairlight {
namespace {

TEST(Bound, OfASumIsTheSumOfTheEnds) { EXPECT_EQ((Bound{-1, 2} + Bound{3, 5}), (Bound{2, 7})); }

TEST(Bound, IsTurnedAroundByANegativeFactor) {
  EXPECT_EQ((2 * Bound{-1, 3}), (Bound{-2, 6}));
  EXPECT_EQ((-2 * Bound{-1, 3}), (Bound{-6, 2}));
}

TEST(Bound, OfNothingTimesWhateverIsNothing) { EXPECT_EQ(0 * Bound{}, (Bound{0, 0})); }

TEST(Bound, OfEitherOfTwoHoldsBoth) {
  EXPECT_EQ(hull({1, 2}, {-3, -1}), (Bound{-3, 2}));
  EXPECT_EQ(or_nothing({1, 2}), (Bound{0, 2}));
}

}  // namespace
}  // namespace fairlight
