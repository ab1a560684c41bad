#include <gtest/gtest.h>

#include <fairlight/validation/agreements/paired_paths.h>

namespace fairlight {
namespace {

Vec2<double> on_the_border(double x, double y) { return PictureBorder::place<double>(0, {x, y}); }

// Of a quarter of the numbers each, clockwise: the upper strip, the right one, the lower and the left one, each up to the next.
TEST(PictureBorder, IsFourStripsThatDoNotOverlap) {
  EXPECT_EQ(on_the_border(0, 0), Vec2<double>(0, 0));
  EXPECT_EQ(on_the_border(0.125, 0.5), Vec2<double>(31.0 / 64, 1.0 / 64));
  EXPECT_EQ(on_the_border(0.25, 0), Vec2<double>(31.0 / 32, 0));
  EXPECT_EQ(on_the_border(0.375, 0.5), Vec2<double>(63.0 / 64, 31.0 / 64));
  EXPECT_EQ(on_the_border(0.5, 0), Vec2<double>(1.0 / 32, 31.0 / 32));
  EXPECT_EQ(on_the_border(0.625, 0.5), Vec2<double>(33.0 / 64, 63.0 / 64));
  EXPECT_EQ(on_the_border(0.75, 0), Vec2<double>(0, 1.0 / 32));
  EXPECT_EQ(on_the_border(0.875, 0.5), Vec2<double>(1.0 / 64, 33.0 / 64));
}

TEST(PictureBorder, IsTheSameInPackets) {
  for (const double x : {0.0, 0.2, 0.25, 0.4, 0.5, 0.6, 0.75, 0.9}) {
    const Vec2<Packet> u(rounded<Packet>(x), rounded<Packet>(0.25));
    const Vec2<double> place = detail::lane_of(PictureBorder::place<Packet>(0, u), 0);
    EXPECT_LT((place - on_the_border(x, 0.25)).norm(), 1e-6) << x;
  }
}

TEST(PictureTiles, AreNumberedRowByRow) {
  EXPECT_EQ(PictureTiles<8>::parts, 64u);
  EXPECT_EQ(PictureTiles<8>::place<double>(0, {0.5, 0.5}), Vec2<double>(1.0 / 16, 1.0 / 16));
  EXPECT_EQ(PictureTiles<8>::place<double>(7, {0.5, 0}), Vec2<double>(15.0 / 16, 0));
  EXPECT_EQ(PictureTiles<8>::place<double>(8, {0, 0}), Vec2<double>(0, 1.0 / 8));
}

// A strategy against itself brings nothing, whatever the path: also what the camera sees of the light.
TEST(DirectDifference, OfAStrategyAndItselfIsNothing) {
  const View view = built_in_scene("cornell-simple");
  RenderSettings settings;
  settings.direct = "mis";
  settings.light_sampling = "cone";
  settings.max_depth = 3;
  const auto tracer = paired_tracers(settings, settings, view.scene)(std::type_identity<double>{});
  const TracedScene<double> scene(view.scene);
  for (std::uint64_t i = 0; i < 256; ++i) {
    PhiloxStream<double> source(StreamKey(5, "paths"), 0, i);
    const double x = (static_cast<double>(i % 16) + 0.5) / 16, y = (static_cast<double>(i / 16) + 0.5) / 16;
    const Rgb<double> difference = tracer.radiance<double>(scene, view.camera.ray<double>(x, y, 1, 1), source);
    EXPECT_TRUE((difference == 0).all()) << x << " " << y;
  }
}

}  // namespace
}  // namespace fairlight
