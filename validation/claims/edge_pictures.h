#pragma once

#include <string>

#include <fairlight/validation/claims/blurred_edges.h>
#include <fairlight/validation/claims/replicate_pictures.h>

namespace fairlight {

/// A row about a picture of blurred edges.
struct EdgePicture {
  std::string name;
  BlurredEdges edges;
  PicturePlan plan;
  PixelFilter filter;
  double margin_factor;
  Arithmetic real = Arithmetic::packets;
};

/// Tests each quarter of the picture, pixel by pixel and per channel.
template <class Renderer = ShippedRenderer>
Claim edge_picture(const EdgePicture& picture) {
  RenderSettings settings;
  settings.real = picture.real;
  settings.direct = DirectLighting::none;
  settings.filter = picture.filter;
  settings.max_depth = 0;
  return {.name = "blurred_edges." + picture.name + (picture.real == Arithmetic::packets ? ".packet" : ""),
          .kind = "mean",
          .subjects = {"Camera", "ThinLens", picture.edges.blades > 0 ? "PolygonalAperture" : "CircularAperture",
                       "Film"},
          .statement =
              formatted("each pixel of %d x %d shows lit rectangles with the share that a %s filter and an "
                        "aperture of %d blades leave of each, per quarter and channel",
                        picture.plan.width, picture.plan.height, name_of(picture.filter), picture.edges.blades),
          .source = "similar triangles; Cook, Porter, Carpenter 1984",
          .margin_factor = picture.margin_factor,
          .check =
              [=](const Trial& trial) {
                const auto& [name, edges, plan, pixel_filter, factor, real] = picture;
                const FilterRule filter(pixel_filter);
                std::vector<double> left, upper;
                for (int x = 0; x < plan.width; ++x)
                  left.push_back(edges.left_share(x, plan.width, plan.height, filter));
                for (int y = 0; y < plan.height; ++y) upper.push_back(edges.upper_share(y, plan.height, filter));
                const auto mean = [&](int x, int y) {
                  return Rgb<double>(BlurredEdges::everywhere() +
                                     left[static_cast<std::size_t>(x)] * BlurredEdges::on_the_left() +
                                     upper[static_cast<std::size_t>(y)] * BlurredEdges::above());
                };
                const Rgb<double> whole =
                    BlurredEdges::everywhere() + BlurredEdges::on_the_left() + BlurredEdges::above();
                const double largest = (whole / BlurredEdges::everywhere()).maxCoeff() * (1 + 1e-9);
                return test_pixels<Renderer>(trial, edges.view(), settings, plan, mean, largest);
              },
          .real = name_of(picture.real),
          .finest_margin = finest_margin(quotients(picture.real, 2))};
}

/// Apertures of three and of six blades, round ones and pinholes, focused before and behind the
/// edges, with every filter. Small pictures through a pinhole show the filter.
inline std::vector<EdgePicture> edge_pictures() {
  using enum PixelFilter;
  constexpr BlurredEdges triangle{1.5, 0.25, 3, 0.4}, hexagon{6, 0.5, 6, -0.7}, circle{1, 0.125, 0, 0},
      pinhole{1, 0, 0, 0};
  return {{"triangle", triangle, {37, 22}, gaussian, 4},
          {"triangle", triangle, {37, 22}, gaussian, 5, Arithmetic::doubles},
          {"hexagon", hexagon, {19, 35}, tent, 5},
          {"circle", circle, {21, 21}, blackman_harris, 5},
          {"pinhole.box", pinhole, {5, 3}, box, 10},
          {"pinhole.tent", pinhole, {3, 5}, tent, 10},
          {"pinhole.gaussian", pinhole, {5, 3}, gaussian, 10},
          {"pinhole.blackman-harris", pinhole, {3, 3}, blackman_harris, 10}};
}

}  // namespace fairlight
