#pragma once

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace fairlight {

/// The strategies of the renderer, each named once: help, options, files, claims and tests read
/// these tables. A new strategy needs an enumerator, a row, and its branch in strategies.h. The
/// order of the rows also decides which combinations PairwiseCover claims.

/// Which scenes admit a strategy: any, those with a light, or those whose lights are all spheres or
/// all rectangles.
enum class Scenes { any, with_lights, with_sphere_lights, with_rectangle_lights };

/// A strategy.
template <class Strategy>
struct StrategyRow {
  Strategy value;
  const char* name;    ///< the value of its option, also in files and in names of claims
  const char* help;    ///< after the name and a colon
  const char* claims;  ///< the first part of the names of claims that certify it
  Scenes scenes = Scenes::any;
};

/// The table of one kind of strategy: the name of its setting, the help of its option, and a row
/// for each value.
template <class Strategy>
struct StrategyTable;

enum class Arithmetic { doubles, packets };
template <>
struct StrategyTable<Arithmetic> {
  static constexpr const char* setting = "real";
  static constexpr const char* help = "Trace paths in this arithmetic.";
  static constexpr auto rows = std::to_array<StrategyRow<Arithmetic>>({
      {Arithmetic::doubles, "double", "one path at a time, in doubles", "concentric_spheres"},
      {Arithmetic::packets, "packet", "packets of paths, in floats", "cornell-simple.float"},
  });
};

enum class BounceSampling { cosine, uniform };
template <>
struct StrategyTable<BounceSampling> {
  static constexpr const char* setting = "bounce";
  static constexpr const char* help = "Sample the directions of diffuse bounces in this way.";
  static constexpr auto rows = std::to_array<StrategyRow<BounceSampling>>({
      {BounceSampling::cosine, "cosine", "in proportion to the cosine with the normal", "hemisphere.cosine"},
      {BounceSampling::uniform, "uniform", "uniformly over the hemisphere", "hemisphere.uniform"},
  });
};

enum class DirectLighting { none, light, mis };
template <>
struct StrategyTable<DirectLighting> {
  static constexpr const char* setting = "direct";
  static constexpr const char* help = "Find light in this way.";
  static constexpr auto rows = std::to_array<StrategyRow<DirectLighting>>({
      {DirectLighting::none, "none", "by bounces alone", "sphere_over_plane.cosine"},
      {DirectLighting::light, "light", "by shadow rays alone", "sphere_over_plane.light", Scenes::with_lights},
      {DirectLighting::mis, "mis", "by both, with the balance heuristic", "sphere_over_plane.shared",
       Scenes::with_lights},
  });
};

enum class LightPoints { solid_angle, area, visible, cone };
template <>
struct StrategyTable<LightPoints> {
  static constexpr const char* setting = "light_sampling";
  static constexpr const char* help = "Sample the points of a light in this way.";
  static constexpr auto rows = std::to_array<StrategyRow<LightPoints>>({
      {LightPoints::solid_angle, "solid-angle", "uniformly in the solid angle that it fills",
       "rectangle.by_solid_angle", Scenes::with_rectangle_lights},
      {LightPoints::area, "area", "uniformly on its surface", "sphere_light.by_area"},
      {LightPoints::visible, "visible", "uniformly on the hemisphere that faces the point",
       "sphere_light.by_visible", Scenes::with_sphere_lights},
      {LightPoints::cone, "cone", "uniformly in the cone that it fills", "sphere_light.by_cone",
       Scenes::with_sphere_lights},
  });
};

enum class WhichLight { all, one, power, contribution };
template <>
struct StrategyTable<WhichLight> {
  static constexpr const char* setting = "which_light";
  static constexpr const char* help = "Send shadow rays to these lights.";
  static constexpr auto rows = std::to_array<StrategyRow<WhichLight>>({
      {WhichLight::all, "all", "each", "pick.all"},
      {WhichLight::one, "one", "one, chosen uniformly", "pick.one"},
      {WhichLight::power, "power", "one, chosen by its power", "pick.power"},
      {WhichLight::contribution, "contribution", "one, chosen by its power over the squared distance",
       "pick.contribution"},
  });
};

enum class RouletteKind { albedo, throughput, off };
template <>
struct StrategyTable<RouletteKind> {
  static constexpr const char* setting = "roulette";
  static constexpr const char* help = "Let paths survive a bounce with this probability.";
  static constexpr auto rows = std::to_array<StrategyRow<RouletteKind>>({
      {RouletteKind::albedo, "albedo", "the surface's albedo", "roulette.walk.reflectance"},
      {RouletteKind::throughput, "throughput", "the path's throughput", "roulette.walk.throughput"},
      {RouletteKind::off, "off", "1, up to --max-depth", "furnace.depth3"},
  });
};

enum class PixelFilter { tent, box, gaussian, blackman_harris };
template <>
struct StrategyTable<PixelFilter> {
  static constexpr const char* setting = "filter";
  static constexpr const char* help = "Use this pixel filter.";
  static constexpr auto rows = std::to_array<StrategyRow<PixelFilter>>({
      {PixelFilter::tent, "tent", "of radius 1 pixel", "filter.tent"},
      {PixelFilter::box, "box", "of radius 0.5", "filter.box"},
      {PixelFilter::gaussian, "gaussian", "of radius 1.5 and deviation 0.5", "filter.gaussian"},
      {PixelFilter::blackman_harris, "blackman-harris", "of radius 2", "filter.blackman_harris"},
  });
};

enum class RandomNumbers { independent, sobol, stratified };
template <>
struct StrategyTable<RandomNumbers> {
  static constexpr const char* setting = "random";
  static constexpr const char* help = "Take random numbers from this source.";
  static constexpr auto rows = std::to_array<StrategyRow<RandomNumbers>>({
      {RandomNumbers::independent, "independent", "independent for all samples", "independent"},
      {RandomNumbers::sobol, "sobol", "sets of scrambled Sobol' points", "padded_sobol"},
      {RandomNumbers::stratified, "stratified", "sets with a point in every stratum", "padded_strata"},
  });
};

/// Calls use(StrategyTable<...>()) for every kind of strategy.
template <class Use>
void for_each_strategy_kind(const Use& use) {
  use(StrategyTable<Arithmetic>());
  use(StrategyTable<BounceSampling>());
  use(StrategyTable<DirectLighting>());
  use(StrategyTable<LightPoints>());
  use(StrategyTable<WhichLight>());
  use(StrategyTable<RouletteKind>());
  use(StrategyTable<PixelFilter>());
  use(StrategyTable<RandomNumbers>());
}

/// The row of a strategy. Throws std::invalid_argument for a value without one.
template <class Strategy>
constexpr const StrategyRow<Strategy>& row_of(Strategy value) {
  for (const StrategyRow<Strategy>& row : StrategyTable<Strategy>::rows) {
    if (row.value == value) return row;
  }
  throw std::invalid_argument("a strategy has no row in its table (add it in strategy_table.h)");
}

template <class Strategy>
constexpr const char* name_of(Strategy value) {
  return row_of(value).name;
}

/// The row of that name, or nullptr.
template <class Strategy>
constexpr const StrategyRow<Strategy>* find_strategy(std::string_view name) {
  for (const StrategyRow<Strategy>& row : StrategyTable<Strategy>::rows) {
    if (row.name == name) return &row;
  }
  return nullptr;
}

/// All names of a kind, in the order of its table.
template <class Strategy>
std::vector<std::string> strategy_names() {
  std::vector<std::string> names;
  for (const StrategyRow<Strategy>& row : StrategyTable<Strategy>::rows) names.emplace_back(row.name);
  return names;
}

/// The option of a setting: "--light-sampling" for "light_sampling".
inline std::string option_of(const char* setting) {
  std::string option = "--";
  for (const char letter : std::string_view(setting)) option += letter == '_' ? '-' : letter;
  return option;
}

/// The option with this value, as it is typed: "--direct none".
template <class Strategy>
std::string option_with(Strategy value) {
  return option_of(StrategyTable<Strategy>::setting) + " " + name_of(value);
}

}  // namespace fairlight
