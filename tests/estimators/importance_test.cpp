#include <cmath>

#include <gtest/gtest.h>
#include <support/scripted_source.h>

#include <fairlight/estimators/hemisphere.h>
#include <fairlight/estimators/importance.h>

namespace fairlight {
namespace {

TEST(Importance, IsTheIntegrandOverTheDensityAtTheDraw) {
  const Importance estimator(UniformHemisphere<double>{}, [](const Vec3<double>& w) { return w.z(); });
  testing::ScriptedSource source({0.25, 0.5});
  EXPECT_DOUBLE_EQ(estimator.estimate(source), 0.25 * 2 * M_PI);
  EXPECT_TRUE(source.exhausted());
}

TEST(Importance, KnowsNoBoundUntilItIsTold) {
  const auto height = [](const Vec3<double>& w) { return w.z(); };
  EXPECT_EQ(Importance(UniformHemisphere<double>{}, height).bound(), Bound{});
  EXPECT_EQ(Importance(UniformHemisphere<double>{}, height, {0, 2 * M_PI}).bound(), (Bound{0, 2 * M_PI}));
}

}  // namespace
}  // namespace fairlight
