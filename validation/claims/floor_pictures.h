#pragma once

#include <string>

#include <fairlight/validation/claims/lit_floor.h>
#include <fairlight/validation/claims/replicate_pictures.h>

namespace fairlight {

/// A row about a picture of a lit floor.
struct FloorPicture {
  std::string name;
  LitFloor floor;
  PicturePlan plan;
  RenderSettings settings;  ///< `aperture` is the lens [m], 0 for a pinhole
  double margin_factor = 5;
};

/// Shadow rays, by solid angle or area where the lamps have one.
inline RenderSettings floor_settings(Arithmetic real, PixelFilter filter, LightPoints points,
                                     DirectLighting direct = DirectLighting::light) {
  RenderSettings settings;
  settings.real = real;
  settings.filter = filter;
  settings.light_sampling = points;
  settings.direct = direct;
  settings.which_light = WhichLight::all;
  settings.aperture = 0;
  return settings;
}

/// The largest quotient of a sample of a pixel and the pixel's mean. One of two lamps counts twice.
/// A bounce that shares the light with shadow rays brings no more than they do, as the densities
/// add up, but for the roulette, which divides by the largest albedo.
inline double largest_quotient(const FloorPicture& picture) {
  const auto& [name, floor, plan, settings, factor] = picture;
  const FilterRule filter(settings.filter);
  const bool shared = settings.direct == DirectLighting::mis, one = settings.which_light == WhichLight::one;
  const double times = (one && floor.sphere && floor.rectangle ? 2 : 1) *
                       (1 + (shared ? 1 / LitFloor::albedo().maxCoeff() : 0)) / floor.of_mirror().maxCoeff() *
                       (1 + 1e-4);
  double most = 0;
  for (int y = 0; y < plan.height; ++y) {
    for (int x = 0; x < plan.width; ++x) {
      const Rgb<double> terms = floor.largest_terms(floor.point(x + 0.5, y + 0.5, plan.width, plan.height),
                                                    filter.reach() * floor.pixel_size(plan.height),
                                                    settings.light_sampling == LightPoints::cone);
      most = std::max(
          most,
          (times * floor.of_mirror() * terms / floor.pixel(x, y, plan.width, plan.height, filter)).maxCoeff());
    }
  }
  return most;
}

/// Tests each quarter of the picture, pixel by pixel and per channel.
template <class Renderer = ShippedRenderer>
Claim floor_picture(const FloorPicture& picture) {
  const std::string suffix = picture.settings.real == Arithmetic::packets ? ".packet" : "";
  return {.name = "lit_floor." + picture.name + suffix,
          .kind = "mean",
          .subjects = {"PathTracer", "DirectLight", "Film"},
          .statement = formatted("each pixel of %d x %d shows rho sum Le E / pi of a lit floor, averaged over a %s "
                                 "filter, from %u %s samples, per quarter and channel",
                                 picture.plan.width, picture.plan.height, name_of(picture.settings.filter),
                                 picture.plan.samples, name_of(picture.settings.random)),
          .source = "Lambert 1760; Snyder 1996",
          .margin_factor = picture.margin_factor,
          .check =
              [picture](const Trial& trial) {
                const auto& [name, floor, plan, settings, factor] = picture;
                const FilterRule filter(settings.filter);
                return test_pixels<Renderer>(
                    trial, floor.view(settings.aperture), settings, plan,
                    [&](int x, int y) { return floor.pixel(x, y, plan.width, plan.height, filter); },
                    largest_quotient(picture));
              },
          .real = name_of(picture.settings.real),
          .finest_margin = finest_margin(quotients(picture.settings.real, 2))};
}

/// Landscape, portrait and square pictures whose sides are no multiples of a tile's, with every
/// filter and every kind of random numbers, with and without a lens, from 1 to 1000 samples.
inline std::vector<FloorPicture> floor_pictures() {
  using enum PixelFilter;
  using enum LightPoints;
  using enum Arithmetic;
  constexpr LitFloor by_sphere{true, false}, by_rectangle{false, true}, by_both{true, true};
  const auto sets = [](RandomNumbers random, std::uint32_t points, RenderSettings settings) {
    settings.random = random;
    settings.points = points;
    return settings;
  };
  const auto with_lens = [](RenderSettings settings) {
    settings.aperture = 0.1;
    return settings;
  };
  const auto to_depth_2 = [](RenderSettings settings) {
    settings.max_depth = 2;
    return settings;
  };
  const auto roulette = [](RouletteKind kind, RenderSettings settings) {
    settings.roulette = kind;
    settings.roulette_depth = 1;
    settings.which_light = WhichLight::one;
    return settings;
  };
  return {
      {"landscape", by_rectangle, {37, 22}, floor_settings(doubles, box, solid_angle), 2},
      {"landscape", by_rectangle, {37, 22}, floor_settings(packets, box, solid_angle), 1},
      {"portrait",
       by_sphere,
       {19, 35, 64},
       with_lens(sets(RandomNumbers::sobol, 16, floor_settings(packets, tent, cone)))},
      {"shared",
       by_rectangle,
       {35, 18, 64, Rendering::resumed},
       with_lens(sets(RandomNumbers::stratified, 16,
                      roulette(RouletteKind::throughput,
                               floor_settings(packets, blackman_harris, solid_angle, DirectLighting::mis)))),
       8},
      {"square",
       by_both,
       {21, 21, 63, Rendering::ranges},
       roulette(RouletteKind::albedo, floor_settings(packets, gaussian, area, DirectLighting::mis)),
       30},
      {"one_light", by_both, {17, 33}, roulette(RouletteKind::albedo, floor_settings(packets, tent, area)), 20},
      {"odd", by_rectangle, {33, 17, 65, Rendering::seeds}, with_lens(floor_settings(doubles, gaussian, area)), 20},
      {"mirrored", {true, true, true}, {25, 18}, to_depth_2(floor_settings(packets, tent, area)), 25},
      {"many", by_sphere, {18, 17, 1000, Rendering::seeds}, floor_settings(packets, tent, cone), 20},
  };
}

}  // namespace fairlight
