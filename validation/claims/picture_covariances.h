#pragma once

#include <cmath>
#include <string>
#include <vector>

#include <fairlight/validation/claims/rendered_variance.h>
#include <fairlight/validation/claims/replicate_pictures.h>

namespace fairlight {

/// The second order of whole pictures. Pictures show the grey ball, whose samples are 0 or 1 with
/// probability 1/2: a mean of n samples has the variance 1 / (4 n), if the samples do not depend on
/// each other.

/// The squared deviation from 1/2 of a mean of n such samples, in units of its variance, has the
/// mean 1.
/// Bound    it exceeds s with a probability of at most 2 exp(-s / 2), so E[(X - upper)+] is at most
///          4 exp(-upper / 2)
/// Source   Hoeffding 1963
inline Reference squared_deviation(double n) {
  constexpr double upper = 36;
  return n < upper ? Reference{1, 0, n * (1 + 1e-5)}
                   : Reference{.mean = 1, .lower = 0, .upper = upper, .tail_slack = 4 * std::exp(-upper / 2)};
}
inline double in_variances(double mean, double n) { return 4 * n * (mean - 0.5) * (mean - 0.5); }

/// How the samples of these pictures come, in names and in words.
struct RenderingWords {
  const char *name, *words;
};
inline RenderingWords words_of(Rendering rendering) {
  switch (rendering) {
    case Rendering::at_once:
      return {"at_once", "at once"};
    case Rendering::resumed:
      return {"resumed", "in two halves, the second by resuming"};
    case Rendering::ranges:
      return {"ranges", "as three merged shards of one seed"};
    case Rendering::seeds:
      break;
  }
  return {"seeds", "as three merged shards of consecutive seeds"};
}

/// A row about pictures of the grey ball. `check(trial, pictures)` gets ReplicatePictures.
template <class Renderer, class Check>
Claim grey_picture_row(const std::string& name, const std::string& statement, const std::string& source,
                       Arithmetic real, const PicturePlan& plan, double margin_factor, const Check& check) {
  return {.name = formatted("grey_ball.%s%s", name.c_str(), real == Arithmetic::packets ? ".packet" : ""),
          .kind = "second order",
          .subjects = {"PathTracer", "Film"},
          .statement = statement,
          .source = source,
          .margin_factor = margin_factor,
          .check =
              [=](const Trial& trial) {
                ReplicatePictures<Renderer> pictures(grey_ball().view, grey_ball_settings(real), plan,
                                                     StreamKey(trial.seed, trial.claim));
                return check(trial, pictures);
              },
          .real = name_of(real)};
}

/// The variance of each pixel is 1 / (4 n), for pictures of n samples in parts.
template <class Renderer = ShippedRenderer>
Claim variance_of_parts(Arithmetic real, Rendering rendering, std::uint32_t n) {
  const PicturePlan plan{27, 18, n, rendering};
  return grey_picture_row<Renderer>(
      formatted("parts.%s.%u", words_of(rendering).name, n),
      formatted("the variance of a pixel is 1 / (4 n), for n = %u samples that come %s", n,
                words_of(rendering).words),
      "the variance of n independent tosses of a coin is 1 / (4 n)", real, plan, 90,
      [=](const Trial& trial, auto& pictures) {
        const std::uint64_t pixels = 27 * 18;
        return test_means(trial, {squared_deviation(n)}, one_channel([&](std::uint64_t i) {
                            const auto at = static_cast<int>(i % pixels);
                            return in_variances(pictures.at(i / pixels).at(at % 27, at / 27)[0].mean(), n);
                          }));
      });
}

/// The squared standard error of each pixel, as the film has it, is 1 / (4 n) in the mean.
/// Bound    m ones of n samples have m (n - m) / (n^2 (n - 1)), which is most for m = n/2
template <class Renderer = ShippedRenderer>
Claim error_of_parts(Arithmetic real, Rendering rendering, std::uint32_t n) {
  const PicturePlan plan{27, 18, n, rendering};
  return grey_picture_row<Renderer>(
      formatted("parts.error.%s.%u", words_of(rendering).name, n),
      formatted("the mean of the squared standard error of a pixel is 1 / (4 n), for n = %u samples that come %s",
                n, words_of(rendering).words),
      "the variance of n independent tosses of a coin is 1 / (4 n)", real, plan, 10,
      [=](const Trial& trial, auto& pictures) {
        const std::uint64_t pixels = 27 * 18;
        const Reference reference{1, 0, n / (n - 1.0) * (1 + 1e-5)};
        return test_means(trial, {reference}, one_channel([&](std::uint64_t i) {
                            const auto at = static_cast<int>(i % pixels);
                            const ExactMoments& pixel = pictures.at(i / pixels).at(at % 27, at / 27)[0];
                            return 4.0 * n * std::pow(pixel.standard_error(), 2);
                          }));
      });
}

/// The variance of the mean of a whole picture of P pixels is 1 / (4 P n): pixels are uncorrelated,
/// whichever two. A correlation of few pairs of pixels shows in their sum.
template <class Renderer = ShippedRenderer>
Claim variance_of_pictures(Arithmetic real, int width, int height) {
  return grey_picture_row<Renderer>(
      formatted("picture_variance.%dx%d", width, height),
      formatted(
          "the variance of the mean of %d x %d pixels of one sample is that of one divided by their number, so "
          "no two pixels are correlated",
          width, height),
      "the variance of a sum of uncorrelated numbers", real, {width, height}, 90,
      [=](const Trial& trial, auto& pictures) {
        const double pixels = width * height;
        return test_means(trial, {squared_deviation(pixels)}, one_channel([&](std::uint64_t i) {
                            const Film& film = pictures.at(i);
                            double sum = 0;
                            for (int y = 0; y < height; ++y) {
                              for (int x = 0; x < width; ++x) sum += film.at(x, y)[0].mean();
                            }
                            return in_variances(sum / pixels, pixels);
                          }));
      });
}

/// The samples of pairs whose numbers are made alike: of a pixel and its neighbours, of sample 0 and
/// others of a pixel, of seeds s and s + 1. Sample 2^32 is the first one whose number takes more
/// than 32 bits. The mean of 4 (a - 1/2) (b - 1/2) over a picture's pairs is 0, and at most 1.
template <class Renderer = ShippedRenderer>
Claim uncorrelated_samples(Arithmetic real) {
  constexpr int width = 27, height = 18;
  return grey_picture_row<Renderer>(
      "uncorrelated",
      "neighbouring pixels, samples 0, 1, 64 and 2^32 of a pixel, and seeds s and s + 1 are uncorrelated",
      "independence", real, {width, height}, 20, [](const Trial& trial, auto& pictures) {
        const auto mean_product = [](const Film& a, const Film& b, int right, int down) {
          double sum = 0;
          for (int y = 0; y + down < height; ++y) {
            for (int x = 0; x + right < width; ++x)
              sum += (a.at(x, y)[0].mean() - 0.5) * (b.at(x + right, y + down)[0].mean() - 0.5);
          }
          return 4 * sum / ((width - right) * (height - down));
        };
        const std::vector<Reference> references(6, Reference{0, -1.001, 1.001, 0, 1});
        return test_means(trial, references, [&](std::uint64_t first, std::vector<std::vector<double>>& channels) {
          for (std::size_t i = 0; i < channels[0].size(); ++i) {
            const auto sample = [&](std::uint64_t n) { return pictures.part(first + i, 0, {n, n + 1}); };
            const Film at_0 = sample(0);
            channels[0][i] = mean_product(at_0, at_0, 1, 0);
            channels[1][i] = mean_product(at_0, at_0, 0, 1);
            channels[2][i] = mean_product(at_0, sample(1), 0, 0);
            channels[3][i] = mean_product(at_0, sample(64), 0, 0);
            channels[4][i] = mean_product(at_0, sample(std::uint64_t{1} << 32), 0, 0);
            channels[5][i] = mean_product(at_0, pictures.part(first + i, 1, {0, 1}), 0, 0);
          }
        });
      });
}

/// Adds all rows of this file.
inline void add_picture_covariances(std::vector<Claim>& claims) {
  for (const Arithmetic real : {Arithmetic::doubles, Arithmetic::packets}) {
    const bool in_packets = real == Arithmetic::packets;
    claims.push_back(uncorrelated_samples(real));
    claims.push_back(in_packets ? variance_of_pictures(real, 27, 18) : variance_of_pictures(real, 19, 11));
    for (const Rendering part : {Rendering::resumed, Rendering::ranges, Rendering::seeds}) {
      claims.push_back(variance_of_parts(real, part, in_packets ? 192 : 66));
    }
  }
  claims.push_back(variance_of_parts(Arithmetic::packets, Rendering::at_once, 256));
  claims.push_back(variance_of_parts(Arithmetic::packets, Rendering::at_once, 1024));
  claims.push_back(error_of_parts(Arithmetic::packets, Rendering::at_once, 1024));
  claims.push_back(error_of_parts(Arithmetic::packets, Rendering::resumed, 192));
  claims.push_back(error_of_parts(Arithmetic::packets, Rendering::seeds, 192));
}

}  // namespace fairlight
