// The packet renderer for one instruction set, which the build compiles this file for and names.

#include <fairlight/render/tile_tracer.h>

extern "C" fairlight::TileRenderer* FAIRLIGHT_ENTRY(const fairlight::TileSettings& settings) {
  return new fairlight::TileTracer<fairlight::Packet>(settings);
}
