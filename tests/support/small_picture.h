#pragma once

#include <fairlight/render/picture.h>

namespace fairlight::testing {

/// A picture of 5 x 3 pixels with two samples each, numbered from `first`, with seed 42.
inline Picture small_picture(std::uint64_t first = 0) {
  RenderSettings settings;
  settings.width = 5;
  settings.height = 3;
  Picture picture{settings, {}, Film(5, 3)};
  picture.samples.add(42, {first, first + 2});
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 5; ++x) {
      picture.film.add(x, y, {0.1 * x, 1e6 * y, 1e-6});
      picture.film.add(x, y, {0.3 * x, 1e6 * y, 1e-6});
    }
  }
  return picture;
}

}  // namespace fairlight::testing
