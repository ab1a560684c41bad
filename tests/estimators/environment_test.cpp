#include <cmath>

#include <gtest/gtest.h>
#include <support/lights.h>
#include <support/unit_square.h>

#include <fairlight/estimators/environment.h>

namespace fairlight {
namespace {

static_assert(LightSampling<ConstantEnvironment<double>>);

const Vec3<double> anywhere(3, -2, 7);

TEST(ConstantEnvironment, IsAsDenseInEveryDirectionAndInfinitelyFar) {
  const auto sample = ConstantEnvironment<double>().sample(anywhere, {0.2, 0.25});
  EXPECT_TRUE(sample.direction.isApprox(Vec3<double>(0, 0.8, 0.6), 1e-15));
  EXPECT_EQ(sample.distance, infinity<double>);
  EXPECT_DOUBLE_EQ(sample.density.value(), 1 / (4 * M_PI));
  EXPECT_DOUBLE_EQ(ConstantEnvironment<double>().pdf(anywhere, {0, 0, -1}).value(), 1 / (4 * M_PI));
}

TEST(ConstantEnvironment, GivesUnitDirectionsAtTheEdgesOfTheSquare) {
  for (const Vec2<double>& u : testing::edge_points()) {
    EXPECT_LE(std::abs(ConstantEnvironment<double>().sample(anywhere, u).direction.norm() - 1), 4e-16);
  }
  testing::expect_finite_at_edges(ConstantEnvironment<Packet>(), testing::in_packets(anywhere));
}

TEST(ConstantEnvironment, TakesADirectionThatIsNearlyUnit) {
  testing::expect_density_off_by_as_much_as_the_direction(ConstantEnvironment<double>(), anywhere, {0.6, 0, 0.8});
}

TEST(ConstantEnvironment, IsTheSameInPackets) {
  testing::expect_same_sample(ConstantEnvironment<double>(), ConstantEnvironment<Packet>(), anywhere,
                              {0.625, 0.75});
}

}  // namespace
}  // namespace fairlight
