#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fairlight/estimators/stream.h>
#include <fairlight/validation/claims/related_scenes.h>

namespace fairlight {
namespace {

// A quarter turn about z: x to y.
Eigen::Matrix3d quarter_turn() {
  Eigen::Matrix3d turn;
  turn << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  return turn;
}

Scene one_of_each() {
  Scene scene;
  scene.add_sphere({1, 2, 3}, 0.5, Rgb<double>(0.25, 0.5, 0.75), Rgb<double>(1, 2, 3));
  scene.add_rectangle({4, 0, 0}, {2, 0, 0}, {0, 0, 6}, Rgb<double>(0.5, 0.5, 0.5), Rgb<double>(4, 0, 0));
  return scene;
}

TEST(Moved, ScalesAndTurnsAndThenShifts) {
  const Scene scene = moved(one_of_each(), {10, quarter_turn(), {100, 0, 0}});
  const Luminaire& sphere = scene.luminaires()[0];
  EXPECT_EQ(sphere.radius, 5);
  EXPECT_LT((sphere.centre - Vec3<double>(80, 10, 30)).norm(), 1e-12);
  const Luminaire& rectangle = scene.luminaires()[1];
  EXPECT_LT((rectangle.centre - Vec3<double>(100, 50, 30)).norm(), 1e-12);
  EXPECT_LT((rectangle.edge_x - Vec3<double>(0, 20, 0)).norm(), 1e-12);
  EXPECT_LT((rectangle.edge_y - Vec3<double>(0, 0, 60)).norm(), 1e-12);
  EXPECT_LT((scene.surfaces()[1].shape.normal - quarter_turn() * one_of_each().surfaces()[1].shape.normal).norm(),
            1e-15);
}

TEST(Moved, TakesTheCameraWithIt) {
  const View hall = hallway();
  const CameraSettings still = hall.camera.settings();
  const CameraSettings camera = moved(hall, {2, quarter_turn(), {1, 0, 0}}).camera.settings();
  EXPECT_EQ(camera.eye, Vec3<double>(1 - 2 * still.eye.y(), 2 * still.eye.x(), 2 * still.eye.z()));
  EXPECT_EQ(camera.look, Vec3<double>(-still.look.y(), still.look.x(), still.look.z()));
  EXPECT_EQ(camera.aperture_radius, 2 * still.aperture_radius);
  EXPECT_EQ(camera.focus_distance, 2 * still.focus_distance);
  EXPECT_EQ(camera.image_height, still.image_height);
}

// A ray of the moved camera is the moved ray, through the lens too.
RC_GTEST_PROP(Moved, TheCamerasRaysAreMovedRays, ()) {
  const auto number = [] { return *rc::gen::inRange(0, 1024) / 1024.0; };
  const View hall = hallway();
  const Similarity move{0.5 + number(),
                        Eigen::AngleAxisd(6 * number(), Vec3<double>(1, 2, 2) / 3).matrix(),
                        {number(), 0, -number()}};
  const double x = number(), y = number();
  PhiloxStream<double> lens(StreamKey(3, "lens"), 0, 0);
  auto same = lens;
  const Ray<double> ray = hall.camera.ray<double>(x, y, 1, 1, lens);
  const Ray<double> other = moved(hall, move).camera.ray<double>(x, y, 1, 1, same);
  RC_ASSERT((other.origin - move.point(ray.origin)).norm() < 1e-11);
  RC_ASSERT((other.direction - move.direction(ray.direction)).norm() < 1e-14);
}

TEST(WithSplitLights, CutsARectangleInTwoAndLeavesTheRest) {
  const Scene scene = with_split_lights(one_of_each(), 0.25);
  ASSERT_EQ(scene.luminaires().size(), 3u);
  EXPECT_EQ(scene.luminaires()[0].radius, 0.5);
  const Luminaire &quarter = scene.luminaires()[1], &rest = scene.luminaires()[2];
  EXPECT_LT((quarter.centre - Vec3<double>(4.25, 0, 3)).norm(), 1e-12);
  EXPECT_LT((quarter.edge_x - Vec3<double>(0.5, 0, 0)).norm(), 1e-12);
  EXPECT_LT((rest.centre - Vec3<double>(5.25, 0, 3)).norm(), 1e-12);
  EXPECT_LT((rest.edge_x - Vec3<double>(1.5, 0, 0)).norm(), 1e-12);
  EXPECT_LT((rest.edge_y - Vec3<double>(0, 0, 6)).norm(), 1e-12);
  EXPECT_EQ(power_of(quarter) + power_of(rest), power_of(one_of_each().luminaires()[1]));
}

TEST(RelatedScenes, ChangeLightAlbedoOrOrderAlone) {
  const Scene scene = one_of_each();
  EXPECT_EQ(with_radiances(scene, 2).luminaires()[0].radiance[2], 6);
  EXPECT_EQ(with_radiances(scene, 2).surfaces()[0].material.albedo[2], 0.75);
  EXPECT_EQ(with_albedos(scene, 0.5).surfaces()[0].material.albedo[2], 0.375);
  EXPECT_EQ(with_albedos(scene, 0.5).luminaires()[0].radiance[2], 3);
  const Scene reversed = in_reverse_order(scene);
  EXPECT_TRUE(reversed.luminaires()[0].is_rectangle);
  EXPECT_EQ(reversed.luminaires()[0].surface, 0);
  EXPECT_EQ(reversed.luminaires()[1].radius, 0.5);
}

}  // namespace
}  // namespace fairlight
