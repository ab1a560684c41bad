#include <gtest/gtest.h>
#include <support/run_seed.h>

#include <fairlight/validation/claims/paired_paths.h>

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

// Four quarters, of which the third is brighter than it is claimed to be.
Finding found_in_quarters(const Trial& trial, double third) {
  const View view = built_in_scene("cornell-simple");
  std::vector<Reference> references(4, Reference{.mean = 1, .lower = 0, .upper = 2});
  references[2].mean = third;
  const auto draw = [](const Ray<Packet>&, auto& source) {
    return Rgb<Packet>(Rgb<Packet>::Constant(Packet(2) * source.next()));
  };
  return check_parts<PictureTiles<2>>(trial, view.camera, references, draw);
}

TEST(CheckParts, HoldsEachPartToItsReference) {
  Evidence evidence;
  Trial trial{"paired_paths_test", testing::run_seed(), 1e-6, 0.01, 0.05};
  trial.evidence = &evidence;
  EXPECT_EQ(found_in_quarters(trial, 1).verdict, Verdict::certified);
  EXPECT_EQ(evidence.means.size(), 4u);
  EXPECT_EQ(evidence.margin_grid.channels.size(), 4u);
  evidence = {};
  EXPECT_EQ(found_in_quarters(trial, 0.9).verdict, Verdict::biased);
  leave_tiles(trial, std::vector<double>(4, 1), 2);
  EXPECT_GT(evidence.tiles.biases[2], 0.05);
  EXPECT_EQ(evidence.tiles.biases.size(), 4u);
}

TEST(CheckParts, EndsWithThePartThatIsToldTo) {
  Evidence evidence;
  Trial trial{"paired_paths_test", testing::run_seed(), 1e-6, 0.01, 0.05};
  trial.evidence = &evidence;
  trial.watch = [&](double done) { return done < 0.3; };
  EXPECT_EQ(found_in_quarters(trial, 0.9).verdict, Verdict::undecided);
  EXPECT_EQ(evidence.means.size(), 2u);
  leave_tiles(trial, std::vector<double>(4, 1), 2);
  EXPECT_EQ(evidence.tiles.biases[2], 0);
  ASSERT_EQ(evidence.margin_grid.channels.size(), 4u);
  EXPECT_GT(evidence.margin_grid.channels[0][0].above_lower_margin, 0);
  EXPECT_EQ(evidence.margin_grid.channels[3][0].above_lower_margin, 0);
}

TEST(CheckParts, SaysHowMuchOfAllPartsIsDone) {
  Trial trial{"paired_paths_test", testing::run_seed(), 1e-6, 0.01, 0.05};
  std::vector<double> told;
  trial.watch = [&](double done) {
    told.push_back(done);
    return true;
  };
  found_in_quarters(trial, 1);
  EXPECT_LT(told.front(), 0.25);
  EXPECT_GT(told.back(), 0.75);
  EXPECT_LT(told.back(), 1);
}

TEST(WholeOfParts, IsTheLargestBiasOfTheWorstVerdict) {
  Finding right{Verdict::certified}, wrong{Verdict::biased}, noisy{Verdict::certified};
  right.draws = wrong.draws = noisy.draws = 10;
  right.bias = 0.1;
  wrong.bias = 0.2;
  wrong.note = "why";
  noisy.bias = -0.3;
  const Finding whole = whole_of_parts({right, wrong, noisy});
  EXPECT_EQ(whole.verdict, Verdict::biased);
  EXPECT_EQ(whole.bias, 0.2);
  EXPECT_EQ(whole.note, "why");
  EXPECT_EQ(whole.draws, 30u);
  EXPECT_EQ(whole_of_parts({right, noisy}).bias, -0.3);
}

// A strategy against itself brings nothing, whatever the path: also what the camera sees of the
// light. Against another it does on most paths.
TEST(DirectDifference, OfAStrategyAndItselfIsNothing) {
  const View view = built_in_scene("cornell-simple");
  RenderSettings settings;
  settings.direct = DirectLighting::mis;
  settings.light_sampling = LightPoints::cone;
  settings.max_depth = 3;
  RenderSettings other = settings;
  other.direct = DirectLighting::light;
  const auto tracer = paired_tracers(settings, settings, view.scene)(std::type_identity<double>{});
  const auto between_two = paired_tracers(settings, other, view.scene)(std::type_identity<double>{});
  int different = 0;
  const TracedScene<double> scene(view.scene);
  for (std::uint64_t i = 0; i < 256; ++i) {
    PhiloxStream<double> source(StreamKey(5, "paths"), 0, i);
    const double x = (static_cast<double>(i % 16) + 0.5) / 16, y = (static_cast<double>(i / 16) + 0.5) / 16;
    const Ray<double> ray = view.camera.ray<double>(x, y, 1, 1);
    const Rgb<double> difference = tracer.radiance<double>(scene, ray, source);
    EXPECT_TRUE((difference == 0).all()) << x << " " << y;
    PhiloxStream<double> again(StreamKey(5, "paths"), 0, i);
    different += (between_two.radiance<double>(scene, ray, again) != 0).any() ? 1 : 0;
  }
  EXPECT_GT(different, 128);
}

}  // namespace
}  // namespace fairlight
