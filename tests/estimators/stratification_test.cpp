#include <array>
#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/next_number.h>
#include <support/scripted_source.h>
#include <support/unit_square.h>

#include <fairlight/estimators/control_variate.h>
#include <fairlight/estimators/stratification.h>

namespace fairlight {
namespace {

using testing::NextNumber;
using testing::ScriptedSource;

TEST(InCell, IsThePlaceInItsCell) {
  EXPECT_EQ(in_cell(0, 4, 0.0), 0);
  EXPECT_EQ(in_cell(1, 4, 0.5), 0.375);
  EXPECT_EQ(in_cell(3, 4, 0.0), 0.75);
}

template <class Real>
void expect_below_one() {
  const Real largest = Real(1) - Real(ulp<Real> / 2);
  for (int n : {1, 2, 3, 4, 5, 7, 16, 1000}) {
    for (int i = 0; i < n; ++i) {
      const Real place = in_cell(i, n, largest);
      EXPECT_TRUE(all(place < Real(1)) && all(place >= Real(0))) << i << " of " << n;
    }
  }
}

TEST(InCell, NeverReachesOne) {
  expect_below_one<double>();
  expect_below_one<float>();
  expect_below_one<Packet>();
}

RC_GTEST_PROP(InCell, StaysInItsCellButForRounding, ()) {
  const int n = *rc::gen::inRange(1, 1001);
  const int i = *rc::gen::inRange(0, n);
  const double place = in_cell(i, n, *testing::unit_number());
  RC_ASSERT(place >= i / double(n) * (1 - 0x1p-52));
  RC_ASSERT(place <= (i + 1) / double(n) * (1 + 0x1p-52));
}

// A combination of the first three numbers, in which each shows in different digits.
struct ThreeNumbers {
  using Scalar = double;
  double estimate(auto& source) const {
    const double first = source.next();
    const double second = source.next();
    return 100 * first + 10 * second + source.next();
  }
  Bound bound() const { return {0, 111}; }
};

TEST(StratifiedMean, PutsTheFirstTwoNumbersInEachCellOnce) {
  ScriptedSource source({0.5, 0.5, 0.5, 0.5, 0.5, 0.5});
  // Two columns, one row: the first number is 0.25, then 0.75; the second and the third do not
  // change.
  EXPECT_EQ(StratifiedMean(ThreeNumbers{}, 2, 1).estimate(source), (25 + 5 + 0.5 + 75 + 5 + 0.5) / 2);
  EXPECT_TRUE(source.exhausted());
}

TEST(StratifiedMean, DividesTheSecondNumberByRows) {
  ScriptedSource source({0, 0, 0, 0, 0, 0, 0, 0, 0});
  // Three rows start at 0, 1/3 and 2/3.
  EXPECT_DOUBLE_EQ(StratifiedMean(ThreeNumbers{}, 1, 3).estimate(source), 10.0 / 3);
  EXPECT_TRUE(source.exhausted());
}

TEST(StratifiedMean, IsTheEstimatorOnOneCell) {
  ScriptedSource source({0.125, 0.25, 0.5});
  EXPECT_EQ(StratifiedMean(ThreeNumbers{}, 1, 1).estimate(source), 12.5 + 2.5 + 0.5);
}

TEST(StratifiedMean, KeepsTheBound) { EXPECT_EQ(StratifiedMean(ThreeNumbers{}, 4, 4).bound(), (Bound{0, 111})); }

// A combinator that copies the source repeats the numbers of the cell.
TEST(StratifiedMean, FeedsACopyOfTheSourceTheSameNumbers) {
  ScriptedSource source({0.1, 0.2, 0.3, 0.4});
  const NextNumber<double> number;
  const StratifiedMean estimator(ControlVariate(number, number, 1, 0.5), 2, 2);
  EXPECT_DOUBLE_EQ(estimator.estimate(source), 0.5);
  EXPECT_TRUE(source.exhausted());
}

TEST(StratifiedMean, RefusesAGridWithoutCells) {
  EXPECT_THROW(StratifiedMean(ThreeNumbers{}, 0, 1), std::invalid_argument);
  EXPECT_THROW(StratifiedMean(ThreeNumbers{}, 1, -1), std::invalid_argument);
}

}  // namespace
}  // namespace fairlight
