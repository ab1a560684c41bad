#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <fairlight/estimators/rectangle_light.h>
#include <fairlight/estimators/sphere_sampling.h>

// A direction that is sampled in double and rounded to floats, or sampled in floats, may be past
// the rim by half an ulp of 1 rad. If it had density 0, a bounce that hits the light would count
// fully, and the weights of multiple importance sampling would sum to more than 1: to 1.004 for a
// sphere of r/d = 1e-5.
namespace fairlight {
namespace {

constexpr double rad = 0x1p-23;  // an ulp of 1

// Directions with components of equal size, of different sizes, and 0.
const std::array<Vec3<double>, 6> all_around{Vec3<double>(1, 0, 0),      Vec3<double>(1, 2, -3),
                                             Vec3<double>(-3, 1, 1),     Vec3<double>(1, -1, 1),
                                             Vec3<double>(-5, 0.01, 12), Vec3<double>(2, 7, 0.3)};

// A sphere of radius 1 about the origin, and a point with float coordinates at a distance of about
// 1 / ratio.
struct FarSphere {
  Vec3<float> from;
  double cone_height;  // 1 - cos of its cone
  Frame<double> frame;

  FarSphere(const Vec3<double>& towards, double ratio)
      : from((towards.normalized() / ratio).cast<float>()),
        cone_height(height(from.cast<double>())),
        frame(-from.cast<double>().normalized()) {}

  // The direction at an angle past the rim [rad]; a negative angle is inside.
  Vec3<float> past_the_rim(double angle, double turn) const {
    const double theta = 2 * std::asin(std::sqrt(cone_height / 2)) + angle;
    const Vec3<double> local(std::sin(theta) * std::cos(turn), std::sin(theta) * std::sin(turn), std::cos(theta));
    return frame.to_world(local).cast<float>();
  }

  // The direction at the fraction `part` of the cap's height, as for u_x.
  Vec3<float> within(double part, double turn) const {
    const double drop = part * cone_height, radius = std::sqrt(drop * (2 - drop));
    return frame.to_world({radius * std::cos(turn), radius * std::sin(turn), 1 - drop}).cast<float>();
  }

