#include <array>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <fairlight/render/strategies.h>

namespace fairlight {
namespace {

template <class Strategy, std::size_t n>
Strategy named(const char* what, const std::string& value,
               const std::array<std::pair<std::string_view, Strategy>, n>& all) {
  for (const auto& [name, strategy] : all) {
    if (name == value) return strategy;
  }
  throw std::invalid_argument(std::string("there is no ") + what + " \"" + value +
                              "\" (see fairlight render --help)");
}

template <class Strategy, class... Pairs>
Strategy choose(const char* what, const std::string& value, Pairs... all) {
  return named<Strategy>(what, value, std::array{std::pair<std::string_view, Strategy>(all)...});
}

// The first bounce that roulette may end. By throughput it is the fifth, as in Mitsuba: the first
// bounces carry most of a picture.
int first_refused(const RenderSettings& settings) {
  if (settings.roulette_depth == -1) return settings.roulette == "throughput" ? 5 : 1;
  if (settings.roulette == "off")
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
  if (strategies.roulette == Strategies::Roulette::off) {
    throw std::invalid_argument("without roulette a path need not end (give --max-depth, or --roulette albedo)");
  }
  if (strategies.bounce == Strategies::Bounce::uniform) {
    // With uniform sampling, a bounce multiplies the second moment by 4/3 rho^2/q: above 1 for rho
    // = q > 3/4.
    throw std::invalid_argument(
        "with uniform bounces the variance of endless paths is infinite (give --max-depth)");
  }
}

void check_lights(const Strategies& strategies, const std::string& name, const Scene& scene) {
  if (strategies.direct == Strategies::Direct::none) return;
  if (scene.luminaires().empty()) {
    throw std::invalid_argument("the scene has no luminaire to send shadow rays to (give --direct none)");
  }
  const bool of_rectangles = strategies.light_sampling == Strategies::LightSampling::solid_angle;
  if (strategies.light_sampling == Strategies::LightSampling::area) return;
  for (const Luminaire& light : scene.luminaires()) {
    if (light.is_rectangle == of_rectangles) continue;
    throw std::invalid_argument("a luminaire that is a " +
                                std::string(light.is_rectangle ? "rectangle" : "sphere") +
                                " cannot be sampled by " + name + " (give --light-sampling area)");
  }
}

}  // namespace

Strategies::Strategies(const RenderSettings& settings, const Scene& scene)
    : bounce(choose<Bounce>("bounce", settings.bounce, std::pair("cosine", Bounce::cosine),
                            std::pair("uniform", Bounce::uniform))),
      direct(choose<Direct>("direct light", settings.direct, std::pair("light", Direct::light),
                            std::pair("none", Direct::none), std::pair("mis", Direct::mis))),
      light_sampling(choose<LightSampling>(
          "light sampling", settings.light_sampling, std::pair("area", LightSampling::area),
          std::pair("visible", LightSampling::visible), std::pair("cone", LightSampling::cone),
          std::pair("solid-angle", LightSampling::solid_angle))),
      which_light(choose<WhichLight>("choice of light", settings.which_light, std::pair("all", WhichLight::all),
                                     std::pair("one", WhichLight::one), std::pair("power", WhichLight::power),
                                     std::pair("contribution", WhichLight::contribution))),
      roulette(choose<Roulette>("roulette", settings.roulette, std::pair("albedo", Roulette::albedo),
                                std::pair("throughput", Roulette::throughput), std::pair("off", Roulette::off))),
      roulette_depth(first_refused(settings)),
      filter(choose<Filter>("filter", settings.filter, std::pair("tent", Filter::tent),
                            std::pair("box", Filter::box), std::pair("gaussian", Filter::gaussian),
                            std::pair("blackman-harris", Filter::blackman_harris))),
      random(choose<Random>("kind of random numbers", settings.random,
                            std::pair("independent", Random::independent), std::pair("sobol", Random::sobol),
                            std::pair("stratified", Random::stratified))),
      points(SampleSets(settings.points).size()),
      max_depth(settings.max_depth) {
  check_ends(*this);
  if (random == Random::independent && points != 1)
    throw std::invalid_argument(
        "independent numbers come in no sets of points (give --random sobol or stratified)");
  check_lights(*this, settings.light_sampling, scene);
}

}  // namespace fairlight
