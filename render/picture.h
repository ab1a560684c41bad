#pragma once

#include <cstdint>
#include <string>

#include <fairlight/render/film.h>
#include <fairlight/render/settings.h>

namespace fairlight {

/// A render as stored: its film, its settings, and which samples it holds.
struct Picture {
  RenderSettings settings;
  SampleLedger samples;
  Film film;

  /// Adds another picture's samples. Throws std::invalid_argument when the settings differ, or when
  /// both pictures hold a sample.
  void merge(const Picture& other);

  /// A checksum of everything that a resumed render needs: settings, samples, and all exact sums.
  std::uint64_t checksum() const;
};

/// Writes an OpenEXR file with two parts, whole or not at all. The first part is for viewers: R, G,
/// B, the mean radiance [W/(sr m^2)]; the layer `error`, its standard error (infinite for one
/// sample); `samples.N`, the number of samples. It has scene, settings, seeds, version and checksum
/// as attributes `fairlight.*`. The second part, `sums`, is the film's exact state, from which
/// renders are resumed and merged. Throws std::runtime_error.
void write_exr(const std::string& path, const Picture& picture);

/// Reads a file of write_exr. Throws std::runtime_error, with the file's name, for any other file:
/// missing, foreign, truncated, without a checksum, or saved again by another program, which may
/// have rounded, mirrored or cropped it.
Picture read_exr(const std::string& path);

/// Writes an 8-bit sRGB preview, whole or not at all. Radiance 1 is white; brighter values are
/// clipped.
void write_png(const std::string& path, const Film& film);

}  // namespace fairlight
