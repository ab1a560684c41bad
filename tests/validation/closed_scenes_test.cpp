#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fairlight/validation/claims/pairwise_cover.h>
#include <fairlight/validation/claims/rendered_radiance.h>

namespace fairlight {
namespace {

TEST(ConcentricSpheres, AddLightDepthByDepth) {
  const auto radiance = concentric_spheres().radiance;
  EXPECT_TRUE(radiance(0).isApprox(Rgb<double>(1, 2, 0.5)));
  // 1 + 0.2 (3/4 + 3/4), 2 + 0.4 (6/4 + 1/4), 0.5 + 0.6 (0.375 + 1/4)
  EXPECT_TRUE(radiance(1).isApprox(Rgb<double>(1.3, 2.7, 0.875)));
}

// Of equal emission and albedo it would be a furnace; as it is, the two equations hold in the end.
TEST(ConcentricSpheres, AreInBalance) {
  const Rgb<double> outer = concentric_spheres().radiance(400);
  const Rgb<double> inner = Rgb<double>(3, 1, 1) + Rgb<double>(0.25, 0.15, 0.05) * outer;
  const Rgb<double> balance = Rgb<double>(1, 2, 0.5) + Rgb<double>(0.2, 0.4, 0.6) * (0.75 * outer + 0.25 * inner);
  EXPECT_TRUE(outer.isApprox(balance, 1e-14));
}

TEST(LitBox, IsAGeometricSeries) {
  const auto radiance = lit_box().radiance;
  EXPECT_TRUE(radiance(0).isApprox(Rgb<double>(1, 2, 0.5)));
  EXPECT_TRUE(radiance(2).isApprox(Rgb<double>(1.39, 3.5, 1.095)));
}

// A camera's rays, from the edge of its lens and as far out as a filter reaches, see what the closed form is about.
TEST(ClosedScene, ShowsOneSurfaceToItsCamera) {
  for (const ClosedScene& scene : {concentric_spheres(), lit_box()}) {
    RenderSettings settings;
    settings.aperture = 0.2;
    settings.filter = PixelFilter::blackman_harris;
    settings.max_depth = 0;
    settings.direct = DirectLighting::none;
    RenderedPixels draws(with_camera_of(settings, scene.view), settings, StreamKey(1, "camera"));
    for (std::uint64_t i = 0; i < 1024; ++i) EXPECT_TRUE(draws.at(i).isApprox(scene.radiance(0), 1e-6)) << i;
  }
}

// What reflects all is not seen, pixel for pixel; a little less is.
TEST(WhiteSky, ShowsNothingButTheSky) {
  for (const Arithmetic real : {Arithmetic::doubles, Arithmetic::packets}) {
    RenderSettings settings;
    settings.real = real;
    settings.direct = DirectLighting::none;
    ClosedScene scene = white_sky();
    RenderedPixels draws(scene.view, settings, StreamKey(1, "white"));
    for (std::uint64_t i = 0; i < 1024; ++i) EXPECT_TRUE(draws.at(i).isApprox(scene.radiance(-1), 1e-5)) << i;
    scene.view.scene.add_sphere({0, 0, 3}, 0.5, Rgb<double>(0.9, 0.9, 0.9), Rgb<double>(0, 0, 0));
    RenderedPixels seen(scene.view, settings, StreamKey(1, "grey"));
    EXPECT_TRUE((seen.at(16 * 32 + 16) < 0.91 * scene.radiance(-1)).all());
  }
}

TEST(RenderedPixels, AreMeansOfAsManySamplesAsTheyAreToldTo) {
  RenderSettings settings;
  settings.max_depth = 2;
  settings.filter = PixelFilter::box;
  const View view = concentric_spheres().view;
  const StreamKey key(1, "many");
  RenderedPixels two(view, settings, key, 2), one(view, settings, key);
  const Rgb<double> mean = (one.at(7) + one.at(1024 + 7)) / 2;
  EXPECT_TRUE(two.at(7).isApprox(mean, 1e-12));
}

TEST(RenderedPixels, AreThoseOfTheirKeyAndNumber) {
  RenderSettings settings;
  settings.max_depth = 2;
  const View view = concentric_spheres().view;
  RenderedPixels draws(view, settings, StreamKey(1, "a")), again(view, settings, StreamKey(1, "a")),
      others(view, settings, StreamKey(1, "b"));
  const Rgb<double> first = draws.at(0), later = draws.at(5000);
  EXPECT_TRUE((again.at(5000) == later).all());
  EXPECT_TRUE((again.at(0) == first).all());
  int by_key = 0, by_picture = 0;
  for (std::uint64_t i = 0; i < 16; ++i) {
    by_key += (others.at(i) == draws.at(i)).all() ? 1 : 0;
    by_picture += (draws.at(1024 + i) == draws.at(i)).all() ? 1 : 0;
  }
  EXPECT_LT(by_key, 8);
  EXPECT_LT(by_picture, 8);
}

// About the eye stands what is brighter than a film holds.
TEST(RenderedPixels, AreNoNumbersWhereTheRendererRefusesThem) {
  View view = lit_box().view;
  view.scene.add_sphere(view.camera.settings().eye, 0.1, Rgb<double>(0, 0, 0), Rgb<double>(1e25, 0, 0));
  RenderSettings settings;
  settings.real = Arithmetic::doubles;
  settings.max_depth = 0;
  RenderedPixels draws(view, settings, StreamKey(1, "bright"));
  EXPECT_TRUE(draws.at(0).isNaN().all());
  EXPECT_TRUE(draws.at(1).isNaN().all());
}

// Of at most two bounces, where surfaces emit 3 at most and reflect 0.6, each vertex's shadow rays bringing 5 at most, by uniform bounces:
// 3 + (5 + 2 x 3) + 2 (5 + 2 x 3), or with 2 x 0.6 in place of 2; by shadow rays alone 3 + 5 + 10, by bounces alone 3 + 6 + 12.
TEST(RenderedPixels, AreBoundedVertexByVertex) {
  ClosedScene scene = concentric_spheres();
  scene.largest_term = {5, 5, 5};
  RenderSettings settings;
  settings.max_depth = 2;
  settings.bounce = BounceSampling::uniform;
  const auto upper = [&](DirectLighting direct) {
    settings.direct = direct;
    return references_of(scene, settings)[0].upper;
  };
  EXPECT_EQ(upper(DirectLighting::mis), 36);
  EXPECT_EQ(upper(DirectLighting::light), 18);
  EXPECT_EQ(upper(DirectLighting::none), 21);
  settings.roulette = RouletteKind::off;
  EXPECT_DOUBLE_EQ(upper(DirectLighting::mis), 3 + 8.6 + 1.2 * 8.6);
  // A survivor carries at most 2, and in front of glass of index 1.5 2.25 times as much.
  settings.roulette = RouletteKind::throughput;
  EXPECT_NEAR(upper(DirectLighting::mis), 2 * (3 + 8.6 + 1.2 * 8.6), 1e-9);
  scene.index = 1.5;
  EXPECT_NEAR(upper(DirectLighting::mis), 4.5 * (3 + 8.6 + 1.2 * 8.6), 1e-9);
}

using Values = std::map<std::string, std::set<std::string>>;
std::vector<std::string> all_kinds() {
  std::vector<std::string> kinds{"aperture"};
  for_each_strategy_kind([&](const auto& table) { kinds.push_back(table.setting); });
  return kinds;
}

bool chooses(const nlohmann::json& row, const std::string& kind) {
  return row.at("direct") != "none" || (kind != "light_sampling" && kind != "which_light");
}

// How many pairs of values there should be: all, but that a search is no search by shadow rays where there are none, and that
// rectangles are sampled by area only with shared light.
std::size_t possible(const Values& values, const std::string& a, const std::string& b, bool spheres) {
  const auto kind = [&](const std::string& one, const std::string& other) {
    return (a == one && b == other) || (a == other && b == one);
  };
  if (kind("direct", "light_sampling")) return spheres ? 6 : 3;
  if (kind("direct", "which_light")) return 2 * values.at("which_light").size();
  return values.at(a).size() * values.at(b).size();
}

TEST(PairwiseCover, MakesEveryTwoStrategiesMeet) {
  const std::vector<std::string> kinds = all_kinds();
  for (const bool spheres : {true, false}) {
    Values values;
    std::map<std::pair<std::string, std::string>, std::set<std::pair<std::string, std::string>>> met;
    for (const nlohmann::json row :
         PairwiseCover(spheres ? searches_of_spheres() : searches_of_rectangles(), 5).rows()) {
      for (const std::string& a : kinds) {
        if (!chooses(row, a)) continue;
        values[a].insert(row.at(a).dump());
        for (const std::string& b : kinds) {
          if (chooses(row, b)) met[{a, b}].insert({row.at(a).dump(), row.at(b).dump()});
        }
      }
    }
    for_each_strategy_kind([&](const auto& table) {
      if (std::string(table.setting) == StrategyTable<LightPoints>::setting) return;  // as the scene admits
      EXPECT_EQ(values[table.setting].size(), table.rows.size()) << table.setting;
    });
    for (const std::string& a : kinds) {
      for (const std::string& b : kinds) {
        if (a == b) continue;
        EXPECT_EQ((met[{a, b}].size()), possible(values, a, b, spheres)) << a << " " << b;
      }
    }
  }
}

// 2 bounces x 7 searches x 4 choices; each of them with shadow rays is there once, and none has the name of another.
TEST(PairwiseCover, IsWholeInWhatFindsLight) {
  std::set<std::tuple<BounceSampling, DirectLighting, LightPoints, WhichLight>> found;
  std::set<std::string> names;
  for (const RenderSettings& row : PairwiseCover(searches_of_spheres(), 5).rows()) {
    found.insert({row.bounce, row.direct, row.light_sampling, row.which_light});
    names.insert(rendered_radiance(concentric_spheres(), row).name);
    EXPECT_EQ(row.max_depth, row.bounce == BounceSampling::uniform ? 3 : 5);
  }
  EXPECT_EQ(found.size(), 2u * (6 * 4 + 1));
  EXPECT_EQ(names.size(), 2u * 7 * 4);
}

}  // namespace
}  // namespace fairlight
