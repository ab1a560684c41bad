#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/materials.h>

#include <fairlight/estimators/mirror.h>

namespace fairlight {
namespace {

static_assert(Bsdf<Mirror<double>>);
static_assert(Bsdf<Mirror<Packet>>);
static_assert(Mirror<double>::dimensions == 0);

const Rgb<double> albedo(0.75, 0.5, 0.25);

TEST(Mirror, TurnsTheDirectionAboutTheNormal) {
  const auto bounce = Mirror<double>(albedo).sample({0.48, 0.64, 0.6}, {});
  EXPECT_EQ(bounce.in, Vec3<double>(-0.48, -0.64, 0.6));
  EXPECT_TRUE((bounce.weight == albedo).all());
  EXPECT_EQ(bounce.density.value(), 0);
}

TEST(Mirror, HasNoDensityEvenInItsDirection) {
  const Mirror<double> mirror(albedo);
  EXPECT_EQ(mirror.pdf({0, 0.8, 0.6}, {0, -0.8, 0.6}).value(), 0);
  EXPECT_TRUE((mirror.eval({0, 0.8, 0.6}, {0, -0.8, 0.6}) == 0).all());
}

TEST(Mirror, ShowsNothingFromBelow) {
  const Mirror<double> mirror(albedo);
  EXPECT_TRUE((mirror.sample({0, 0.8, -0.6}, {}).weight == 0).all());
  EXPECT_TRUE((mirror.albedo({0, 0.8, -0.6}) == 0).all());
}

RC_GTEST_PROP(Mirror, IsItsOwnInverse, ()) {
  const Vec3<double> out = *testing::direction_above();
  const Mirror<double> mirror(albedo);
  RC_ASSERT(mirror.sample(mirror.sample(out, {}).in, {}).in == out);
  RC_ASSERT((mirror.sample(out, {}).weight == mirror.albedo(out)).all());
}

TEST(Mirror, WantsAnAlbedoInZeroToOne) {
  EXPECT_NO_THROW(Mirror<double>(Rgb<double>(0, 0.5, 1)));
  for (double wrong : {-0.1, 1.1, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(Mirror<double>(Rgb<double>(0.5, wrong, 0.5)), std::invalid_argument) << wrong;
  }
}

TEST(Mirror, IsTheSameInPackets) {
  const Mirror<Packet> mirror(Rgb<Packet>(Packet(0.75f), Packet(0.5f), Packet(0.25f)));
  const auto bounce = mirror.sample({Packet(0), Packet(0.8f), Packet(0.6f)}, {});
  for (double y : testing::lanes_of(bounce.in.y())) EXPECT_FLOAT_EQ(static_cast<float>(y), -0.8f);
  for (double red : testing::lanes_of(bounce.weight[0])) EXPECT_EQ(red, 0.75);
}

}  // namespace
}  // namespace fairlight
