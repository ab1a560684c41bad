#pragma once

#include <cstdint>
#include <functional>

#include <fairlight/render/built_in_scenes.h>
#include <fairlight/render/film.h>
#include <fairlight/render/settings.h>

namespace fairlight {

/// The scene that the settings name, through the camera that they ask for. Throws
/// std::invalid_argument for a scene that does not exist; and as with_camera_of does.
View view_of(const RenderSettings& settings);

/// Any scene through the camera that they ask for. Throws std::invalid_argument for a number that
/// is not finite, and as Camera does.
View with_camera_of(const RenderSettings& settings, View view);

/// Samples that come in sets are rendered by whole sets. Throws std::invalid_argument, saying what would do, for a number of them that
/// is no multiple of the settings' `points`.
void check_whole_sets(const RenderSettings& settings, std::uint64_t samples);

/// What a render cost.
struct RenderCost {
  std::uint64_t paths = 0;
  std::uint64_t rays = 0;  ///< camera rays, bounces and shadow rays
};

/// Called with the fraction done, in (0,1], from one thread at a time.
using Progress = std::function<void(double)>;

/// Adds samples `range` of every pixel to the film: each a draw, or the mean of each set of points where they come in sets, whose samples
/// depend on each other. A sample is a function of (seed, pixel, sample number), so the film depends neither on the threads nor on how a range was split. Packets are worked on by the named instructions, or
/// the widest that the machine has: see choose_instructions.
/// Throws std::invalid_argument for a strategy that does not exist or a path that might not end, for a scene that packets do not
/// hold, and for parts of sets; std::domain_error for a sample that is not a radiance.
RenderCost render_image(const View& view, const RenderSettings& settings, std::uint64_t seed, SampleRange range,
                        int threads, Film& film, const Progress& progress, const std::string& instructions = "");

}  // namespace fairlight
