#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include <fairlight/render/settings.h>

namespace fairlight {

/// A strategy for direct light: shadow rays to points sampled in this way, or none.
struct LightSearch {
  DirectLighting direct;
  LightPoints light_sampling;
};

/// All that the renderer has for these scenes. For rectangles it leaves out shadow rays by area
/// alone, whose variance is infinite where two rectangles meet, as their points can be arbitrarily
/// close.
inline std::vector<LightSearch> searches_of(Scenes scenes) {
  std::vector<LightSearch> searches;
  for (const auto& direct : StrategyTable<DirectLighting>::rows) {
    if (direct.scenes == Scenes::any) {  // no shadow rays, so no sampling
      searches.push_back({direct.value, RenderSettings().light_sampling});
      continue;
    }
    for (const auto& sampling : StrategyTable<LightPoints>::rows) {
      const bool is_infinite = scenes == Scenes::with_rectangle_lights && direct.value == DirectLighting::light &&
                               sampling.value == LightPoints::area;
      const bool is_admitted = sampling.scenes == Scenes::any || sampling.scenes == scenes;
      if (is_admitted && !is_infinite) searches.push_back({direct.value, sampling.value});
    }
  }
  return searches;
}
inline std::vector<LightSearch> searches_of_spheres() { return searches_of(Scenes::with_sphere_lights); }
inline std::vector<LightSearch> searches_of_rectangles() { return searches_of(Scenes::with_rectangle_lights); }

/// Combinations of strategies of the renderer that cover all pairs, since most errors of a
/// composition need two strategies. Every bounce meets every search for light and every choice of a
/// light. Any two strategies of two kinds meet, also of roulette, numbers, filter, lens and
/// arithmetic. A row is completed so that it has the most new pairs, then the least frequent ones.
/// Searches without a choice have as many rows, for the other kinds. Throws std::invalid_argument
/// for more than 15 searches.
/// Source   Cohen, Dalal, Fredman, Patton 1997 (IEEE TSE 23:437)
class PairwiseCover {
 public:
  /// For paths of at most `depth` bounces, and at most three if bounces are uniform, as each of
  /// these doubles the bound of a path.
  PairwiseCover(const std::vector<LightSearch>& searches, int depth) {
    if (searches.size() >= most) throw std::invalid_argument("there are too many searches to be crossed");
    for (std::size_t bounce = 0; bounce < bounces.size(); ++bounce) {
      for (std::size_t search = 0; search < searches.size(); ++search) {
        const bool chooses = searches[search].direct != DirectLighting::none;
        for (std::size_t choice = 0; choice < choices.size(); ++choice) {
          Completion best;
          complete({bounce, search, chooses ? choice : no_choice}, first_completed, best);
          for_each_pair(best.row, [&](std::size_t pair) { ++met_[pair]; });
          rows_.push_back(settings_of(best.row, searches[search], depth));
        }
      }
    }
  }

  std::vector<RenderSettings> rows() const { return rows_; }

 private:
  // The indices of the strategies: bounce, search, choice, roulette, numbers, filter, aperture,
  // real.
  using Row = std::array<std::size_t, 8>;
  static constexpr std::size_t kinds = 8, first_completed = 3;
  static constexpr std::size_t most = 16, no_choice = most - 1;

  static constexpr auto bounces = StrategyTable<BounceSampling>::rows;
  static constexpr auto choices = StrategyTable<WhichLight>::rows;
  static constexpr auto roulettes = StrategyTable<RouletteKind>::rows;
  static constexpr auto numbers = StrategyTable<RandomNumbers>::rows;
  static constexpr auto filters = StrategyTable<PixelFilter>::rows;
  static constexpr std::array apertures{0.0, 0.2};
  static constexpr auto reals = StrategyTable<Arithmetic>::rows;
  static constexpr std::array completions{roulettes.size(), numbers.size(), filters.size(), apertures.size(),
                                          reals.size()};

  template <class Use>
  static void for_each_pair(const Row& row, const Use& use) {
    for (std::size_t i = 0; i < kinds; ++i) {
      for (std::size_t j = 0; j < i; ++j) use(((i * most + row[i]) * kinds + j) * most + row[j]);
    }
  }

  struct Completion {
    Row row{};
    std::pair<int, int> cost{std::numeric_limits<int>::max(),
                             0};  ///< pairs that have met, and the sum of their counts
  };

  // Tries all completions of a row, from a kind on.
  void complete(Row row, std::size_t kind, Completion& best) const {
    if (kind < kinds) {
      for (row[kind] = 0; row[kind] < completions[kind - first_completed]; ++row[kind]) {
        complete(row, kind + 1, best);
      }
      return;
    }
    std::pair cost{0, 0};
    for_each_pair(row, [&](std::size_t pair) {
      cost.first += met_[pair] > 0 ? 1 : 0;
      cost.second += met_[pair];
    });
    if (cost < best.cost) best = {row, cost};
  }

  static RenderSettings settings_of(const Row& row, const LightSearch& search, int depth) {
    RenderSettings settings;
    settings.bounce = bounces[row[0]].value;
    settings.direct = search.direct;
    settings.light_sampling = search.light_sampling;
    if (row[2] != no_choice) settings.which_light = choices[row[2]].value;
    settings.roulette = roulettes[row[3]].value;
    if (settings.roulette == RouletteKind::throughput) settings.roulette_depth = 2;  // paths are short
    settings.random = numbers[row[4]].value;
    settings.points = settings.random == RandomNumbers::independent ? 1 : 4;
    settings.filter = filters[row[5]].value;
    settings.aperture = apertures[row[6]];
    settings.real = reals[row[7]].value;
    settings.max_depth = settings.bounce == BounceSampling::uniform ? std::min(depth, 3) : depth;
    return settings;
  }

  std::vector<int> met_ = std::vector<int>(kinds * most * kinds * most);
  std::vector<RenderSettings> rows_;
};

}  // namespace fairlight
