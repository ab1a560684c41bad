#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <support/lights.h>
#include <support/unit_square.h>

#include <fairlight/estimators/rectangle_light.h>
#include <fairlight/estimators/sphere_sampling.h>

// Lights of sizes from 1e-3 to 1e5, at many distances, in every arithmetic.
namespace fairlight {
namespace {

using testing::length;

template <class Real>
class LightsOfAnySize : public ::testing::Test {};
using Arithmetics = ::testing::Types<double, float, Packet>;
TYPED_TEST_SUITE(LightsOfAnySize, Arithmetics);

double in_double(double x) { return x; }
double in_double(float x) { return static_cast<double>(x); }
double in_double(const Packet& x) { return testing::first_lane(x); }

template <class Real>
Vec3<double> in_double(const Vec3<Real>& v) {
  return {in_double(v.x()), in_double(v.y()), in_double(v.z())};
}

// Rounds to the nearest number of Real.
template <class Real>
double nearest(double x) {
  return in_double(rounded<Real>(x));
}

// A point of the square; edges are likely.
template <class Real>
Vec2<Real> any_point() {
  const auto number = [] {
    const double step = in_double(ulp<Real>) / 2;
    const auto inner = rc::gen::map(rc::gen::inRange(0, 1 << 24), [](int i) { return i * 0x1p-24; });
    return rounded<Real>(*rc::gen::oneOf(inner, rc::gen::element(0.0, step, 0.5, 1 - step)));
  };
  const Real first = number();
  return {first, number()};
}

struct Sample {
  Vec3<double> direction;
  double distance, density, density_of_direction;
};

template <class Real, class Light>
Sample sample(const Light& light, const Vec3<double>& from, const Vec2<Real>& u) {
  const LightSample<Real> drawn = light.sample(rounded_vector<Real>(from), u);
  return {in_double(drawn.direction), in_double(drawn.distance), in_double(drawn.density.value()),
          in_double(light.pdf(rounded_vector<Real>(from), drawn.direction).value())};
}

// A sphere about the origin, and a point outside, inside or on its surface.
struct SpherePlace {
  double radius;
  Vec3<double> from;
  bool on_surface;
};

template <class Real>
SpherePlace any_sphere() {
  const double radius = nearest<Real>(*length());
  const double z = 2 * *testing::unit_number() - 1;
  const Vec3<double> outward = detail::direction_at(z, std::sqrt(1 - z * z), *testing::unit_number());
  const int where = *rc::gen::inRange(0, 3);
  const double away = where == 0 ? radius + *length() : where == 1 ? radius * *testing::unit_number() : radius;
  return {radius, in_double(rounded_vector<Real>(away * outward)), where == 2};
}

template <class Real>
SphereLight<Real> light_of(const SpherePlace& place) {
  return {rounded_vector<Real>({0, 0, 0}), rounded<Real>(place.radius), Mask<Real>(place.on_surface)};
}

// The hit point has the error of the point of view and of the direction: a few ulp of their sizes.
template <class Real>
void assert_on_sphere(const SpherePlace& place, const Sample& s) {
  RC_ASSERT(s.density >= 0 && std::isfinite(s.density));
  RC_ASSERT(s.direction.allFinite());
  if (s.density == 0) return;
  const double rounding = in_double(ulp<Real>);
  RC_ASSERT(std::abs(s.direction.norm() - 1) <= 4 * rounding);
  RC_ASSERT(s.distance >= 0 && std::isfinite(s.distance));
  const Vec3<double> hit = place.from + s.distance * s.direction;
  RC_ASSERT(std::abs(hit.norm() - place.radius) <= 4 * rounding * (place.from.norm() + place.radius));
}

TYPED_TEST(LightsOfAnySize, ASphereIsMetAtTheDistanceThatIsGiven) {
  EXPECT_TRUE(rc::check([] {
    using Real = TypeParam;
    const SpherePlace place = any_sphere<Real>();
    const SphereLight<Real> sphere = light_of<Real>(place);
    const Vec2<Real> u = any_point<Real>();
    assert_on_sphere<Real>(place, sample(SphereByArea<Real>(sphere), place.from, u));
    assert_on_sphere<Real>(place, sample(SphereByVisibleHemisphere<Real>(sphere), place.from, u));
    const Sample cone = sample(SphereByCone<Real>(sphere), place.from, u);
    RC_ASSERT(cone.density > 0);
    assert_on_sphere<Real>(place, cone);
  }));
}

// Rounding gives directions an error e = 8 ulp, which is e d at the sphere. If the ray hits it at a
// cosine of 0.1 or more, the cosine has an error of 100 e d / r, and the square of the distance t
// one of 20 e d / t.
TYPED_TEST(LightsOfAnySize, ASphereByAreaHasTheDensityOfItsSamples) {
  EXPECT_TRUE(rc::check([] {
    using Real = TypeParam;
    const SpherePlace place = any_sphere<Real>();
    const SphereLight<Real> sphere = light_of<Real>(place);
    const Vec2<Real> u = any_point<Real>();
    const auto check = [&](const auto& light) {
      const Sample s = sample(light, place.from, u);
      const Vec3<double> normal = (place.from + s.distance * s.direction) / place.radius;
      if (s.density == 0 || std::abs(normal.dot(s.direction)) < 0.1) return;
      const double size = place.from.norm() + place.radius;
      const double off = 8 * in_double(ulp<Real>) * (100 * size / place.radius + 20 * size / s.distance);
      if (off < 0.1) RC_ASSERT(std::abs(s.density_of_direction / s.density - 1) <= off);
    };
    check(SphereByArea<Real>(sphere));
    check(SphereByVisibleHemisphere<Real>(sphere));
  }));
}

// The edge of the cone, at an angle of at least r / d, has the same error e. `drop` grows as the
// square of the angle.
TYPED_TEST(LightsOfAnySize, ASphereByConeHasTheDensityOfItsSamples) {
  EXPECT_TRUE(rc::check([] {
    using Real = TypeParam;
    const SpherePlace place = any_sphere<Real>();
    const Vec2<Real> u = any_point<Real>();
    const Sample s = sample(SphereByCone<Real>(light_of<Real>(place)), place.from, u);
    const double off = 8 * in_double(ulp<Real>) * std::max(1.0, place.from.norm() / place.radius);
    if (in_double(u.x()) <= 1 - 2 * off) RC_ASSERT(s.density_of_direction == s.density);
  }));
}

// A point, and so its height above the surface, has an error of 4 ulp of its distance d from the
// centre. With c = cos(a), c^2 = 1 - r^2/d^2, that is a relative error of 4 ulp / c of the cone.
// But the error of c itself is at least the root of 8 ulp.
TYPED_TEST(LightsOfAnySize, TheConeOfASphereIsThatOfDouble) {
  EXPECT_TRUE(rc::check([] {
    using Real = TypeParam;
    const SpherePlace place = any_sphere<Real>();
    RC_PRE(place.on_surface || place.from.norm() > place.radius * (1 + 16 * in_double(ulp<Real>)));
    const double found = sample(SphereByCone<Real>(light_of<Real>(place)), place.from, any_point<Real>()).density;
    const double expected =
        sample<double>(SphereByCone<double>(light_of<double>(place)), place.from, {0.5, 0.5}).density;
    const double ratio = place.radius / place.from.norm();
    const double c = std::sqrt(std::max(0.0, (1 - ratio) * (1 + ratio)));
    const double rounding = 8 * in_double(ulp<Real>);
    RC_ASSERT(std::abs(found / expected - 1) <= rounding + rounding / std::max(c, std::sqrt(rounding)));
  }));
}

// A rectangle parallel to the plane z = 0, on any side of the origin.
struct RectanglePlace {
  Vec3<double> corner;
  double width, height;

