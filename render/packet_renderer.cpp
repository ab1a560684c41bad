// The packet renderer for one instruction set. The build compiles this file once for each set.

#include <fairlight/render/tile_tracer.h>

extern "C" fairlight::TileRenderer* FAIRLIGHT_ENTRY(const fairlight::TileSettings& settings) {
  return new fairlight::TileTracer<fairlight::Packet>(settings);
}
