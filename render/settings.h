#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace fairlight {

/// What a picture is an estimate of, and by which strategies. Two renders may be merged when these are equal.
struct RenderSettings {
  std::string scene = "cornell-simple";
  int width = 256;
  int height = 256;
  std::string real = "packet";          ///< packet | double
  std::string bounce = "cosine";        ///< cosine | uniform
  std::string direct = "light";         ///< light | none | mis
  std::string light_sampling = "area";  ///< area | visible | cone | solid-angle
  std::string which_light = "one";      ///< all | one | power | contribution
  std::string roulette = "albedo";      ///< albedo | throughput | off
  int roulette_depth = -1;              ///< the first bounce that it may refuse, from 1; -1 for the roulette's own
  std::string filter = "tent";          ///< tent | box | gaussian | blackman-harris
  std::string random = "independent";   ///< independent | sobol | stratified
  std::uint32_t points = 1;  ///< of a set: samples that depend on each other, and make one draw of the film
  int max_depth = -1;        ///< bounces; -1 for no limit
  double aperture = -1;      ///< the lens's radius [m], 0 for a pinhole; negative for the scene's own
  double focus = -1;         ///< what is seen sharp, along the axis [m]; negative for the scene's own
  double fov = -1;           ///< the vertical field of view [degrees]; negative for the scene's own
};

/// Throws std::invalid_argument, naming it, for a number that is not finite: a NaN is neither given
/// nor left to the scene.
void check_finite(const RenderSettings& settings);

/// An object with every setting under its name. Both throw std::invalid_argument, which names the
/// setting: the first as check_finite does, the second for one that is missing, null or of another
/// type.
void to_json(nlohmann::json& json, const RenderSettings& settings);
void from_json(const nlohmann::json& json, RenderSettings& settings);

/// Samples first .. last - 1 of every pixel.
struct SampleRange {
  std::uint64_t first;
  std::uint64_t last;
};

/// Which samples of which seed a picture holds, so that none is counted twice.
class SampleLedger {
 public:
  /// Throws std::invalid_argument when some of them are there already, the range is empty, or there would be 2^64 and more.
  void add(std::uint64_t seed, SampleRange range);
  /// Throws as add does.
  void merge(const SampleLedger& other);
  /// How many samples there are, of all seeds.
  std::uint64_t total() const;
  /// The first sample number of this seed after all that are there.
  std::uint64_t next(std::uint64_t seed) const;
  /// The only seed there is. Throws std::invalid_argument when there are several.
  std::uint64_t seed() const;

  /// {"seed": [[first, last], ...], ...}, adjacent ranges joined, so that equal sets give equal text.
  nlohmann::json json() const;
  static SampleLedger from_json(const nlohmann::json& json);

 private:
  std::map<std::uint64_t, std::map<std::uint64_t, std::uint64_t>> ranges_;  // seed -> first -> last
};

}  // namespace fairlight