  double size() const { return corner.lpNorm<1>() + width + height; }
};

template <class Real>
RectanglePlace any_rectangle() {
  const auto coordinate = [] { return nearest<Real>(*rc::gen::element(1, -1) * *length()); };
  const double x = coordinate(), y = coordinate();
  const double z = coordinate();
  const double width = nearest<Real>(*length());
  return {{x, y, z}, width, nearest<Real>(*length())};
}

template <class Real>
RectangleLight<Real> light_of(const RectanglePlace& place) {
  return {rounded_vector<Real>(place.corner), rounded_vector<Real>({place.width, 0, 0}),
          rounded_vector<Real>({0, place.height, 0})};
}

template <class Real>
void assert_on_rectangle(const RectanglePlace& place, const Sample& s) {
  const double rounding = in_double(ulp<Real>);
  RC_ASSERT(s.density > 0 && std::isfinite(s.density));
  RC_ASSERT(std::abs(s.direction.norm() - 1) <= 4 * rounding);
  const Vec3<double> hit = s.distance * s.direction - place.corner;
  const double slack = 8 * rounding * place.size();
  RC_ASSERT(std::abs(hit.z()) <= slack);
  RC_ASSERT(hit.x() >= -slack && hit.x() <= place.width + slack);
  RC_ASSERT(hit.y() >= -slack && hit.y() <= place.height + slack);
}

TYPED_TEST(LightsOfAnySize, ARectangleIsMetAtTheDistanceThatIsGiven) {
  EXPECT_TRUE(rc::check([] {
    using Real = TypeParam;
    const RectanglePlace place = any_rectangle<Real>();
    const RectangleLight<Real> light = light_of<Real>(place);
    const Vec2<Real> u = any_point<Real>();
    assert_on_rectangle<Real>(place, sample(RectangleByArea<Real>(light), {0, 0, 0}, u));
    assert_on_rectangle<Real>(place, sample(RectangleBySolidAngle<Real>(light), {0, 0, 0}, u));
  }));
}

// Nothing cancels, even for a distant rectangle or a grazing view: each of about thirty operations
// adds about an ulp.
TYPED_TEST(LightsOfAnySize, TheSolidAngleOfARectangleIsThatOfDouble) {
  EXPECT_TRUE(rc::check([] {
    using Real = TypeParam;
    const RectanglePlace place = any_rectangle<Real>();
    const double found =
        sample(RectangleBySolidAngle<Real>(light_of<Real>(place)), {0, 0, 0}, any_point<Real>()).density;
    const double expected =
        sample<double>(RectangleBySolidAngle<double>(light_of<double>(place)), {0, 0, 0}, {0.5, 0.5}).density;
    RC_ASSERT(std::abs(found / expected - 1) <= 32 * in_double(ulp<Real>));
  }));
}

// Applies where the hit is inside by more than its rounding error, e = 16 ulp of its size, and the
// plane is farther away than that.
TYPED_TEST(LightsOfAnySize, ARectangleHasTheDensityOfItsSamples) {
  EXPECT_TRUE(rc::check([] {
    using Real = TypeParam;
    const RectanglePlace place = any_rectangle<Real>();
    const RectangleLight<Real> rectangle = light_of<Real>(place);
    const Vec2<Real> u = any_point<Real>();
    const double rounding = 16 * in_double(ulp<Real>);
    const auto check = [&](const auto& light) {
      const Sample s = sample(light, {0, 0, 0}, u);
      const double off = rounding * place.size() / std::abs(place.corner.z());
      const Vec3<double> hit = s.distance * s.direction - place.corner;
      const double inside = std::min({hit.x(), hit.y(), place.width - hit.x(), place.height - hit.y()});
      if (off > 0.1 || inside <= off * s.distance) return;
      RC_ASSERT(std::abs(s.density_of_direction / s.density - 1) <= 4 * off);
    };
    check(RectangleByArea<Real>(rectangle));
    check(RectangleBySolidAngle<Real>(rectangle));
  }));
}

}  // namespace
}  // namespace fairlight
