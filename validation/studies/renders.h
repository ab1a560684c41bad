#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <fairlight/render/render_image.h>
#include <fairlight/validation/studies/study.h>

namespace fairlight {

/// Seed number `replicate` of a purpose, such as the name of a study and of a strategy.
std::uint64_t replicate_seed(const StudyOptions& options, const std::string& purpose, std::uint32_t replicate);

/// The pixels of a picture that have no light within `margin` pixels, even a hidden one: at the edge
/// of a light the noise is that of the pixel filter, for all strategies alike. Row by row.
std::vector<bool> pixels_off_lights(const View& view, int width, int height, int margin = 3);

/// The mean of the square of the standard error, over the counted pixels and the channels
/// [(W/(sr m^2))^2]. An unbiased estimate of the square error of the picture. Each pixel needs two
/// draws.
double square_error(const Film& film, const std::vector<bool>& counted);

/// The mean radiance of each channel over the counted pixels [W/(sr m^2)].
Rgb<double> mean_radiance(const Film& film, const std::vector<bool>& counted);

/// A picture to be rendered several times.
struct Arm {
  std::string name;
  View view;
  RenderSettings settings;
  std::uint64_t samples;
};

/// A film of the arm by the seed of a replicate, and the CPU seconds that it took on all threads.
struct TimedFilm {
  Film film;
  double seconds;
};
TimedFilm render_arm(const Arm& arm, const StudyOptions& options, std::uint32_t replicate);

/// What the replicates of an arm had: one value for each.
struct ArmRuns {
  std::vector<double> square_errors;  ///< as of one sample a pixel: the square error times the samples
  std::vector<double> seconds;        ///< of one sample a pixel, on all threads
  std::vector<Rgb<double>> means;     ///< the mean radiance
  std::vector<double> costs() const;  ///< square error times seconds, which no number of samples changes
};

/// Renders every arm once in each replicate, one after the other, so that a pair of arms meets the
/// same state of the machine. `steps` counts every render.
std::vector<ArmRuns> run_arms(const std::vector<Arm>& arms, const StudyOptions& options, std::uint32_t replicates,
                              Steps& steps);

/// A ratio as the difference from 1 in %.
Measured in_percent(const Measured& ratio);

/// Efficiency is 1 / (square error x CPU time). These are ratios, of `a` over `b`.
Measured efficiency_ratio(const ArmRuns& a, const ArmRuns& b);
Measured variance_ratio(const ArmRuns& a, const ArmRuns& b);  ///< at an equal number of samples
Measured time_ratio(const ArmRuns& a, const ArmRuns& b);      ///< of a sample

}  // namespace fairlight
