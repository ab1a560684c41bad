#include <gtest/gtest.h>

#include <fairlight/validation/claims/scene_agreements.h>

namespace fairlight {
namespace {

// What the camera of cornell-simple sees of emission through a place of the picture.
double emission_at(double x, double y) {
  const View view = built_in_scene("cornell-simple");
  const TracedScene<double> scene(view.scene);
  PhiloxStream<double> source(StreamKey(1, "a pinhole draws nothing"), 0, 0);
  const Hit<double> hit = scene.intersect(view.camera.ray<double>(x, y, 1, 1, source), true);
  return hit.surface < 0 ? 0 : scene.materials().emission(to_int(hit.surface))[0];
}

// Else the claim that compares what packets and doubles see of the light would compare nothing with nothing.
TEST(AroundTheLightOfCornellSimple, HasTheLightInItsMiddleAndNoneAtItsEdge) {
  const auto [left, top, side] = around_the_light_of_cornell_simple;
  EXPECT_EQ(emission_at(left + side / 2, top + side / 2), 400);
  for (int i = 0; i <= 64; ++i) {
    const double along = side * i / 64;
    for (const auto& [x, y] : {std::pair{along, 0.0}, {along, side}, {0.0, along}, {side, along}})
      EXPECT_EQ(emission_at(left + x, top + y), 0) << x << " " << y;
  }
}

}  // namespace
}  // namespace fairlight
