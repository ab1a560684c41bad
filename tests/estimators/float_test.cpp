#include <cmath>

#include <gtest/gtest.h>
#include <support/unit_square.h>

#include <fairlight/estimators/filter.h>
#include <fairlight/estimators/lambertian.h>
#include <fairlight/estimators/uniform_sphere_area.h>

// The samplers in single precision: finite, and in their domain, at the edges of the square,
// including 0 and 1 - 2^-24.
namespace fairlight {
namespace {

using testing::edge_points;

constexpr float epsilon = 0x1p-23f;

template <class Law>
void expect_unit_vectors_in_the_support(const Law& law) {
  for (const Vec2<float>& u : edge_points<float>()) {
    const Vec3<float> w = law.sample(u);
    EXPECT_LE(std::abs(w.norm() - 1), 2 * epsilon) << u.transpose();
    EXPECT_GT(law.pdf(w).value(), 0) << u.transpose();
  }
}

TEST(SinglePrecision, KeepsDirectionsInTheirHemisphere) {
  expect_unit_vectors_in_the_support(UniformHemisphere<float>());
  expect_unit_vectors_in_the_support(CosineHemisphere<float>());
  expect_unit_vectors_in_the_support(UniformSphereArea<float>(1e5f));
}

TEST(SinglePrecision, KeepsOffsetsInTheTent) {
  for (const Vec2<float>& u : edge_points<float>()) {
    EXPECT_LE(TentFilter<float>().sample(u).cwiseAbs().maxCoeff(), 1) << u.transpose();
  }
}

TEST(SinglePrecision, WeighsACosineBounceByTheAlbedo) {
  for (const Vec2<float>& u : edge_points<float>()) {
    const auto bounce = Lambertian<float>(Rgb<float>(0.75f, 0.5f, 0.25f)).sample({0, 0, 1}, u);
    EXPECT_LE((bounce.weight - Rgb<float>(0.75f, 0.5f, 0.25f)).abs().maxCoeff(), 2 * epsilon) << u.transpose();
  }
}

}  // namespace
}  // namespace fairlight
