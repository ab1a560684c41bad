#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include <fairlight/render/strategy_table.h>

namespace fairlight {

/// What a picture estimates, and by which strategies. Two renders can be merged if their settings
/// are equal.
struct RenderSettings {
  std::string scene = "cornell-simple";
  int width = 256;
  int height = 256;
  Arithmetic real = Arithmetic::packets;
  BounceSampling bounce = BounceSampling::cosine;
  DirectLighting direct = DirectLighting::light;
  LightPoints light_sampling = LightPoints::area;
  WhichLight which_light = WhichLight::one;
  RouletteKind roulette = RouletteKind::albedo;
  int roulette_depth = -1;  ///< first bounce for roulette, from 1; -1 for its default
  PixelFilter filter = PixelFilter::tent;
  RandomNumbers random = RandomNumbers::independent;
  std::uint32_t points = 1;  ///< points of a set, whose mean is one draw of the film
  int max_depth = -1;        ///< maximum bounces; -1 for no limit
  double aperture = -1;      ///< lens radius [m], 0: pinhole; negative: the scene's
  double focus = -1;         ///< distance in focus [m]; negative: the scene's
  double fov = -1;           ///< vertical field of view [degrees]; negative: the scene's
};

/// Throws std::invalid_argument, with the setting's name, for a number that is not finite. A NaN
/// would count neither as given nor as left to the scene.
void check_finite(const RenderSettings& settings);

/// A JSON object with every setting under its name, and strategies by theirs. Both functions throw
/// std::invalid_argument with the setting's name: to_json as check_finite does, from_json for a
/// setting that is missing, null or of another type, and for a strategy that does not exist.
void to_json(nlohmann::json& json, const RenderSettings& settings);
void from_json(const nlohmann::json& json, RenderSettings& settings);

/// Samples first .. last - 1 of every pixel.
struct SampleRange {
  std::uint64_t first;
  std::uint64_t last;
};

/// Which samples of which seeds a picture holds, so that no sample counts twice.
class SampleLedger {
 public:
  /// Throws std::invalid_argument if some of the samples are there already, if the range is empty,
  /// or if there would be 2^64 or more samples.
  void add(std::uint64_t seed, SampleRange range);
  /// Throws as add does.
  void merge(const SampleLedger& other);
  /// The number of samples of all seeds.
  std::uint64_t total() const;
  /// The sample number after the last one of this seed.
  std::uint64_t next(std::uint64_t seed) const;
  /// The only seed. Throws std::invalid_argument if there are several.
  std::uint64_t seed() const;

  /// {"seed": [[first, last], ...], ...}. Adjacent ranges are joined, so that equal sets give equal
  /// text.
  nlohmann::json json() const;
  static SampleLedger from_json(const nlohmann::json& json);

 private:
  std::map<std::uint64_t, std::map<std::uint64_t, std::uint64_t>> ranges_;  // seed -> first -> last
};

}  // namespace fairlight
