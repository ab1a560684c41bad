#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/scripted_source.h>
#include <support/unit_square.h>

#include <fairlight/estimators/pick_one.h>

namespace fairlight {
namespace {

using testing::ScriptedSource;

TEST(UniformChoice, CutsTheUnitIntervalIntoEqualParts) {
  const UniformChoice<double> choice(4);
  EXPECT_EQ(choice.sample(0).index, 0);
  EXPECT_EQ(choice.sample(0.25).index, 1);
  EXPECT_EQ(choice.sample(0.999).index, 3);
  EXPECT_EQ(choice.sample(0.5).probability.value(), 0.25);
}

RC_GTEST_PROP(UniformChoice, NamesAnAlternativeThatExists, ()) {
  const int n = *rc::gen::inRange(1, 100001);
  const UniformChoice<double> choice(n);
  const double u = *testing::unit_number();
  RC_ASSERT(choice.sample(u).index >= 0);
  RC_ASSERT(choice.sample(u).index < n);
  RC_ASSERT(choice.sample(1 - 0x1p-53).index == n - 1);
}

TEST(UniformChoice, RefusesNoAlternatives) {
  EXPECT_THROW(UniformChoice<double>(0), std::invalid_argument);
  EXPECT_THROW(UniformChoice<double>(-1), std::invalid_argument);
}

double term(int i, ScriptedSource& source) { return (i + 1) * source.next(); }

TEST(AllOf, AddsEveryTerm) {
  ScriptedSource source({0.5, 0.25, 0.125});
  EXPECT_EQ(AllOf::sum<double>(3, source, term), 0.5 + 2 * 0.25 + 3 * 0.125);
  EXPECT_TRUE(source.exhausted());
}

TEST(OneOf, WeightsTheTermByTheirNumber) {
  ScriptedSource source({0.5, 0.25});
  EXPECT_EQ(OneOf::sum<double>(3, source, term), 3 * 2 * 0.25);
  EXPECT_TRUE(source.exhausted());
}

}  // namespace
}  // namespace fairlight