 private:
  static double height(const Vec3<double>& from) {
    const double square = 1 / from.squaredNorm();
    return square / (1 + std::sqrt(1 - square));
  }
};

template <class Real>
SphereLight<Real> unit_sphere() {
  return {Vec3<Real>(0, 0, 0), Real(1)};
}

// Calls visit(sphere, direction) for a grid of directions over the cap: 64 heights by 64 turns.
template <class Visit>
void over_the_cap(double ratio, const Visit& visit) {
  for (const Vec3<double>& towards : all_around) {
    const FarSphere sphere(towards, ratio);
    for (int i = 0; i < 64; ++i) {
      for (int j = 0; j < 64; ++j) visit(sphere, sphere.within((i + 0.5) / 64, 2 * M_PI * (j + 0.5) / 64));
    }
  }
}

// The density is 1/(2 pi (1 - cos)), where 1 - cos comes from the square of r/d: about 16 rounding
// errors.
TEST(SphereByCone, HasItsDensityInFloatsUpToTheRim) {
  const SphereByCone<float> floats(unit_sphere<float>());
  for (double ratio : {0.5, 0.1, 1e-2, 1e-4, 1e-5, 1e-6, 1e-7, 1e-9, 1e-16}) {
    long zeros = 0;
    for (const Vec3<double>& towards : all_around) {
      const FarSphere sphere(towards, ratio);
      for (int j = 0; j < 512; ++j) {
        zeros += floats.pdf(sphere.from, sphere.within(1 - 1e-9, 2 * M_PI * j / 512)).value() == 0 ? 1 : 0;
      }
    }
    over_the_cap(ratio, [&](const FarSphere& sphere, const Vec3<float>& direction) {
      const double density = static_cast<double>(floats.pdf(sphere.from, direction).value());
      zeros += density == 0 ? 1 : 0;
      if (density == 0) return;
      EXPECT_LE(std::abs(density * 2 * M_PI * sphere.cone_height - 1), 16 * rad) << ratio;
    });
    EXPECT_EQ(zeros, 0) << ratio;
  }
}

TEST(SphereByCone, HasADensityWhereFloatsDraw) {
  for (double ratio : {0.9999, 0.5, 1e-2, 1e-5, 1e-7, 1e-9, 1e-16}) {
    for (const Vec3<double>& towards : all_around) {
      const SphereByCone<float> light(unit_sphere<float>());
      const Vec3<float> from = FarSphere(towards, ratio).from;
      for (float x : {0.0f, 0.25f, 0.999f, 1 - 0x1p-23f, 1 - 0x1p-24f}) {
        for (int j = 0; j < 64; ++j) {
          const auto sample = light.sample(from, {x, static_cast<float>(j) / 64});
          EXPECT_EQ(light.pdf(from, sample.direction).value(), sample.density.value()) << ratio << ' ' << x;
        }
      }
    }
  }
}

// Rounding moves a direction by at most 2 ulp of 1 rad. The support ends 4 ulp of 1 rad past the
// rim, plus 8 ulp of the chord.
TEST(SphereByCone, EndsBeyondTheRim) {
  const SphereByCone<float> light(unit_sphere<float>());
  for (double ratio : {0.5, 1e-2, 1e-5, 1e-7, 1e-16}) {
    for (const Vec3<double>& towards : all_around) {
      const FarSphere sphere(towards, ratio);
      for (int j = 0; j < 64; ++j) {
        const Vec3<float> beyond = sphere.past_the_rim((8 + 16 * ratio) * rad, 2 * M_PI * j / 64);
        EXPECT_EQ(light.pdf(sphere.from, beyond).value(), 0) << ratio;
      }
      EXPECT_EQ(light.pdf(sphere.from, Vec3<float>(sphere.from.normalized())).value(), 0) << ratio;
    }
  }
}

// By area the density is t^2 / (4 pi r^2 cos), which is smallest for the line through the centre.
// At the rim itself it would be infinite, and is 0 there; none of these directions rounds to it.
TEST(SphereByArea, HasADensityInFloatsUpToTheRim) {
  const SphereByArea<float> whole_sphere(unit_sphere<float>());
  const SphereByVisibleHemisphere<float> half(unit_sphere<float>());
  for (double ratio : {0.5, 0.1, 1e-2, 1e-4, 1e-5, 1e-6}) {
    over_the_cap(ratio, [&](const FarSphere& sphere, const Vec3<float>& direction) {
      const double d = sphere.from.cast<double>().norm();
      const double least = (d - 1) * (d - 1) / (4 * M_PI);
      const double density = static_cast<double>(whole_sphere.pdf(sphere.from, direction).value());
      EXPECT_GE(density, 0.999 * least) << ratio;
      EXPECT_LT(density, INFINITY) << ratio;
      EXPECT_GE(static_cast<double>(half.pdf(sphere.from, direction).value()), 0.999 * 2 * least) << ratio;
    });
  }
}

// A square of edge 1, seen from `distance`, 0.25 of its edge off its middle: points of a grid, and
// of its edges.
TEST(RectangleLight, HasADensityInFloatsUpToTheEdge) {
  for (double distance : {1.0, 1e2, 1e5, 1e6}) {
    const RectangleLight<float> light({-0.75f, -0.25f, static_cast<float>(distance)}, {1, 0, 0}, {0, 1, 0});
    for (int i = 0; i <= 32; ++i) {
      for (int j = 0; j <= 32; ++j) {
        const Vec3<double> hit(-0.75 + i / 32.0, -0.25 + j / 32.0, distance);
        const Vec3<float> direction = hit.normalized().cast<float>();
        EXPECT_GT(RectangleByArea<float>(light).pdf({0, 0, 0}, direction).value(), 0) << hit.transpose();
        EXPECT_GT(RectangleBySolidAngle<float>(light).pdf({0, 0, 0}, direction).value(), 0) << hit.transpose();
      }
    }
    const Vec3<double> beyond(0.25 + 8 * rad * distance, 0, distance);
    EXPECT_EQ(RectangleByArea<float>(light).pdf({0, 0, 0}, beyond.normalized().cast<float>()).value(), 0);
  }
}

}  // namespace
}  // namespace fairlight
