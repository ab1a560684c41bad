#pragma once

#include <cmath>
#include <string>
#include <vector>

#include <fairlight/stats/second_order.h>
#include <fairlight/validation/claims/rendered_radiance.h>

namespace fairlight {

/// How the pixels of rendered pictures vary. A sample that comes twice, or depends on another, keeps
/// the mean of a pixel; it does not keep these.

/// The settings of pictures of the grey ball, whose samples are 0 or 1 with probability 1/2.
inline RenderSettings grey_ball_settings(Arithmetic real) {
  RenderSettings settings;
  settings.real = real;
  settings.direct = DirectLighting::none;
  settings.roulette = RouletteKind::albedo;
  settings.max_depth = 1;
  return settings;
}

/// A row about pixels of n samples of the grey ball, with `check(trial, pixels)`.
template <class Renderer, class Check>
Claim grey_ball_row(const std::string& name, const std::string& statement, Arithmetic real, std::uint32_t n,
                    const Check& check) {
  return {.name = formatted("grey_ball.%s.%u%s", name.c_str(), n, real == Arithmetic::packets ? ".packet" : ""),
          .kind = "second order",
          .subjects = {"PathTracer", "RussianRoulette"},
          .statement = formatted("%s, for pixels of %u samples of 0 or 1", statement.c_str(), n),
          .source = "the variance of n independent tosses of a coin is 1 / (4 n)",
          .margin_factor = 90,
          .check =
              [=](const Trial& trial) {
                RenderedPixels<Renderer> pixels(grey_ball().view, grey_ball_settings(real),
                                                StreamKey(trial.seed, trial.claim), n);
                return check(trial, pixels);
              },
          .real = name_of(real)};
}

/// The variance of a pixel's mean is 1 / (4 n). Rounding can take a sample a little above 1.
template <class Renderer = ShippedRenderer>
Claim variance_of_pixels(Arithmetic real, std::uint32_t n) {
  return grey_ball_row<Renderer>(
      "variance", "the variance of a pixel is 1 / (4 n)", real, n, [n](const Trial& trial, auto& pixels) {
        const BoundedEstimator pixel{[&](std::uint64_t i) { return pixels.at(i)[0]; }, 0, 1 + 1e-6};
        return test_variance(trial, 0.25 / n, pixel);
      });
}

/// The mean of the squared standard error of a pixel is 1 / (4 n).
/// Bound    m ones of n samples have the squared standard error m (n - m) / (n^2 (n - 1))
template <class Renderer = ShippedRenderer>
Claim error_of_pixels(Arithmetic real, std::uint32_t n) {
  return grey_ball_row<Renderer>("error", "the mean of the squared standard error of a pixel is 1 / (4 n)", real, n,
                                 [n](const Trial& trial, auto& pixels) {
                                   const double mean = 0.25 / n;
                                   const Reference reference{mean, 0, mean * n / (n - 1) * (1 + 1e-5)};
                                   return test_means(trial, {reference}, one_channel([&](std::uint64_t i) {
                                                       return std::pow(pixels.standard_error_at(i)[0], 2);
                                                     }));
                                 });
}

/// Pictures under a sky of this brightness: a white ball is invisible, whatever it is.
template <class Renderer = ShippedRenderer>
Claim picture_of_brightness(Arithmetic real, const std::string& name, double brightness) {
  RenderSettings settings = grey_ball_settings(real);
  settings.direct = DirectLighting::light;
  settings.light_sampling = LightPoints::cone;
  return rendered_radiance<Renderer>(white_ball(name, brightness), settings, 5);
}

/// Adds all rows of this file. Pixels of 65 and 128 samples show samples that repeat after 64.
inline void add_picture_claims(std::vector<Claim>& claims) {
  for (const Arithmetic real : {Arithmetic::doubles, Arithmetic::packets}) {
    for (const std::uint32_t n : {1u, 65u}) claims.push_back(variance_of_pixels(real, n));
    for (const std::uint32_t n : {2u, 65u}) claims.push_back(error_of_pixels(real, n));
    claims.push_back(picture_of_brightness(real, "white_ball_bright", 3e4));
    claims.push_back(picture_of_brightness(real, "white_ball_dim", 1e-4));
  }
  claims.push_back(variance_of_pixels(Arithmetic::packets, 128));
}

}  // namespace fairlight
