#include <stdexcept>

#include <fairlight/render/strategies.h>
#include <fairlight/stats/text.h>

namespace fairlight {
namespace {

// The first bounce that roulette may end. By throughput it is the fifth, as in Mitsuba: the first
// bounces carry most of a picture.
int first_refused(const RenderSettings& settings) {
  if (settings.roulette_depth == -1) return settings.roulette == RouletteKind::throughput ? 5 : 1;
  if (settings.roulette == RouletteKind::off)
    throw std::invalid_argument(
        "without roulette there is no bounce for it to begin at (leave out --roulette-depth, or give --roulette)");
  if (settings.max_depth >= 0 && settings.roulette_depth > settings.max_depth)
    throw std::invalid_argument(
        "roulette would begin after the last bounce (leave out --roulette-depth, or give no more than "
        "--max-depth)");
  return settings.roulette_depth;
}

void check_ends(const Strategies& strategies) {
  if (strategies.max_depth >= 0) return;
  if (strategies.roulette == RouletteKind::off) {
    throw std::invalid_argument(formatted("without roulette a path need not end (give --max-depth, or %s)",
                                          option_with(RouletteKind::albedo).c_str()));
  }
  if (strategies.bounce == BounceSampling::uniform) {
    // With uniform sampling, a bounce multiplies the second moment by 4/3 rho^2/q: above 1 for rho
    // = q > 3/4.
    throw std::invalid_argument(
        "with uniform bounces the variance of endless paths is infinite (give --max-depth)");
  }
}

void check_numbers(const Strategies& strategies) {
  if (strategies.random != RandomNumbers::independent || strategies.points == 1) return;
  throw std::invalid_argument(formatted("independent numbers come in no sets of points (give %s or %s)",
                                        option_with(RandomNumbers::sobol).c_str(),
                                        name_of(RandomNumbers::stratified)));
}

bool admits(Scenes scenes, const Luminaire& light) {
  if (scenes == Scenes::with_sphere_lights) return !light.is_rectangle;
  if (scenes == Scenes::with_rectangle_lights) return light.is_rectangle;
  return true;
}

void check_lights(const Strategies& strategies, const std::vector<Luminaire>& lights) {
  if (row_of(strategies.direct).scenes == Scenes::any) return;  // no shadow rays
  if (lights.empty()) {
    throw std::invalid_argument(formatted("the scene has no luminaire to send shadow rays to (give %s)",
                                          option_with(DirectLighting::none).c_str()));
  }
  const StrategyRow<LightPoints>& sampling = row_of(strategies.light_sampling);
  for (const Luminaire& light : lights) {
    if (admits(sampling.scenes, light)) continue;
    throw std::invalid_argument(formatted("a luminaire that is a %s cannot be sampled by %s (give %s)",
                                          light.is_rectangle ? "rectangle" : "sphere", sampling.name,
                                          option_with(LightPoints::area).c_str()));
  }
}

}  // namespace

Strategies::Strategies(const RenderSettings& settings, const Scene& scene)
    : bounce(settings.bounce),
      direct(settings.direct),
      light_sampling(settings.light_sampling),
      which_light(settings.which_light),
      roulette(settings.roulette),
      roulette_depth(first_refused(settings)),
      filter(settings.filter),
      random(settings.random),
      points(SampleSets(settings.points).size()),
      max_depth(settings.max_depth) {
  check_ends(*this);
  check_numbers(*this);
  check_lights(*this, scene.luminaires());
}

}  // namespace fairlight
