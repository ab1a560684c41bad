#pragma once

#include <cstdint>
#include <string>

#include <fairlight/render/parallel.h>
#include <fairlight/render/settings.h>
#include <fairlight/validation/app/options.h>

namespace fairlight {

/// The most samples of a pixel: the sample count in the EXR has 32 bits.
inline constexpr std::uint64_t most_samples = 0xFFFFFFFF;

/// The options of `fairlight render`.
struct RenderOptions {
  RenderSettings settings;
  std::uint64_t spp = 0;
  std::uint32_t points = 0;  ///< 0 if not given
  std::string output, png, json, seed, resume, instructions;
  std::string shard = "1/1";
  int threads = hardware_threads();
};

/// Adds these options to the command.
void add_render_options(CLI::App& app, RenderOptions& options);

}  // namespace fairlight
