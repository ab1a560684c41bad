#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include <fairlight/validation/studies/confusion.h>
#include <fairlight/validation/studies/montelight_tracer.h>
#include <fairlight/validation/studies/pictures.h>
#include <fairlight/validation/studies/renders.h>
#include <fairlight/validation/studies/scenes.h>

namespace fairlight {
namespace {

TEST(StudyScenes, TheLightOfThePaperGivesThePapersBox) {
  const std::vector<Surface> box = box_with_light(1.5).scene.surfaces(), paper = cornell_simple().scene.surfaces();
  ASSERT_EQ(box.size(), paper.size());
  for (std::size_t i = 0; i < box.size(); ++i) {
    EXPECT_NEAR(box[i].shape.curvature, paper[i].shape.curvature, 1e-12 * paper[i].shape.curvature);
    EXPECT_EQ(box[i].shape.anchor, paper[i].shape.anchor);
    EXPECT_EQ(box[i].shape.normal, paper[i].shape.normal);
    EXPECT_TRUE((box[i].material.albedo == paper[i].material.albedo).all());
    EXPECT_TRUE((box[i].radiance == paper[i].radiance).all());
  }
}

TEST(StudyScenes, AllLightsHaveThePowerOfThePapers) {
  const double power = power_of(cornell_simple().scene.luminaires()[0]);
  for (const double radius : {8.5, 0.15}) {
    EXPECT_NEAR(power_of(box_with_light(radius).scene.luminaires()[0]), power, 1e-9 * power);
  }
  for (const int n : {2, 10, 1000}) {
    const View view = box_with_lights(n);
    ASSERT_EQ(view.scene.luminaires().size(), static_cast<std::size_t>(n));
    double sum = 0;
    for (const Luminaire& light : view.scene.luminaires()) sum += power_of(light);
    EXPECT_NEAR(sum, power, 1e-9 * power) << n;
  }
}

// Pixel values 1 and 3: mean 2, variance 2, square error of the mean 1, in one channel of three.
TEST(StudyRenders, SquareErrorIsThatOfTheCountedPixels) {
  Film film(2, 1);
  for (const double value : {1.0, 3.0}) film.add(0, 0, {value, 5, 5});
  for (const double value : {1.0, 100.0}) film.add(1, 0, {value, 5, 5});
  EXPECT_DOUBLE_EQ(square_error(film, {true, false}), 1.0 / 3);
  EXPECT_DOUBLE_EQ(mean_radiance(film, {true, false})[0], 2);
}

TEST(StudyRenders, RatiosAreOfTheFirstOverTheSecond) {
  const ArmRuns slow{{4, 4}, {3, 3}, {}}, fast{{2, 2}, {1, 1}, {}};
  EXPECT_EQ(efficiency_ratio(fast, slow).value, 6);
  EXPECT_EQ(variance_ratio(slow, fast).value, 2);
  EXPECT_EQ(time_ratio(slow, fast).value, 3);
}

// The light is at the middle of a picture 9 pixels wide, each as wide as the light.
TEST(StudyRenders, LeavesOutThePixelsAroundALight) {
  Scene scene;
  scene.add_sphere({0, 0, -10}, 0.5, Rgb<double>(0, 0, 0), Rgb<double>(1, 1, 1));
  const View view{"light", scene, Camera({.image_height = 0.9})};
  const std::vector<bool> counted = pixels_off_lights(view, 9, 9, 1);
  EXPECT_FALSE(counted[4 * 9 + 4]);
  EXPECT_FALSE(counted[4 * 9 + 5]);
  EXPECT_FALSE(counted[3 * 9 + 4]);
  EXPECT_TRUE(counted[4 * 9 + 8]);
  EXPECT_TRUE(counted[0]);
}

TEST(StudyRenders, SeedsDifferByPurposeAndReplicate) {
  const StudyOptions options{.folder = "", .seed = 3};
  EXPECT_EQ(replicate_seed(options, "a", 1), replicate_seed(options, "a", 1));
  EXPECT_NE(replicate_seed(options, "a", 1), replicate_seed(options, "a", 2));
  EXPECT_NE(replicate_seed(options, "a", 1), replicate_seed(options, "b", 1));
}

// A lens of 2 m focused at 10 m; the image plane at 1 m is 0.5 m high, so 100 pixels show 0.5.
TEST(Confusion, CircleIsTheClosedForm) {
  const CameraSettings camera{.image_height = 0.5, .aperture_radius = 2, .focus_distance = 10};
  EXPECT_EQ(circle_of_confusion(camera, 10, 100), 0);
  EXPECT_DOUBLE_EQ(circle_of_confusion(camera, 20, 100), 2 * 10.0 / (10 * 20) * 100 / 0.5);
  EXPECT_DOUBLE_EQ(circle_of_confusion(camera, 5, 100), 2 * 5.0 / (10 * 5) * 100 / 0.5);
}

TEST(Confusion, SeesAPointWhereTheCameraDoes) {
  const CameraSettings settings{.eye = {1, 2, 3}, .look = {0.2, -0.1, -1}, .image_height = 0.7};
  const Ray<double> ray = Camera(settings).ray<double>(17.25, 61.5, 120, 80);
  const SeenAt seen = seen_at(settings, ray.origin + 9 * ray.direction, 120, 80);
  EXPECT_NEAR(seen.x, 17.25, 1e-9);
  EXPECT_NEAR(seen.y, 61.5, 1e-9);
  EXPECT_NEAR(seen.distance, 9 * ray.direction.dot(settings.look.normalized()), 1e-9);
}

TEST(Montage, HasRowsOfPictures) {
  const SheetPlace first = place_on_sheet(0, 3, 100, 50), third = place_on_sheet(2, 3, 100, 50),
                   fourth = place_on_sheet(3, 3, 100, 50);
  EXPECT_EQ(first.y, third.y);
  EXPECT_EQ(first.x, fourth.x);
  EXPECT_GE(third.x - first.x, 200);
  EXPECT_GE(fourth.y - first.y, 50);
}

class Montelight : public ::testing::Test {
 protected:
  LightSample<double> sample(const MontelightFaults& faults) const {
    return MontelightPoints(faults, view_.scene).sample(lights_, 0, false, from_, {0.3, 0.7});
  }

