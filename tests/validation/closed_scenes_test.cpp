#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fairlight/validation/analytic/rendered_radiance.h>
#include <fairlight/validation/strategy_cross.h>

namespace fairlight {
namespace {

const std::vector<LightSearch> searches{{"none", "area"},  {"light", "area"}, {"light", "visible"},
                                        {"light", "cone"}, {"mis", "area"},   {"mis", "visible"},
                                        {"mis", "cone"}};

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

// Every ray of a camera, also from the edge of its lens, sees what the closed form is about.
TEST(ClosedScene, ShowsOneSurfaceToItsCamera) {
  for (const ClosedScene& scene : {concentric_spheres(), lit_box()}) {
    RenderSettings settings;
    settings.aperture = 0.2;
    settings.max_depth = 0;
    settings.direct = "none";
    PixelDraws draws(with_camera_of(settings, scene.view), settings, 1);
    for (std::uint64_t i = 0; i < 1024; ++i) EXPECT_TRUE(draws.at(i).isApprox(scene.radiance(0), 1e-6)) << i;
  }
}

TEST(PixelDraws, AreThoseOfTheirSeedAndNumber) {
  RenderSettings settings;
  settings.max_depth = 2;
  const View view = concentric_spheres().view;
  PixelDraws draws(view, settings, 1), again(view, settings, 1), others(view, settings, 2);
  const Rgb<double> first = draws.at(0), later = draws.at(5000);
  EXPECT_TRUE((again.at(5000) == later).all());
  EXPECT_TRUE((again.at(0) == first).all());
  int by_seed = 0, by_picture = 0;
  for (std::uint64_t i = 0; i < 16; ++i) {
    by_seed += (others.at(i) == draws.at(i)).all() ? 1 : 0;
    by_picture += (draws.at(1024 + i) == draws.at(i)).all() ? 1 : 0;
  }
  EXPECT_LT(by_seed, 8);
  EXPECT_LT(by_picture, 8);
}

// Of at most two bounces, each vertex bringing 5 at most, by uniform bounces: 1 + (5 + 2) + 2 (5 + 2), or with 2 x 0.75 in place of 2.
TEST(PixelDraws, AreBoundedVertexByVertex) {
  const auto one = [](int) { return Rgb<double>(1, 1, 1); };
  const ClosedScene scene{concentric_spheres().view, one, {1, 1, 1}, {5, 5, 5}, 0.75};
  RenderSettings settings;
  settings.max_depth = 2;
  settings.bounce = "uniform";
  EXPECT_EQ(references_of(scene, settings)[0].upper, 22);
  settings.roulette = "off";
  EXPECT_EQ(references_of(scene, settings)[0].upper, 17.25);
}

using Values = std::map<std::string, std::set<std::string>>;
const std::vector<std::string> kinds{"bounce", "direct", "light_sampling", "which_light", "roulette",
                                     "random", "filter", "aperture",       "real"};

bool chooses(const nlohmann::json& row, const std::string& kind) {
  return row.at("direct") != "none" || (kind != "light_sampling" && kind != "which_light");
}

TEST(StrategyCross, MakesEveryTwoStrategiesMeet) {
  Values values;
  std::map<std::pair<std::string, std::string>, std::set<std::pair<std::string, std::string>>> met;
  for (const nlohmann::json row : StrategyCross(searches, 5).rows()) {
    for (const std::string& a : kinds) {
      if (!chooses(row, a)) continue;
      values[a].insert(row.at(a).dump());
      for (const std::string& b : kinds) {
        if (chooses(row, b)) met[{a, b}].insert({row.at(a).dump(), row.at(b).dump()});
      }
    }
  }
  EXPECT_EQ(values["filter"].size(), 4u);
  for (const std::string& a : kinds) {
    for (const std::string& b : kinds) {
      const bool needs_shadow_rays = a == "light_sampling" || a == "which_light";
      const std::size_t of_b = b == "direct" && needs_shadow_rays ? 2 : values[b].size();
      const std::size_t of_a =
          a == "direct" && (b == "light_sampling" || b == "which_light") ? 2 : values[a].size();
      if (a == b) continue;
      EXPECT_EQ((met[{a, b}].size()), of_a * of_b) << a << " " << b;
    }
  }
}

// 2 bounces x 7 searches x 4 choices; each of them with shadow rays is there once, and none has the name of another.
TEST(StrategyCross, IsWholeInWhatFindsLight) {
  std::set<std::string> found, names;
  for (const RenderSettings& row : StrategyCross(searches, 5).rows()) {
    found.insert(row.bounce + row.direct + row.light_sampling + row.which_light);
    names.insert(rendered_radiance(concentric_spheres(), row).name);
    EXPECT_EQ(row.max_depth, 5);
  }
  EXPECT_EQ(found.size(), 2u * (6 * 4 + 1));
  EXPECT_EQ(names.size(), 2u * 7 * 4);
}

}  // namespace
}  // namespace fairlight
