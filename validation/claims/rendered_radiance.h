#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <fairlight/render/instruction_sets.h>
#include <fairlight/render/render_image.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/checks/draws.h>
#include <fairlight/validation/claims/closed_scenes.h>

namespace fairlight {

/// The instruction set of the packets in this file, which the build compiles once for each set.
inline const std::string& instructions_of_packets() {
  return std::ranges::find(instruction_sets(), lanes<Packet>, &InstructionSet::lanes)->name;
}

/// The renderer as it is shipped, by the packets of this file. A wrong one takes its place in faults.
struct ShippedRenderer {
  static void render(const View& view, const RenderSettings& settings, std::uint64_t seed, SampleRange range,
                     Film& film) {
    render_image(view, settings, seed, range, 1, film, {}, instructions_of_packets());
  }
};

/// The pixels of small pictures of a constant radiance, as the draws of its estimator. Each pixel
/// has `sets` sets of samples; a set is one sample if samples are independent. Where the renderer
/// rejects a picture, because of an invalid sample, the draw is NaN.
template <class Renderer = ShippedRenderer>
class RenderedPixels {
 public:
  RenderedPixels(const View& view, const RenderSettings& settings, const StreamKey& key, std::uint32_t sets = 1)
      : view_(view),
        settings_(settings),
        seed_(std::uint64_t{key.words()[1]} << 32 | key.words()[0]),
        samples_(sets * settings.points) {}

  Rgb<double> at(std::uint64_t draw) { return of(draw, &ExactMoments::mean); }
  Rgb<double> standard_error_at(std::uint64_t draw) { return of(draw, &ExactMoments::standard_error); }

 private:
  static constexpr int side = 32;
  static constexpr std::uint64_t pixels = side * side;

  Rgb<double> of(std::uint64_t draw, double (ExactMoments::*value)() const) {
    if (draw / pixels != picture_) render(draw / pixels);
    const auto pixel = static_cast<int>(draw % pixels);
    if (refused_) return Rgb<double>::Constant(std::numeric_limits<double>::quiet_NaN());
    const Film::Pixel& channels = film_.at(pixel % side, pixel / side);
    return {(channels[0].*value)(), (channels[1].*value)(), (channels[2].*value)()};
  }

  void render(std::uint64_t picture) {
    picture_ = picture;
    refused_ = false;
    film_ = Film(side, side);
    const std::uint64_t first = picture * samples_;
    try {
      Renderer::render(view_, settings_, seed_, {first, first + samples_}, film_);
    } catch (const std::domain_error&) {
      refused_ = true;
    }
  }

  View view_;
  RenderSettings settings_;
  std::uint64_t seed_;
  std::uint64_t samples_;
  std::uint64_t picture_ = std::numeric_limits<std::uint64_t>::max();
  bool refused_ = false;
  Film film_{side, side};
};

/// The references of the pixels, for paths of these strategies.
/// Bound    at every vertex what shadow rays bring and what a bounce finds, if there are such,
///          times the throughput. A bounce multiplies by at most w rho, w = 2 for uniform bounces
///          and else 1. Roulette by albedo divides by the largest rho, which leaves w. After
///          roulette by throughput a path carries at most w, or w rho times what it had; and
///          outside glass n^2 times as much.
inline std::vector<Reference> references_of(const ClosedScene& scene, const RenderSettings& settings) {
  const double bounce = settings.bounce == BounceSampling::uniform ? 2 : 1;
  const double weight =
      settings.roulette == RouletteKind::albedo ? bounce : std::max(1.0, bounce * scene.whitest());
  const double shadow_rays = settings.direct == DirectLighting::none ? 0 : 1,
               bounces = settings.direct == DirectLighting::light ? 0 : weight;
  double vertices = 0;
  for (int k = 0; k < settings.max_depth; ++k) vertices += std::pow(weight, k);
  const Rgb<double> mean = scene.radiance(settings.max_depth);
  const Rgb<double> brightest = scene.brightest();
  const double survivor = settings.roulette == RouletteKind::throughput
                              ? bounce * scene.index * scene.index * (1 + 1e-12)
                              : 1;  // plus rounding
  const Rgb<double> upper =
      survivor * (brightest + vertices * (shadow_rays * scene.largest_term + bounces * brightest));
  return for_channels([&](int c) { return Reference{mean[c], 0, upper[c]}; });
}

/// Tests the renderer by its settings: the pixels of a closed scene have its radiance as their
/// mean, with any number of sets. The margin is wide, as strategies that do not fit together are
/// off by large factors. The claims about components have narrow margins, for small errors.
template <class Renderer = ShippedRenderer>
Claim rendered_radiance(const ClosedScene& scene, const RenderSettings& settings, double margin_factor = 30,
                        std::uint32_t sets = 1) {
  const bool shadow_rays = settings.direct != DirectLighting::none;
  const std::string search =
      shadow_rays ? formatted("%s.%s", name_of(settings.light_sampling), name_of(settings.which_light))
                  : formatted("%s.%s", name_of(settings.roulette), name_of(settings.filter));
  const std::string others =
      formatted("roulette %s, %s numbers, a %s filter and a %s", name_of(settings.roulette),
                name_of(settings.random), name_of(settings.filter), settings.aperture > 0 ? "lens" : "pinhole");
  const bool in_packets = settings.real == Arithmetic::packets;
  const std::string name =
      formatted("%s.%s.%s.%s%s%s", scene.view.name.c_str(), name_of(settings.bounce), name_of(settings.direct),
                search.c_str(), sets > 1 ? formatted(".%u", sets).c_str() : "", in_packets ? ".packet" : "");
  return {.name = name,
          .kind = "mean",
          .subjects = {"PathTracer", shadow_rays ? "DirectLight" : "NoDirectLight"},
          .statement = formatted("by %s, the pixels of a picture show the closed form, of depth %d, per channel",
                                 others.c_str(), settings.max_depth),
          .source = "balance of what surfaces emit and reflect, depth by depth; Goral et al. 1984",
          .margin_factor = margin_factor,
          .check =
              [=](const Trial& trial) {
                const auto references = references_of(scene, settings);
                RenderedPixels<Renderer> draws(with_camera_of(settings, scene.view), settings,
                                               StreamKey(trial.seed, trial.claim), sets);
                return test_means(
                    trial,
                    in_packets ? rounded_references<Packet>(references) : rounded_references<double>(references),
                    [&](std::uint64_t first, std::vector<std::vector<double>>& channels) {
                      for (std::size_t i = 0; i < channels[0].size(); ++i) {
                        const Rgb<double> pixel = draws.at(first + i);
                        for (std::size_t c = 0; c < 3; ++c) channels[c][i] = pixel[static_cast<Eigen::Index>(c)];
                      }
                    });
              },
          .real = name_of(settings.real)};
}

}  // namespace fairlight
