#pragma once

#include <cstdint>

#include <fairlight/estimators/stream.h>
#include <fairlight/render/camera.h>
#include <fairlight/render/film.h>
#include <fairlight/render/strategies.h>

namespace fairlight {

/// A part of an image.
struct Tile {
  int left, top, right, bottom;
  int width() const { return right - left; }
  int pixels() const { return width() * (bottom - top); }
};

/// Renders tiles of an image.
class TileRenderer {
 public:
  virtual ~TileRenderer() = default;
  /// Adds samples `range` of the tile's pixels to the film, and returns the number of rays that were traced. Any number of threads may
  /// render at once, each its own tile.
  virtual std::uint64_t render(const Tile& tile, SampleRange range, Film& film) const = 0;
};

/// What a renderer of tiles needs to know.
struct TileSettings {
  const Scene& scene;
  const Camera& camera;
  const Strategies& strategies;
  StreamKey key;
  int width, height;  ///< of the image
};

}  // namespace fairlight
