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

/// Those of this file's packets, for whose claims it is compiled more than once.
inline const std::string& instructions_of_packets() {
  return std::ranges::find(instruction_sets(), lanes<Packet>, &InstructionSet::lanes)->name;
}

/// The pixels of small pictures of one radiance, one picture after the other, as the draws of its estimator: each of so many sets of samples,
/// a set being one sample where they are independent. A picture that the renderer refuses, for a sample that is no radiance, is not a number.
class RenderedPixels {
 public:
  RenderedPixels(const View& view, const RenderSettings& settings, const StreamKey& key, std::uint32_t sets = 1)
      : view_(view),
        settings_(settings),
        seed_(std::uint64_t{key.words()[1]} << 32 | key.words()[0]),
        samples_(sets * settings.points) {}

  Rgb<double> at(std::uint64_t draw) {
    if (draw / pixels != picture_) render(draw / pixels);
    const auto pixel = static_cast<int>(draw % pixels);
    if (refused_) return Rgb<double>::Constant(std::numeric_limits<double>::quiet_NaN());
    return film_.mean(pixel % side, pixel / side);
  }

 private:
  static constexpr int side = 32;
  static constexpr std::uint64_t pixels = side * side;

  void render(std::uint64_t picture) {
    picture_ = picture;
    refused_ = false;
    film_ = Film(side, side);
    const std::uint64_t first = picture * samples_;
    try {
      render_image(view_, settings_, seed_, {first, first + samples_}, 1, film_, {}, instructions_of_packets());
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

/// What a path of these strategies may bring: at every vertex what its shadow rays bring and what a bounce finds, as there are, each weighted
/// at most by the throughput. That a bounce multiplies by at most w rho, w = 2 by uniform bounces and 1 by others. Roulette by
/// albedo divides by the largest rho, so that w is left; after that by throughput a path carries w at most, or w rho times what it did,
/// and in glass what is n^2 times as much outside.
inline std::vector<Reference> references_of(const ClosedScene& scene, const RenderSettings& settings) {
  const double bounce = settings.bounce == "uniform" ? 2 : 1;
  const double weight = settings.roulette == "albedo" ? bounce : std::max(1.0, bounce * scene.whitest());
  const double shadow_rays = settings.direct == "none" ? 0 : 1, bounces = settings.direct == "light" ? 0 : weight;
  double vertices = 0;
  for (int k = 0; k < settings.max_depth; ++k) vertices += std::pow(weight, k);
  const Rgb<double> mean = scene.radiance(settings.max_depth);
  const Rgb<double> brightest = scene.brightest();
  const double survivor =
      settings.roulette == "throughput" ? bounce * scene.index * scene.index * (1 + 1e-12) : 1;  // but for rounding
  const Rgb<double> upper =
      survivor * (brightest + vertices * (shadow_rays * scene.largest_term + bounces * brightest));
  std::vector<Reference> references;
  for (int c = 0; c < 3; ++c) references.push_back({mean[c], 0, upper[c]});
  return references;
}

/// The renderer itself, by its settings: the pixels of a picture of a closed scene have its radiance as their mean. Strategies that do not fit
/// together are off by factors, so the margin is wide; what is small is the components', whose margins are narrow. A pixel of any number of
/// sets has the same mean.
inline Claim rendered_radiance(const ClosedScene& scene, const RenderSettings& settings, double margin_factor = 30,
                               std::uint32_t sets = 1) {
  const bool shadow_rays = settings.direct != "none";
  const std::string search = shadow_rays
                                 ? formatted("%s.%s", settings.light_sampling.c_str(), settings.which_light.c_str())
                                 : formatted("%s.%s", settings.roulette.c_str(), settings.filter.c_str());
  const std::string others =
      formatted("roulette %s, %s numbers, a %s filter and a %s", settings.roulette.c_str(), settings.random.c_str(),
                settings.filter.c_str(), settings.aperture > 0 ? "lens" : "pinhole");
  return {.name = formatted("%s.%s.%s.%s%s%s", scene.view.name.c_str(), settings.bounce.c_str(),
                            settings.direct.c_str(), search.c_str(), sets > 1 ? formatted(".%u", sets).c_str() : "",
                            settings.real == "packet" ? ".packet" : ""),
          .kind = "mean",
          .subjects = {"PathTracer", shadow_rays ? "DirectLight" : "NoDirectLight"},
          .statement = formatted("by %s, the pixels of a picture show the closed form, of depth %d, per channel",
                                 others.c_str(), settings.max_depth),
          .source = "balance of what surfaces emit and reflect, depth by depth; Goral et al. 1984",
          .margin_factor = margin_factor,
          .check =
              [=](const Trial& trial) {
                const auto references = references_of(scene, settings);
                RenderedPixels draws(with_camera_of(settings, scene.view), settings,
                                     StreamKey(trial.seed, trial.claim), sets);
                return test_means(trial,
                                  settings.real == "packet" ? rounded_references<Packet>(references)
                                                            : rounded_references<double>(references),
                                  [&](std::uint64_t first, std::vector<std::vector<double>>& channels) {
                                    for (std::size_t i = 0; i < channels[0].size(); ++i) {
                                      const Rgb<double> pixel = draws.at(first + i);
                                      for (std::size_t c = 0; c < 3; ++c)
                                        channels[c][i] = pixel[static_cast<Eigen::Index>(c)];
                                    }
                                  });
              },
          .real = settings.real};
}

}  // namespace fairlight
