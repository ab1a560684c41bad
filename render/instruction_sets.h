#pragma once

#include <memory>
#include <string>
#include <vector>

#include <fairlight/render/tile_renderer.h>

namespace fairlight {

/// An instruction set that the packet renderer is compiled for. For one instruction set, a picture
/// is the same to the bit on every machine and with any number of threads.
struct InstructionSet {
  std::string name;   ///< sse2, avx2, avx512, neon, or native
  bool runs_here;     ///< whether this machine has it
  std::size_t lanes;  ///< lanes of a packet
  TileRenderer* (*make)(const TileSettings&);
};

/// All instruction sets that this program is built for, the widest last.
const std::vector<InstructionSet>& instruction_sets();

/// The instruction set of that name; for an empty name, the widest that runs here. Throws
/// std::invalid_argument, with a list of the sets that run here, for an unknown name, and for a set
/// that this machine does not have.
const InstructionSet& choose_instructions(const std::string& name,
                                          const std::vector<InstructionSet>& sets = instruction_sets());

/// A tile renderer in this arithmetic; packets have these instructions.
std::unique_ptr<TileRenderer> tile_renderer(Arithmetic real, const InstructionSet& instructions,
                                            const TileSettings& settings);

}  // namespace fairlight
