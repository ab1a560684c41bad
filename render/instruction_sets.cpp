#include <stdexcept>

#include <fairlight/render/instruction_sets.h>
#include <fairlight/render/tile_tracer.h>

#if defined(__x86_64__)
extern "C" {
fairlight::TileRenderer* fairlight_packet_renderer_avx2(const fairlight::TileSettings&);
fairlight::TileRenderer* fairlight_packet_renderer_avx512(const fairlight::TileSettings&);
}
#endif

namespace fairlight {
namespace {

TileRenderer* packet_renderer(const TileSettings& settings) { return new TileTracer<Packet>(settings); }

// Tests for the whole x86-64 level, as code compiled for it may use all of its instructions. Clang
// knows the names of the levels from version 18 on.
#if defined(__x86_64__) && !defined(__AVX__)
bool has_level_3() {
#if defined(__clang__)
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi") &&
         __builtin_cpu_supports("bmi2");
#else
  return __builtin_cpu_supports("x86-64-v3");
#endif
}

bool has_level_4() {
  return has_level_3() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
         __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") &&
         __builtin_cpu_supports("avx512cd");
}
#endif

}  // namespace

const std::vector<InstructionSet>& instruction_sets() {
#if defined(__AVX__)  // the whole program is built for one machine, as by the preset native
  static const std::vector<InstructionSet> sets{{"native", true, lanes<Packet>, packet_renderer}};
#elif defined(__x86_64__)
  static const std::vector<InstructionSet> sets{{"sse2", true, 4, packet_renderer},
                                                {"avx2", has_level_3(), 8, fairlight_packet_renderer_avx2},
                                                {"avx512", has_level_4(), 16, fairlight_packet_renderer_avx512}};
#else
  static const std::vector<InstructionSet> sets{{"neon", true, lanes<Packet>, packet_renderer}};
#endif
  return sets;
}

const InstructionSet& choose_instructions(const std::string& name, const std::vector<InstructionSet>& sets) {
  std::string known;
  const InstructionSet* widest = nullptr;
  for (const InstructionSet& set : sets) {
    if (!set.runs_here) {
      if (set.name == name)
        throw std::invalid_argument("this machine does not have the instructions \"" + name +
                                    "\" (leave them out)");
      continue;
    }
    if (set.name == name) return set;
    widest = &set;
    known += " " + set.name;
  }
  if (!name.empty())
    throw std::invalid_argument("there are no instructions \"" + name + "\" (choose one of:" + known + ")");
  return *widest;
}

std::unique_ptr<TileRenderer> tile_renderer(Arithmetic real, const InstructionSet& instructions,
                                            const TileSettings& settings) {
  return real == Arithmetic::packets ? std::unique_ptr<TileRenderer>(instructions.make(settings))
                                     : double_renderer(settings);
}

}  // namespace fairlight