  View view_ = box_with_light(1.5);
  LightTable<double> lights_{view_.scene};
  Vec3<double> from_{50, 0.0, 81.6};
};

TEST_F(Montelight, WithoutFaultsSamplesTheLightByArea) {
  const Luminaire& light = view_.scene.luminaires()[0];
  const SphereByArea<double> right(SphereLight<double>(light.centre, light.radius));
  const LightSample<double> drawn = sample({});
  ASSERT_GT(drawn.density.value(), 0);
  EXPECT_NEAR(drawn.density.value(), right.pdf(from_, drawn.direction).value(), 1e-6 * drawn.density.value());
  EXPECT_NEAR((from_ + drawn.distance * drawn.direction - light.centre).norm(), light.radius, 1e-9);
}

// The polar angle is pi u_x, not acos(1 - 2 u_x).
TEST_F(Montelight, ThetaIsUniform) {
  const LightSample<double> drawn = sample({.theta = true});
  const Vec3<double> normal = (from_ + drawn.distance * drawn.direction - view_.scene.luminaires()[0].centre) / 1.5;
  EXPECT_NEAR(normal.z(), std::cos(0.3 * std::numbers::pi), 1e-9);
}

TEST_F(Montelight, SolidAngleIsThatOfASphereOfOneAndAHalf) {
  const LightSample<double> drawn = sample({.solid_angle = true});
  const double cosine = std::sqrt(1 - 2.25 / (drawn.distance * drawn.distance));
  EXPECT_NEAR(drawn.density.value(), 1 / (2 * std::numbers::pi * (1 - cosine)), 1e-9 * drawn.density.value());
}

struct Constant {
  double value;
  double next() const { return value; }
};

TEST_F(Montelight, RouletteBeginsAtTheFifthBounceAndPaysUnlessItIsFaulty) {
  const Rgb<double> albedo(0.5, 0.25, 0.25), one(1, 1, 1);
  Constant low{0.1};
  EXPECT_EQ(MontelightRoulette({}).play<double>(albedo, one, 3.0, low).weight, 1);
  EXPECT_EQ(MontelightRoulette({}).play<double>(albedo, one, 4.0, low).weight, 2);
  EXPECT_EQ(MontelightRoulette({.roulette = true}).play<double>(albedo, one, 4.0, low).weight, 1);
}

TEST_F(Montelight, ClampsSamplesAtOne) {
  const Rgb<double> bright(3, 0.5, 1);
  EXPECT_TRUE((montelight_kept({}, bright) == bright).all());
  EXPECT_TRUE((montelight_kept({.clamped = true}, bright) == Rgb<double>(1, 0.5, 1)).all());
}

}  // namespace
}  // namespace fairlight
