#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <fairlight/estimators/allocation_stages.h>
#include <fairlight/stats/second_order.h>
#include <fairlight/validation/checks/claim.h>
#include <fairlight/validation/claims/image_numbers.h>
#include <fairlight/validation/claims/pooled_stages.h>

namespace fairlight {

/// Images whose pixels are mostly dark. A draw of a pixel is `ground` of its mean, and with
/// probability p a spike adds (1 - ground) / p of it, so the mean is `mean` for any p. The first
/// samples then say little about the rest, which is where adaptive sampling goes wrong. Exponential
/// draws, whose first samples resemble the rest, show at most a third of the bias.
struct SpikyPixels {
  struct Pixel {
    double mean, p;
  };
  PixelGrid grid;
  std::vector<Pixel> pixels;
  double ground = 0;

  template <class Source>
  auto operator()(std::size_t pixel, Source& source) const {
    using Real = decltype(source.next());
    const auto [mean, p] = pixels[pixel];
    const double dark = mean * ground;
    return Real(select(source.next() < rounded<Real>(p), rounded<Real>(dark + mean * (1 - ground) / p),
                       rounded<Real>(dark)));
  }

  /// The reference of the channel of one pixel, whose mean may be negative.
  Reference reference(std::size_t pixel) const {
    const auto [mean, p] = pixels[pixel];
    const double dark = mean * ground * (1 - 1e-12), bright = mean * (ground + (1 - ground) / p) * (1 + 1e-12);
    return {
        .mean = mean, .lower = std::min(dark, bright), .upper = std::max(dark, bright), .scale = std::abs(mean)};
  }
};

/// Eight pixels with different means and spikes. The ground makes the test need fewer images; the
/// ratio of bias to noise is the same without it.
inline SpikyPixels unequal_spikes() {
  return {
      PixelGrid(4, 2), {{1, 0.1}, {2, 0.1}, {1, 0.2}, {0.5, 0.1}, {1, 0.1}, {3, 0.1}, {1, 0.15}, {2, 0.2}}, 0.975};
}

/// The same with means of both signs, as of a difference of pictures.
inline SpikyPixels signed_spikes() {
  SpikyPixels spiky = unequal_spikes();
  for (const std::size_t pixel : {1u, 2u, 6u}) spiky.pixels[pixel].mean *= -1;
  return spiky;
}

/// Four equal pixels, all neighbours of each other. PooledSpikes has their means under the naive
/// form.
inline constexpr double equal_spikes_p = 0.1;
inline SpikyPixels equal_spikes() {
  return {PixelGrid(2, 2), std::vector<SpikyPixels::Pixel>(4, {1, equal_spikes_p})};
}

inline double mean_of_image(const std::vector<double>& image) {
  return std::accumulate(image.begin(), image.end(), 0.0) / static_cast<double>(image.size());
}

/// Tests the mean of every pixel, and of the image: one channel each.
template <class Form, class Numbers>
Finding check_pixels(const Trial& trial, const SpikyPixels& spiky, const Form& form, const Numbers& numbers) {
  std::vector<Reference> references;
  Reference whole{0, 0, 0};
  const double part = 1 / static_cast<double>(spiky.grid.size());
  for (std::size_t pixel = 0; pixel < spiky.pixels.size(); ++pixel) {
    references.push_back(spiky.reference(pixel));
    whole.mean += references.back().mean * part;
    whole.lower += references.back().lower * part;
    whole.upper += references.back().upper * part;
    whole.scale += references.back().scale * part;
  }
  references.push_back(whole);
  const StreamKey key(trial.seed, trial.claim);
  const auto held = rounded_references<typename Numbers::Real>(references);
  return test_means(trial, held, [&](std::uint64_t first, std::vector<std::vector<double>>& channels) {
    for (std::size_t i = 0; i < channels[0].size(); ++i) {
      const std::vector<double> image = form.estimate(numbers.draws(key, spiky, first + i));
      for (std::size_t pixel = 0; pixel < image.size(); ++pixel) channels[pixel][i] = image[pixel];
      channels.back()[i] = mean_of_image(image);
    }
  });
}

/// The row for an unbiased form with a score, on eight spiky pixels, with a pilot of 2 or as
/// planned.
template <class Form, class Numbers = FromStreams<>>
Claim unbiased_allocation(const std::string& name, const std::vector<std::string>& subjects,
                          const std::string& source, const Form& form, const Numbers& numbers = {},
                          const SpikyPixels& spiky = unequal_spikes()) {
  return {.name = name + numbers.suffix,
          .kind = "mean",
          .subjects = with_subjects(subjects, numbers),
          .statement =
              "every one of eight pixels, of which 97.5 % is a steady ground and the rest spikes, and their image, "
              "has its mean over "
              "whole adaptive images",
          .source = source,
          .margin_factor = numbers.margin_factor,
          .check = [=](const Trial& trial) { return check_pixels(trial, spiky, form, numbers); },
          .real = real_name<typename Numbers::Real>()};
}

/// Tests the mean of the image of four equal pixels by the naive form, whose true value is 1,
/// against `mean`.
template <class Form, class Numbers>
Finding check_pooled(const Trial& trial, double mean, Sides sides, const Form& form, const Numbers& numbers) {
  const Reference reference{mean, 0, 1 / equal_spikes_p * (1 + 1e-12), 0, mean, sides};
  const StreamKey key(trial.seed, trial.claim);
  return test_means(trial, {reference}, one_channel([&](std::uint64_t r) {
                      return mean_of_image(form.estimate(numbers.draws(key, equal_spikes(), r)));
                    }));
}

inline Claim naive_claim(const std::string& name, std::vector<std::string> subjects, const std::string& statement,
                         std::function<Finding(const Trial&)> check) {
  return {.name = name,
          .kind = "mean",
          .subjects = std::move(subjects),
          .statement = "biased by construction: four spiky pixels " + statement,
          .source = "closed form, validation/claims/pooled_stages.h; Kirk and Arvo 1991",
          .margin_factor = 10,
          .check = std::move(check)};
}

/// The row for that mean in closed form.
template <class Form, class Numbers>
Claim pooled_allocation(const std::string& name, const std::vector<std::string>& subjects, double mean,
                        const Form& form, const Numbers& numbers) {
  const std::string statement =
      "have the mean of the closed form, " + std::to_string(std::lround(100 * (1 - mean))) + " % too dark";
  return naive_claim(name + numbers.suffix, with_subjects(subjects, numbers), statement,
                     [=](const Trial& trial) { return check_pooled(trial, mean, Sides::both, form, numbers); });
}

/// The row for the claim that this mean is at most `most`.
template <class Form>
Claim darker_allocation(const std::string& name, double most, const Form& form) {
  const std::string statement = "are at least " + std::to_string(std::lround(100 * (1 - most))) + " % too dark";
  return naive_claim(name, {"PooledStages"}, statement, [=](const Trial& trial) {
    return check_pooled(trial, most, Sides::not_above, form, FromStreams<>());
  });
}

/// One noisy pixel among quiet ones: a draw is uniform within `reach` of 1, so its standard
/// deviation is reach / sqrt 3.
struct OneNoisyPixel {
  PixelGrid grid{4, 2};
  static double reach(std::size_t pixel) { return pixel == 5 ? 1 : 0.1; }

