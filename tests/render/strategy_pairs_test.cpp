#include <algorithm>
#include <stdexcept>

#include <gtest/gtest.h>

#include <fairlight/render/render_image.h>

namespace fairlight {
namespace {

Film render(const RenderSettings& settings, std::uint64_t samples) {
  Film film(settings.width, settings.height);
  render_image(view_of(settings), settings, 11, {0, samples}, 2, film, {});
  return film;
}

using Values = std::vector<std::pair<std::string RenderSettings::*, std::vector<std::string>>>;
const Values strategies{{&RenderSettings::real, {"packet", "double"}},
                        {&RenderSettings::bounce, {"cosine", "uniform"}},
                        {&RenderSettings::direct, {"light", "none", "mis"}},
                        {&RenderSettings::light_sampling, {"area", "visible", "cone", "solid-angle"}},
                        {&RenderSettings::which_light, {"all", "one", "power", "contribution"}},
                        {&RenderSettings::roulette, {"albedo", "throughput", "off"}},
                        {&RenderSettings::filter, {"tent", "box", "gaussian", "blackman-harris"}},
                        {&RenderSettings::random, {"independent", "sobol", "stratified"}}};

// Of spheres by what is seen of them, of rectangles by solid angle: what each scene's lights are.
bool admits(const RenderSettings& settings) {
  const bool rectangles = view_of(settings).scene.luminaires()[0].is_rectangle;
  return settings.light_sampling == "area" || settings.direct == "none" ||
         rectangles == (settings.light_sampling == "solid-angle");
}

const std::string one_or_power = "one or power";

// The settings, where those that say the same for a scene are given the same: without shadow rays
// it does not matter which are asked for, of one luminaire there is no choice, and luminaires of
// equal power are chosen alike, to rounding.
RenderSettings what_is_said_by(RenderSettings settings, const std::vector<Luminaire>& luminaires) {
  const auto as_bright = [&](const Luminaire& light) { return power_of(light) == power_of(luminaires[0]); };
  if (settings.direct == "none") settings.light_sampling = settings.which_light = "";
  if (luminaires.size() == 1) settings.which_light = "";
  const bool is_even = settings.which_light == "one" || settings.which_light == "power";
  if (is_even && std::ranges::all_of(luminaires, as_bright)) settings.which_light = one_or_power;
  return settings;
}

// The films of all values of two strategies in a scene: the same where the settings say the same,
// and only there. Few paths find a light without shadow rays, so there are more samples where these
// may be left out.
void expect_each_pair_its_own(const RenderSettings& scene, std::size_t i, std::size_t j) {
  const std::vector<Luminaire> luminaires = view_of(scene).scene.luminaires();
  const auto same = [](const RenderSettings& a, const RenderSettings& b) {
    return std::ranges::all_of(strategies, [&](const auto& s) { return a.*s.first == b.*s.first; });
  };
  const bool may_leave_out = strategies[i].second[0] == "light" || strategies[j].second[0] == "light";
  std::vector<std::pair<RenderSettings, Film>> films;
  for (const std::string& a : strategies[i].second) {
    for (const std::string& b : strategies[j].second) {
      RenderSettings pair = scene;
      pair.*strategies[i].first = a;
      pair.*strategies[j].first = b;
      if (pair.roulette == "throughput") pair.roulette_depth = 2;
      const std::string name = scene.scene + " " + a + " " + b;
      if (!admits(pair)) {
        EXPECT_THROW(render(pair, 1), std::invalid_argument) << name;
        continue;
      }
      const RenderSettings said = what_is_said_by(pair, luminaires);
      const Film film = render(pair, may_leave_out ? 32 : 1);
      for (const auto& [other, film_of_other] : films) {
        if (same(said, other) && said.which_light == one_or_power) continue;
        EXPECT_EQ(film == film_of_other, same(said, other))
            << name << " and " << other.*strategies[i].first << " " << other.*strategies[j].first;
      }
      films.emplace_back(said, film);
    }
  }
  EXPECT_GE(films.size(), 4u);
}

// Every pair of strategies, in every scene that admits them.
TEST(StrategyPairs, AreTakenAtTheirWord) {
  for (const std::string& scene : scene_names()) {
    RenderSettings settings;
    settings.width = settings.height = 8;
    settings.scene = scene;
    settings.max_depth = 3;
    for (std::size_t i = 0; i < strategies.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) expect_each_pair_its_own(settings, i, j);
    }
  }
}

}  // namespace
}  // namespace fairlight
