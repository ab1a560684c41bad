#pragma once

#include <cstdint>
#include <memory>

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
  /// Adds samples `range` of the tile's pixels to the film, and returns the number of traced rays.
  /// Several threads may render different tiles at once.
  virtual std::uint64_t render(const Tile& tile, SampleRange range, Film& film) const = 0;
};

/// The input of a tile renderer.
struct TileSettings {
  const Scene& scene;
  const Camera& camera;
  const Strategies& strategies;
  StreamKey key;
  int width, height;  ///< of the image
};

/// The tile renderer in double.
std::unique_ptr<TileRenderer> double_renderer(const TileSettings& settings);

}  // namespace fairlight
