#pragma once

#include <fairlight/estimators/filter.h>
#include <fairlight/estimators/stream.h>
#include <fairlight/render/path_tracer.h>
#include <fairlight/validation/studies/renders.h>

namespace fairlight {

/// The size of a picture, its samples, and the key of its numbers.
struct TracedPicture {
  int width, height;
  std::uint64_t samples;
  StreamKey key;
};

/// The row and column of a pixel as a unit of random numbers.
inline std::uint32_t unit_of(int x, int y, int width) { return static_cast<std::uint32_t>(y * width + x); }

/// Renders a view by a path tracer of any components, also wrong ones, in double. Tracers with the same
/// key meet the same numbers. `kept(radiance)` is what the film gets of a sample.
template <class Tracer, class Kept>
Film trace_picture(const View& view, const Tracer& tracer, const TracedPicture& picture, int threads,
                   const Kept& kept) {
  Film film(picture.width, picture.height);
  const TracedScene<double> scene(view.scene);
  for_each_unit(static_cast<std::size_t>(picture.height), threads, [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < picture.width; ++x) {
      for (std::uint64_t sample = 0; sample < picture.samples; ++sample) {
        PhiloxStream<double> source(picture.key, unit_of(x, y, picture.width), sample);
        const Ray<double> ray =
            pixel_ray(view.camera, TentFilter<double>(), x, y, picture.width, picture.height, source);
        film.add(x, y, kept(tracer.template radiance<double>(scene, ray, source)));
      }
    }
  });
  return film;
}

inline Rgb<double> as_it_is(const Rgb<double>& radiance) { return radiance; }

}  // namespace fairlight
