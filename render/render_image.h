#pragma once

#include <cstdint>

#include <fairlight/render/built_in_scenes.h>
#include <fairlight/render/film.h>
#include <fairlight/render/parallel.h>
#include <fairlight/render/settings.h>

namespace fairlight {

/// The scene and the camera of the settings. Throws std::invalid_argument for an unknown scene, and
/// as with_camera_of does.
View view_of(const RenderSettings& settings);

/// A view with the camera options of the settings applied. Throws std::invalid_argument for a
/// number that is not finite, and as Camera does.
View with_camera_of(const RenderSettings& settings, View view);

/// Throws std::invalid_argument, with a number that works, unless `samples` is a multiple of the
/// settings' `points`: sample sets are rendered whole.
void check_whole_sets(const RenderSettings& settings, std::uint64_t samples);

/// The cost of a render.
struct RenderCost {
  std::uint64_t paths = 0;
  std::uint64_t rays = 0;  ///< camera rays, bounces and shadow rays
};

/// Adds samples `range` of every pixel to the film. With sets of points, whose samples depend on
/// each other, one draw of the film is the mean of a set. A sample is a function of (seed, pixel,
/// sample number), so the film does not depend on the threads or on how a range is split. Packets
/// use the named `instructions`, or the widest that the machine has: see choose_instructions.
/// Throws as Strategies does; std::invalid_argument for a path that might not end, a scene outside
/// the range of floats in packets, and parts of sets; std::domain_error for an invalid radiance.
RenderCost render_image(const View& view, const RenderSettings& settings, std::uint64_t seed, SampleRange range,
                        int threads, Film& film, const Progress& progress, const std::string& instructions = "");

}  // namespace fairlight
