#pragma once

#include <memory>
#include <string>
#include <vector>

#include <fairlight/render/tile_renderer.h>

namespace fairlight {

/// One of the instruction sets that the packet renderer is built for. Wider packets do more at once; a picture of packets is
/// the same to the bit for any machine and any number of threads, given the instruction set.
struct InstructionSet {
  std::string name;   ///< sse2 | avx2 | avx512, or neon, or native
  bool runs_here;     ///< whether this machine has it
  std::size_t lanes;  ///< of a packet
  TileRenderer* (*make)(const TileSettings&);
};

/// All that this program is built for, the widest last.
const std::vector<InstructionSet>& instruction_sets();

/// The one of that name; the widest that runs here for an empty name. Throws std::invalid_argument, saying which there are, for another
/// name or for a set that this machine does not have.
const InstructionSet& choose_instructions(const std::string& name,
                                          const std::vector<InstructionSet>& sets = instruction_sets());

/// A renderer of tiles in the arithmetic that the settings name: `packet` by these instructions, or `double`. Throws
/// std::invalid_argument for another.
std::unique_ptr<TileRenderer> tile_renderer(const std::string& real, const InstructionSet& instructions,
                                            const TileSettings& settings);

}  // namespace fairlight
