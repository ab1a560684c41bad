#include <limits>

#include <gtest/gtest.h>
#include <support/materials.h>

#include <fairlight/estimators/reflectance.h>

namespace fairlight {
namespace {

// Colours whose channels differ, and cosines that are exact in floats.
const Rgb<double> colour(0.25, 0.5, 0);

TEST(ConstantReflectance, IsTheSameAtAnyAngle) {
  for (double cosine : {0.0, 0.3, 1.0}) EXPECT_TRUE((ConstantReflectance<double>(colour)(cosine) == colour).all());
}

TEST(SchlickReflectance, GoesFromItsColourToWhiteByTheFifthPower) {
  const SchlickReflectance<double> reflectance(colour);
  EXPECT_TRUE((reflectance(1) == colour).all());
  EXPECT_TRUE((reflectance(0) == 1).all());
  EXPECT_TRUE((reflectance(0.5) == Rgb<double>(0.25 + 0.75 / 32, 0.5 + 0.5 / 32, 1.0 / 32)).all());
}

// As in fresnel_test.cpp: k^2 / (4 + k^2) for eta = 1, (1 + 9) / (9 + 9), (0.5 / 2.5)^2.
TEST(FresnelReflectance, IsKnownByHandAtNormalIncidence) {
  const FresnelReflectance<double> reflectance({1, 2, 1.5}, {2, 3, 0});
  EXPECT_TRUE(reflectance(1).isApprox(Rgb<double>(0.5, 10.0 / 18, 0.04), 1e-15));
}

// Every lane has a cosine of its own. Both arithmetics round each of the steps, fewer than 20, by
// half an ulp of what is at most 2.
template <template <class> class Reflectance, class... Colours>
void expect_the_same_in_lanes(const Colours&... colours) {
  std::array<double, lanes<Packet>> cosines{};
  for (std::size_t i = 0; i < lanes<Packet>; ++i) cosines[i] = static_cast<double>(i + 1) / lanes<Packet>;
  Packet cosine;
  load_lanes(cosines.data(), cosine);
  const Rgb<Packet> packet = Reflectance<Packet>(colours.template cast<float>().template cast<Packet>()...)(cosine);
  for (std::size_t i = 0; i < lanes<Packet>; ++i) {
    const Rgb<double> exact = Reflectance<double>(colours...)(cosines[i]);
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(testing::lanes_of(packet[c])[i], exact[c], 20 * 0x1p-23) << "lane " << i << ", channel " << c;
  }
}

TEST(Reflectances, AreTheSameInPackets) {
  expect_the_same_in_lanes<ConstantReflectance>(colour);
  expect_the_same_in_lanes<SchlickReflectance>(colour);
  expect_the_same_in_lanes<FresnelReflectance>(Rgb<double>(1, 2, 1.5), Rgb<double>(2, 3, 0));
}

}  // namespace
}  // namespace fairlight