  double operator()(std::size_t pixel, auto& source) const { return 1 + reach(pixel) * (2 * source.next() - 1); }
};

/// The row for how much less noise an adaptive image has than a uniform one of the same budget b.
/// With n_i samples the variance of the mean is a sum of s_i^2 / n_i, which is least for n_i
/// proportional to s_i. Here it is (sum s_i)^2 / b against 8 sum s_i^2 / b, a ratio of 0.34 plus
/// the cost of the pilot.
template <class Form, class Uniform>
Claim quieter_allocation(const std::string& name, std::vector<std::string> subjects, double ratio, const Form& form,
                         const Uniform& uniform) {
  return {.name = name,
          .kind = "variance",
          .subjects = std::move(subjects),
          .statement = "the mean of an image with one noisy pixel has at most " +
                       std::to_string(std::lround(100 * ratio)) +
                       " % of the variance that uniform sampling gives it, at an equal budget",
          .source = "Neyman 1934",
          .margin_factor = 50,
          .check = [=](const Trial& trial) {
            const double reach = (1 + 7 * 0.1) / 8 * (1 + 1e-12);  // of the mean of the image, which is about 1
            const auto images = [&](const char* purpose, const auto& drawn) {
              const StreamKey key(trial.seed, trial.claim + purpose);
              return BoundedEstimator{[key, drawn](std::uint64_t r) {
                                        const auto draws = FromStreams<>::draws(key, OneNoisyPixel(), r);
                                        return mean_of_image(drawn.estimate(draws));
                                      },
                                      1 - reach, 1 + reach};
            };
            return test_variance_ratio(trial, ratio, images(" adaptive", form), images(" uniform", uniform));
          }};
}

}  // namespace fairlight
