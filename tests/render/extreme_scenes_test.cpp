#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include <fairlight/render/instruction_sets.h>
#include <fairlight/render/render_image.h>
#include <fairlight/stats/text.h>

// Scenes at the edge of what there is: a camera inside a sphere, numbers that doubles or floats hardly hold. What every path must
// find is known in each, so nothing here is left to chance.
namespace fairlight {
namespace {

const Rgb<double> black(0, 0, 0);
const Rgb<double> half(0.5, 0.5, 0.5);
const Rgb<double> white(1, 1, 1);
const Rgb<double> lit(1, 2, 4);
const Material glass(Material::Kind::glass, white, 1.5);

// Every arithmetic of this machine.
struct Compiled {
  Arithmetic real;
  std::string instructions;
};
std::vector<Compiled> arithmetics() {
  std::vector<Compiled> all{{Arithmetic::doubles, ""}};
  for (const InstructionSet& set : instruction_sets()) {
    if (set.runs_here) all.push_back({Arithmetic::packets, set.name});
  }
  return all;
}

constexpr std::array every_direct{DirectLighting::light, DirectLighting::none, DirectLighting::mis};

RenderSettings small() {
  RenderSettings settings;
  settings.width = 17;  // no multiple of a tile
  settings.height = 3;
  return settings;
}

Film render(const Scene& scene, const CameraSettings& camera, RenderSettings settings, const Compiled& arithmetic) {
  settings.real = arithmetic.real;
  Film film(settings.width, settings.height);
  render_image({"", scene, Camera(camera)}, settings, 5, {0, 4}, 2, film, {}, arithmetic.instructions);
  return film;
}

// Every pixel is `expected`, to a part of `rounding`.
void expect_everywhere(const Film& film, const Rgb<double>& expected, double rounding, const std::string& where) {
  for (int y = 0; y < film.height(); ++y) {
    for (int x = 0; x < film.width(); ++x) {
      const double off = ((film.mean(x, y) - expected) / expected).abs().maxCoeff();
      ASSERT_LE(off, rounding) << where << " at " << x << ", " << y << ": " << film.mean(x, y).transpose();
    }
  }
}

void expect_refusal(const Scene& scene, const CameraSettings& camera, const RenderSettings& settings,
                    const Compiled& arithmetic, const std::string& says) {
  try {
    render(scene, camera, settings, arithmetic);
    FAIL() << "not refused: " << says;
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(says), std::string::npos) << error.what();
  }
}

// From wherever inside a black sphere that emits Le all that is seen is Le, to the bit.
TEST(ExtremeScenes, InsideABlackSphereAllIsItsEmission) {
  for (const Compiled& arithmetic : arithmetics()) {
    for (const double radius :
         arithmetic.real == Arithmetic::doubles ? std::vector{1e-50, 1.0, 1e50} : std::vector{1e-8, 1.0, 1e8}) {
      for (const double away : {0.0, 0.5, 0.999}) {
        Scene scene;
        scene.add_sphere({0, 0, 0}, radius, black, lit);
        for (const DirectLighting direct : every_direct) {
          RenderSettings settings = small();
          settings.direct = direct;
          const Film film = render(scene, {.eye = {away * radius, 0, 0}}, settings, arithmetic);
          expect_everywhere(film, lit, 0, formatted("%s %g %s", name_of(arithmetic.real), away, name_of(direct)));
        }
      }
    }
  }
}

// Inside one of albedo a the terms up to depth n are Le (1 + a + ... + a^n), by cosine-weighted bounces and by shadow rays that
// are drawn by area, each path alike. A shadow ray's distance is known to some ulp of the diameter.
TEST(ExtremeScenes, InsideADiffuseSphereEveryPathIsTheSumOfItsTerms) {
  Scene scene;
  scene.add_sphere({3, 4, 5}, 2, half, lit);
  for (const Compiled& arithmetic : arithmetics()) {
    for (const DirectLighting direct : {DirectLighting::light, DirectLighting::none}) {
      RenderSettings settings = small();
      settings.direct = direct;
      settings.roulette = RouletteKind::off;
      settings.max_depth = 3;
      const Film film = render(scene, {.eye = {3, 5.9, 5}}, settings, arithmetic);
      expect_everywhere(film, lit * 1.875, arithmetic.real == Arithmetic::doubles ? 1e-14 : 1e-6,
                        formatted("%s %s", name_of(arithmetic.real), name_of(direct)));
    }
  }
}

// In glass of index n the radiance of everything outside is n^2 that of what emits it; from nearer to the centre than 1/n of
// the radius every ray gets out.
TEST(ExtremeScenes, InsideGlassRadianceIsDenser) {
  Scene scene;
  scene.add_sphere({0, 0, 0}, 10, black, lit);
  scene.add_sphere({1, 0, 0}, 2, glass, black);
  for (const Compiled& arithmetic : arithmetics()) {
    for (const DirectLighting direct : every_direct) {
      RenderSettings settings = small();
      settings.direct = direct;
      settings.max_depth = 1000;
      const Film film = render(scene, {.eye = {1, 1, 0}}, settings, arithmetic);
      expect_everywhere(film, lit * 2.25, 1e-6, formatted("%s %s", name_of(arithmetic.real), name_of(direct)));
    }
  }
}

TEST(ExtremeScenes, AreRefusedWhereAPathFromTheCameraNeedNotEnd) {
  const std::string says = "--max-depth";
  for (const Compiled& arithmetic : arithmetics()) {
    Scene in_glass;
    in_glass.add_sphere({0, 0, 0}, 10, black, lit);
    in_glass.add_sphere({1, 0, 0}, 2, glass, black);
    expect_refusal(in_glass, {.eye = {1, 1.9, 0}}, small(), arithmetic, says);
    Scene in_white;
    in_white.add_sphere({0, 0, 0}, 1, white, lit);
    expect_refusal(in_white, {}, small(), arithmetic, says);
    RenderSettings settings = small();
    settings.max_depth = 50;
    EXPECT_NO_THROW(render(in_glass, {.eye = {1, 1.9, 0}}, settings, arithmetic));
    EXPECT_NO_THROW(render(in_white, {}, settings, arithmetic));
  }
}

// Rays start on a plane before the eye, or all over the lens.
TEST(ExtremeScenes, AreRefusedWhereSomeRaysStartInGlass) {
  const auto glass_at = [](const Vec3<double>& centre, double radius) {
    Scene scene;
    scene.add_sphere({0, 0, 0}, 10, black, lit);
    scene.add_sphere(centre, radius, glass, black);
    return scene;
  };
  for (const Compiled& arithmetic : arithmetics()) {
    const std::string says = "--max-depth";
    expect_refusal(glass_at({0, 0, -5}, 1), {.start = 5}, small(), arithmetic, says);
    expect_refusal(glass_at({2.5, 0, 0}, 1), {.aperture_radius = 2}, small(), arithmetic, says);
    EXPECT_NO_THROW(render(glass_at({0, 0, -5}, 1), {.start = 3}, small(), arithmetic)) << "before it";
    EXPECT_NO_THROW(render(glass_at({4, 0, -5}, 1), {.image_height = 0.1, .start = 5}, small(), arithmetic))
        << "beside what is seen";
    EXPECT_NO_THROW(render(glass_at({2.5, 0, 0}, 1), {.aperture_radius = 1}, small(), arithmetic))
        << "beside the lens";
  }
}

TEST(ExtremeScenes, ThroughCamerasThatTheArithmeticDoesNotHoldAreRefused) {
  Scene scene;
  scene.add_sphere({0, 0, 0}, 1, half, lit);
  const auto expect_refused_by = [&](const CameraSettings& camera, bool in_double) {
    for (const Compiled& arithmetic : arithmetics()) {
      if (arithmetic.real == Arithmetic::doubles && !in_double)
        EXPECT_NO_THROW(render(scene, camera, small(), arithmetic));
      else
        expect_refusal(scene, camera, small(), arithmetic,
                       arithmetic.real == Arithmetic::doubles ? "1e-150" : "--real double");
    }
  };
  expect_refused_by({.image_height = 1e-40}, false);
  expect_refused_by({.image_height = 1e20}, false);
  expect_refused_by({.aperture_radius = 0.1, .focus_distance = 1e-20}, false);
  expect_refused_by({.aperture_radius = 1e-30, .focus_distance = 1e-30}, false);
  expect_refused_by({.aperture_radius = 1e-46}, false);
  expect_refused_by({.start = 1e20}, false);
  expect_refused_by({.image_height = 1e10, .start = 1e10}, false);
  expect_refused_by({.image_height = 1e-300}, true);
  expect_refused_by({.aperture_radius = 0.1, .focus_distance = 1e-200}, true);
}

// A floor, and over it a light of the given size, as far from the origin as it is said.
Scene floor_under(double radius, double distance, const Rgb<double>& radiance = lit) {
  Scene scene;
  scene.add_wall({0, 0, 0}, {0, 1, 0}, 1e5, half, black);
  scene.add_sphere({0, distance, 0}, radius, black, radiance);
  return scene;
}
const CameraSettings above_the_floor{.eye = {0, 1, 5}, .look = {0, -1, -5}};

// A float at 100 is known to 4e-6.
TEST(ExtremeScenes, OfLightsThatFloatsCannotPlaceAreRefusedInPackets) {
  const auto expect_packets_refused = [](const Scene& scene, const std::string& says) {
    for (const Compiled& arithmetic : arithmetics()) {
      if (arithmetic.real == Arithmetic::doubles) {
        EXPECT_NO_THROW(render(scene, above_the_floor, small(), arithmetic));
      } else {
        expect_refusal(scene, above_the_floor, small(), arithmetic, says);
      }
    }
  };
  expect_packets_refused(floor_under(1e-7, 100), "a surface of 1e-07 m at 100 m");
  expect_packets_refused(floor_under(1e-3, 1e4), "a surface of 0.001 m at 1e+04 m");
  expect_packets_refused(floor_under(1e-10, 0), "a surface of 1e-10 m");
  expect_packets_refused(floor_under(1, 1e10), "1e+10 m from the origin");
  expect_packets_refused(floor_under(1, 100, Rgb<double>(0, 1e-19, 0)), "a radiance of 1e-19");
  Scene strip;
  strip.add_rectangle({-1, 100, 0}, {2, 0, 0}, {0, 0, 1e-5}, black, lit);
  expect_packets_refused(strip, "a surface of 1e-05 m");
}

// What is darker than the steps in which the film counts is black, and no number is missing.
TEST(ExtremeScenes, OfDenormalRadiancesAreBlack) {
  for (const double radiance : {1e-300, 1e-310, std::numeric_limits<double>::denorm_min()}) {
    for (const auto& row : StrategyTable<WhichLight>::rows) {
      RenderSettings settings = small();
      settings.which_light = row.value;
      const Film film =
          render(floor_under(1, 5, radiance * white), above_the_floor, settings, {Arithmetic::doubles, ""});
      EXPECT_TRUE((film.mean(0, 0) == 0).all()) << radiance;
    }
  }
}

// By the cone, with sin(a) = r/d, a floor under a light reflects 2 albedo Le (1 - cos(a)) towards where its middle is.
template <class Real>
double reflected_by_cone(double radius, double distance) {
  struct Middle {
    Real next() { return Real(0); }
  } source;
  const TracedScene<Real> scene(floor_under(radius, distance));
  const Vec3<Real> up(Real(0), Real(1), Real(0));
  const SurfaceBsdf<Real> bsdf(scene.materials(), Index<Real>(0), up, up);
  const Vertex<Real> vertex{zero<Vec3<Real>>(), up, Real(0)};
  const DirectLight<AllLights, PointsBy<SphereByCone>> direct;
  std::array<double, lanes<Real>> found{};
  store_lanes(direct.template estimate<Real>(scene, vertex, bsdf, source)[0], found.data());
  return found[0];
}

TEST(ExtremeScenes, HaveSmallLightsOfTheRightPower) {
  for (const auto& [radius, distance] : {std::pair(1e-7, 100.0), {1e-3, 1e4}, {1e-3, 100.0}, {1e-8, 1e8}}) {
    const double sine_squared = std::pow(radius / distance, 2);
    const double expected = 2 * 0.5 * sine_squared / (1 + std::sqrt(1 - sine_squared));
    EXPECT_NEAR(reflected_by_cone<double>(radius, distance), expected, 1e-14 * expected) << radius;
    EXPECT_NEAR(reflected_by_cone<Packet>(radius, distance), expected, 1e-6 * expected) << radius;
  }
}

// A light of 1 mm at 100 m is met a little beside where its samples are. Its bounces count next to nothing everywhere, on its rim
// too, as there are 1e10 times as many samples of its own.
TEST(ExtremeScenes, CountASmallLightOnceByBothStrategies) {
  Scene small_light = floor_under(1, -5, black);
  small_light.add_sphere({60, 80, 0}, 1e-3, black, lit);
  const TracedScene<Packet> scene(small_light);
  const auto largest_weight = [&](const auto& direct) {
    int hits = 0;
    double largest = 0;
    for (int i = -50; i <= 50; ++i) {
      for (int j = 0; j < 20; ++j) {
        const double aside = 1e-5 * (1 + i * 1e-3), turn = 2 * M_PI * j / 20;
        const Vec3<double> local(aside * std::cos(turn), aside * std::sin(turn), 1);
        const Vec3<float> way = Frame<double>({0.6, 0.8, 0}).to_world(local).cast<float>().normalized();
        const Ray<Packet> ray{zero<Vec3<Packet>>(), way.cast<Packet>(), Packet(0)};
        const Hit<Packet> hit = scene.intersect(ray, Mask<Packet>(true));
        if (!all(hit.surface == Packet(2))) continue;
        ++hits;
        const Packet weight =
            direct.template emission_weight<Packet>(scene, ray, hit.surface, Packet(1 / pi<float>));
        std::array<double, lanes<Packet>> weights{};
        store_lanes(weight, weights.data());
        largest = std::max(largest, std::ranges::max(weights));
      }
    }
    EXPECT_GT(hits, 200);
    return largest;
  };
  EXPECT_LT(largest_weight(DirectLight<AllLights, PointsBy<SphereByCone>, MisWeighted<>>()), 1e-9);
  EXPECT_LT(largest_weight(DirectLight<AllLights, PointsBy<SphereByVisibleHemisphere>, MisWeighted<>>()), 1e-9);
  EXPECT_LT(largest_weight(DirectLight<AllLights, PointsBy<SphereByArea>, MisWeighted<>>()), 1e-9);
}

}  // namespace
}  // namespace fairlight
