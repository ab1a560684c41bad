#include <fairlight/validation/claims/claims.h>
#include <fairlight/validation/claims/combinator_agreements.h>
#include <fairlight/validation/claims/furnace.h>
#include <fairlight/validation/claims/sphere_over_plane.h>

namespace fairlight {

namespace {

template <class Direct, class Roulette, template <class> class Directions = CosineHemisphere>
using Tracer = PathTracer<BouncesBy<Directions>, Direct, Roulette>;
using ByCone = PointsBy<SphereByCone>;
using All = DirectLight<AllLights>;
using One = DirectLight<UniformLightSampler>;
using AllVisible = DirectLight<AllLights, PointsBy<SphereByVisibleHemisphere>>;
using AllByCone = DirectLight<AllLights, ByCone>;
using OneByCone = DirectLight<UniformLightSampler, ByCone>;
using ContributionByCone = DirectLight<ContributionLightSampler, ByCone>;
using Roulette = RouletteByReflectance<>;

// One luminaire, picked by its power, with the table in Real.
template <class Roulette>
auto by_power(const Scene& scene, int max_depth) {
  return [=]<class Real>(std::type_identity<Real>) {
    using Direct = DirectLight<LightSampler<PowerChoice<Real>>, ByCone>;
    return Tracer<Direct, Roulette>(max_depth, Direct(one_by_power<Real>(scene)));
  };
}

void add_furnaces(std::vector<Claim>& claims) {
  const auto add = [&](const auto& experiment) { add_independent_mean(claims, experiment); };
  add(furnace_radiance<Tracer<NoDirectLight, Roulette>>("furnace.bounce",
                                                        {"PathTracer", "NoDirectLight", "RouletteByReflectance"}));
  add(furnace_radiance<Tracer<NoDirectLight, Roulette>>(
      "furnace.tiny.bounce", {"PathTracer", "NoDirectLight", "RouletteByReflectance"}, 5, Furnace(1e-3)));
  add(mirror_in_furnace<All>("light", {"PathTracer", "DirectLight", "Mirror"}));
  add(mirror_in_furnace<DirectLight<AllLights, ByCone, MisWeighted<>>>(
      "shared", {"PathTracer", "DirectLight", "Mirror", "BalanceHeuristic"}));
  add(furnace_radiance<Tracer<All, Roulette>>("furnace.light",
                                              {"PathTracer", "DirectLight", "RouletteByReflectance"}, 2));
  add(two_spheres("furnace.two_spheres.all", {"PathTracer", "DirectLight", "AllLights", "RouletteByReflectance"},
                  12.25, always(Tracer<All, Roulette>())));
  add(two_spheres("furnace.two_spheres.one",
                  {"PathTracer", "DirectLight", "UniformLightSampler", "RouletteByReflectance"}, 24.5,
                  always(Tracer<One, Roulette>())));
  add(two_spheres("furnace.two_spheres.cone", {"PathTracer", "DirectLight", "AllLights", "SphereByCone"}, 4.1,
                  always(Tracer<AllByCone, Roulette>())));
  add(two_spheres("furnace.two_spheres.power",
                  {"PathTracer", "DirectLight", "LightSampler", "PowerChoice", "SphereByCone"}, 4.1,
                  by_power<Roulette>(furnace_with_another().scene, -1)));
  add(furnace_partial_sum<Tracer<NoDirectLight, NoRoulette, UniformHemisphere>>(
      "furnace.depth3.uniform", {"PathTracer", "NoRoulette", "UniformHemisphere"}, 3, 2));
  add(furnace_partial_sum<Tracer<All, NoRoulette, UniformHemisphere>>(
      "furnace.depth3.light", {"PathTracer", "NoRoulette", "DirectLight"}, 3, 2));
  add(furnace_partial_sum<Tracer<AllByCone, NoRoulette>>(
      "furnace.depth3.cone", {"PathTracer", "NoRoulette", "DirectLight", "SphereByCone"}, 3, 2));
}

void add_one_light(std::vector<Claim>& claims) {
  const auto terms = [](const SpheresOverPlane& s, int c) { return s.sum_of_terms(c); };
  const auto half_terms = [](const SpheresOverPlane& s, int c) { return s.sum_of_terms(c) / 2; };
  const auto cone_terms = [](const SpheresOverPlane& s, int c) { return s.sum_of_cone_terms(c); };
  const auto cosine_hit = [](const SpheresOverPlane& s, int c) { return s.albedo[c] * s.largest_radiance(c); };
  const auto uniform_hit = [=](const SpheresOverPlane& s, int c) { return 2 * cosine_hit(s, c); };
  const auto add = [&](const auto& experiment) { add_independent_mean(claims, experiment); };
  add(floor_radiance<Tracer<All, NoRoulette>>("sphere_over_plane.light",
                                              {"DirectLight", "PointsBy", "SphereByArea", "UniformSphereArea"},
                                              one_light(), 2, terms));
  add(floor_radiance<Tracer<AllVisible, NoRoulette>>(
      "sphere_over_plane.visible", {"DirectLight", "SphereByVisibleHemisphere"}, one_light(), 1, half_terms));
  add(floor_radiance<Tracer<AllByCone, NoRoulette>>("sphere_over_plane.cone", {"DirectLight", "SphereByCone"},
                                                    large_light(), 1, cone_terms));
  add(floor_radiance<Tracer<NoDirectLight, NoRoulette>>(
      "sphere_over_plane.cosine", {"NoDirectLight", "CosineHemisphere"}, large_light(), 2, cosine_hit));
  add(floor_radiance<Tracer<NoDirectLight, NoRoulette, UniformHemisphere>>(
      "sphere_over_plane.uniform", {"NoDirectLight", "UniformHemisphere"}, large_light(), 2, uniform_hit));
  add(shared_light());
}

// The choice of one of two lights, each by cone, so that most of the variance comes from the
// choice.
void add_two_lights(std::vector<Claim>& claims) {
  const auto all_terms = [](const SpheresOverPlane& s, int c) { return s.sum_of_cone_terms(c); };
  // The largest term over its probability, where a light is picked in proportion to its weight.
  const auto picked_by = [](const auto& weight) {
    return [=](const SpheresOverPlane& s, int c) {
      double total = 0, largest = 0;
      for (const auto& light : s.lights) total += weight(light);
      for (const auto& light : s.lights) largest = std::max(largest, s.largest_cone_term(light, c) / weight(light));
      return largest * total;
    };
  };
  using Light = SpheresOverPlane::Light;
  const auto power = [](const Light& light) { return light.radius * light.radius * light.radiance.sum(); };
  const auto contribution = [=](const Light& light) { return power(light) / light.centre.squaredNorm(); };
  const auto add = [&](const auto& experiment) { add_independent_mean(claims, experiment); };
  add(floor_radiance<Tracer<AllByCone, NoRoulette>>("two_lights.all", {"DirectLight", "AllLights"}, two_lights(), 1,
                                                    all_terms));
  add(floor_radiance<Tracer<OneByCone, NoRoulette>>("two_lights.one", {"DirectLight", "UniformLightSampler"},
                                                    two_lights(), 1, picked_by([](const Light&) { return 1.0; })));
  add(floor_radiance("two_lights.power", {"DirectLight", "LightSampler", "PowerChoice"}, two_lights(), 1,
                     picked_by(power), by_power<NoRoulette>(two_lights().scene, 1)));
  add(floor_radiance<Tracer<ContributionByCone, NoRoulette>>(
      "two_lights.contribution", {"DirectLight", "ContributionLightSampler", "ContributionChoice"}, two_lights(), 1,
      picked_by(contribution)));
  add(shared_lights());
}

void add_agreements(std::vector<Claim>& claims) {
  add_independent_mean(claims, one_against_all<Tracer<OneByCone, NoRoulette>, Tracer<AllByCone, NoRoulette>>(
                                   "two_lights.one_against_all"));
  add_independent_mean(claims,
                       roulette_on_against_off<Tracer<All, Roulette>, Tracer<All, NoRoulette>>("cornell.roulette"));
}

}  // namespace

void add_scene_claims(std::vector<Claim>& claims) {
  add_furnaces(claims);
  add_one_light(claims);
  add_two_lights(claims);
  add_agreements(claims);
}

}  // namespace fairlight
