#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/next_number.h>
#include <support/scripted_source.h>
#include <support/unit_square.h>

#include <fairlight/estimators/control_variate.h>

namespace fairlight {
namespace {

using testing::NextNumber;
using testing::ScriptedSource;

// The square of the next number. The tests use that number, with mean 1/2, as its control.
struct Square {
  using Scalar = double;
  double estimate(ScriptedSource& source) const {
    const double u = source.next();
    return u * u;
  }
  Bound bound() const { return {0, 1}; }
};

TEST(ControlVariate, FeedsBothTheSameNumbers) {
  ScriptedSource source({0.25});
  EXPECT_EQ(ControlVariate(Square{}, NextNumber<double>{}, 2, 0.5).estimate(source), 0.0625 - 2 * (0.25 - 0.5));
  EXPECT_TRUE(source.exhausted());
}

TEST(ControlVariate, HasABoundOnBothSides) {
  EXPECT_EQ(ControlVariate(Square{}, NextNumber<double>{3}, 2, 0.5).bound(), (Bound{-2 * 3 + 1, 1 + 1}));
  EXPECT_EQ(ControlVariate(Square{}, NextNumber<double>{3}, -2, 0.5).bound(), (Bound{-1, 1 + 6 - 1}));
}

TEST(ControlVariate, WithoutAFactorIsTheEstimator) {
  ScriptedSource source({0.25});
  EXPECT_EQ(ControlVariate(Square{}, NextNumber<double>{}, 0, 0.5).estimate(source), 0.0625);
  EXPECT_EQ(ControlVariate(Square{}, NextNumber<double>{}, 0, 0.5).bound(), (Bound{0, 1}));
}

// With itself as the control, an estimator has no variance: every draw is the mean.
RC_GTEST_PROP(ControlVariate, OfItselfHasNoVariance, ()) {
  const NextNumber<double> number;
  ScriptedSource source({*testing::unit_number()});
  RC_ASSERT(std::abs(ControlVariate(number, number, 1, 0.5).estimate(source) - 0.5) <= 0x1p-53);
}

TEST(ControlVariate, RefusesWhatIsNotFinite) {
  for (double x : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(ControlVariate(Square{}, Square{}, x, 0.5), std::invalid_argument);
    EXPECT_THROW(ControlVariate(Square{}, Square{}, 1, x), std::invalid_argument);
  }
}

}  // namespace
}  // namespace fairlight
