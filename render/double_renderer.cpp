// A file of its own, so that it compiles beside the packet renderer.

#include <fairlight/render/tile_tracer.h>

namespace fairlight {

std::unique_ptr<TileRenderer> double_renderer(const TileSettings& settings) {
  return std::make_unique<TileTracer<double>>(settings);
}

}  // namespace fairlight
