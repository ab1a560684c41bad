#pragma once

#include <cstdint>
#include <string>

#include <fairlight/render/film.h>
#include <fairlight/render/settings.h>

namespace fairlight {

/// A render as it is kept: its film, what it estimates, and which samples it holds.
struct Picture {
  RenderSettings settings;
  SampleLedger samples;
  Film film;

  /// Adds another picture's samples. Throws std::invalid_argument when the settings differ or samples are in both.
  void merge(const Picture& other);

  /// Of all that a render goes on from: settings, samples, and the exact sums of pixel after pixel.
  std::uint64_t checksum() const;
};

/// OpenEXR with two parts. The first is for people: R, G, B, the mean radiance [W/(sr m^2)]; the layer `error`, its
/// standard error (infinite for one sample); `samples.N`, how many samples; scene, settings, seeds, version and checksum as attributes
/// `fairlight.*`. The second, `sums`, is the film's exact state, by which a render is resumed and merged. Written whole or not at
/// all; throws std::runtime_error.
void write_exr(const std::string& path, const Picture& picture);

/// Reads what write_exr wrote. Throws std::runtime_error, naming the file, for any other: missing, foreign, truncated,
/// saved again by another program, which may have rounded, mirrored or cropped it, or without a checksum.
Picture read_exr(const std::string& path);

/// A preview: 8-bit sRGB, radiance 1 as white, what is brighter cut off. Written whole or not at all.
void write_png(const std::string& path, const Film& film);

}  // namespace fairlight
