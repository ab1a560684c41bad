#include <algorithm>
#include <stdexcept>

#include <gtest/gtest.h>

#include <fairlight/render/render_image.h>
#include <fairlight/stats/text.h>

namespace fairlight {
namespace {

Film render(const RenderSettings& settings, std::uint64_t samples) {
  Film film(settings.width, settings.height);
  render_image(view_of(settings), settings, 11, {0, samples}, 2, film, {});
  return film;
}

// A kind of strategy, and the names of its strategies.
struct Kind {
  std::string setting;
  std::vector<std::string> names;
};

std::vector<Kind> all_kinds() {
  std::vector<Kind> kinds;
  for_each_strategy_kind([&]<class Strategy>(const StrategyTable<Strategy>& table) {
    kinds.push_back({table.setting, strategy_names<Strategy>()});
  });
  return kinds;
}

// Whether the scene admits the strategies: all lights of a built-in scene have one shape.
bool admits(const RenderSettings& settings) {
  const Scenes scenes = row_of(settings.light_sampling).scenes;
  const bool rectangles = view_of(settings).scene.luminaires()[0].is_rectangle;
  return settings.direct == DirectLighting::none || scenes == Scenes::any ||
         scenes == (rectangles ? Scenes::with_rectangle_lights : Scenes::with_sphere_lights);
}

const std::string one_or_power = "one or power";

// The settings as JSON, where those that mean the same in a scene are made the same: without shadow
// rays their strategies do not matter, of one luminaire there is no choice, and luminaires of equal
// power are chosen alike, up to rounding.
nlohmann::json what_is_said_by(const RenderSettings& settings, const std::vector<Luminaire>& luminaires) {
  nlohmann::json said = settings;
  const auto as_bright = [&](const Luminaire& light) { return power_of(light) == power_of(luminaires[0]); };
  const bool is_even = settings.which_light == WhichLight::one || settings.which_light == WhichLight::power;
  if (is_even && std::ranges::all_of(luminaires, as_bright)) said["which_light"] = one_or_power;
  if (luminaires.size() == 1) said["which_light"] = "";
  if (settings.direct == DirectLighting::none) said["light_sampling"] = said["which_light"] = "";
  return said;
}

// The films of all values of two kinds in a scene: the same where the settings say the same, and
// only there. Few paths find a light without shadow rays, so there are more samples where these may
// be left out.
void expect_each_pair_its_own(const RenderSettings& scene, const Kind& one, const Kind& other) {
  const std::vector<Luminaire> luminaires = view_of(scene).scene.luminaires();
  const std::string direct = StrategyTable<DirectLighting>::setting;
  const bool may_leave_out = one.setting == direct || other.setting == direct;
  std::vector<std::pair<nlohmann::json, Film>> films;
  for (const std::string& a : one.names) {
    for (const std::string& b : other.names) {
      nlohmann::json json = scene;
      json[one.setting] = a;
      json[other.setting] = b;
      auto pair = json.get<RenderSettings>();
      if (pair.roulette == RouletteKind::throughput) pair.roulette_depth = 2;
      const std::string name = formatted("%s %s %s", scene.scene.c_str(), a.c_str(), b.c_str());
      if (!admits(pair)) {
        EXPECT_THROW(render(pair, 1), std::invalid_argument) << name;
        continue;
      }
      const nlohmann::json said = what_is_said_by(pair, luminaires);
      const Film film = render(pair, may_leave_out ? 32 : 1);
      for (const auto& [other_said, other_film] : films) {
        if (said == other_said && said["which_light"] == one_or_power) continue;
        EXPECT_EQ(film == other_film, said == other_said) << name << " and " << other_said;
      }
      films.emplace_back(said, film);
    }
  }
  EXPECT_GE(films.size(), 4u);
}

// Every pair of strategies, in every scene that admits them.
TEST(StrategyPairs, AreTakenAtTheirWord) {
  const std::vector<Kind> kinds = all_kinds();
  for (const std::string& scene : scene_names()) {
    RenderSettings settings;
    settings.width = settings.height = 8;
    settings.scene = scene;
    settings.max_depth = 3;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) expect_each_pair_its_own(settings, kinds[i], kinds[j]);
    }
  }
}

}  // namespace
}  // namespace fairlight
