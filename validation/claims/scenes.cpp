#include <fairlight/validation/agreements.h>
#include <fairlight/validation/analytic/furnace.h>
#include <fairlight/validation/analytic/sphere_over_plane.h>
#include <fairlight/validation/claims/claims.h>

namespace fairlight {

namespace {

template <class Direct, class Roulette, template <class> class Directions = CosineHemisphere>
using Tracer = PathTracer<Directions, Direct, Roulette>;
using All = DirectLight<AllOf>;
using One = DirectLight<OneOf>;
using AllVisible = DirectLight<AllOf, SphereByVisibleHemisphere>;
using AllByCone = DirectLight<AllOf, SphereByCone>;
using OneByCone = DirectLight<OneOf, SphereByCone>;
using PowerByCone = DirectLight<OneBy<PowerChoice<double>>, SphereByCone>;
using Roulette = RouletteByReflectance<>;

void add_furnaces(std::vector<Claim>& claims) {
  claims.push_back(furnace_claim<Tracer<NoDirectLight, Roulette>>(
      "furnace.bounce", {"PathTracer", "NoDirectLight", "RouletteByReflectance"}));
  claims.push_back(furnace_claim<Tracer<All, Roulette>>("furnace.light",
                                                        {"PathTracer", "DirectLight", "RouletteByReflectance"}, 2));
  claims.push_back(two_spheres_claim<Tracer<All, Roulette>>(
      "furnace.two_spheres.all", {"PathTracer", "DirectLight", "AllOf", "RouletteByReflectance"}));
  claims.push_back(two_spheres_claim<Tracer<One, Roulette>>(
      "furnace.two_spheres.one", {"PathTracer", "DirectLight", "OneOf", "RouletteByReflectance"}));
  claims.push_back(two_spheres_claim<Tracer<AllByCone, Roulette>>(
      "furnace.two_spheres.cone", {"PathTracer", "DirectLight", "AllOf", "SphereByCone"}, 8));
  const OneBy by_power = one_by_power(furnace_with_another().scene);
  claims.push_back(two_spheres_claim("furnace.two_spheres.power",
                                     {"PathTracer", "DirectLight", "OneBy", "PowerChoice", "SphereByCone"}, 8,
                                     Tracer<PowerByCone, Roulette>(-1, PowerByCone(by_power))));
  claims.push_back(furnace_partial_sum<Tracer<NoDirectLight, NoRoulette, UniformHemisphere>>(
      "furnace.depth3.uniform", {"PathTracer", "NoRoulette", "UniformHemisphere"}, 3, 2));
  claims.push_back(furnace_partial_sum<Tracer<All, NoRoulette, UniformHemisphere>>(
      "furnace.depth3.light", {"PathTracer", "NoRoulette", "DirectLight"}, 3, 2));
  claims.push_back(furnace_partial_sum<Tracer<AllByCone, NoRoulette>>(
      "furnace.depth3.cone", {"PathTracer", "NoRoulette", "DirectLight", "SphereByCone"}, 3, 2));
}

void add_one_light(std::vector<Claim>& claims) {
  const auto terms = [](const SpheresOverPlane& s, int c) { return s.sum_of_terms(c); };
  const auto half_terms = [](const SpheresOverPlane& s, int c) { return s.sum_of_terms(c) / 2; };
  const auto cone_terms = [](const SpheresOverPlane& s, int c) { return s.sum_of_cone_terms(c); };
  const auto cosine_hit = [](const SpheresOverPlane& s, int c) { return s.albedo[c] * s.largest_radiance(c); };
  const auto uniform_hit = [=](const SpheresOverPlane& s, int c) { return 2 * cosine_hit(s, c); };
  claims.push_back(floor_claim<Tracer<All, NoRoulette>>(
      "sphere_over_plane.light", {"DirectLight", "SphereByArea", "UniformSphereArea"}, one_light(), 2, terms));
  claims.push_back(floor_claim<Tracer<AllVisible, NoRoulette>>(
      "sphere_over_plane.visible", {"DirectLight", "SphereByVisibleHemisphere"}, one_light(), 1, half_terms));
  claims.push_back(floor_claim<Tracer<AllByCone, NoRoulette>>(
      "sphere_over_plane.cone", {"DirectLight", "SphereByCone"}, large_light(), 1, cone_terms));
  claims.push_back(floor_claim<Tracer<NoDirectLight, NoRoulette>>(
      "sphere_over_plane.cosine", {"NoDirectLight", "CosineHemisphere"}, large_light(), 2, cosine_hit));
  claims.push_back(floor_claim<Tracer<NoDirectLight, NoRoulette, UniformHemisphere>>(
      "sphere_over_plane.uniform", {"NoDirectLight", "UniformHemisphere"}, large_light(), 2, uniform_hit));
}

// Which of two lights, each by cone: what is drawn is then nearly the choice alone.
void add_two_lights(std::vector<Claim>& claims) {
  const auto all_terms = [](const SpheresOverPlane& s, int c) { return s.sum_of_cone_terms(c); };
  const auto one_term = [](const SpheresOverPlane& s, int c) {
    double largest = 0;
    for (const auto& light : s.lights) largest = std::max(largest, s.largest_cone_term(light, c));
    return static_cast<double>(s.lights.size()) * largest;
  };
  // The power of a light is in proportion to r^2 times the sum of its radiance's channels.
  const auto power_term = [](const SpheresOverPlane& s, int c) {
    const auto power = [](const auto& light) { return light.radius * light.radius * light.radiance.sum(); };
    double total = 0;
    for (const auto& light : s.lights) total += power(light);
    double largest = 0;
    for (const auto& light : s.lights) {
      largest = std::max(largest, s.largest_cone_term(light, c) / power(light) * total);
    }
    return largest;
  };
  claims.push_back(floor_claim<Tracer<AllByCone, NoRoulette>>("two_lights.all", {"DirectLight", "AllOf"},
                                                              two_lights(), 1, all_terms));
  claims.push_back(floor_claim<Tracer<OneByCone, NoRoulette>>("two_lights.one", {"DirectLight", "OneOf"},
                                                              two_lights(), 1, one_term));
  const OneBy by_power = one_by_power(two_lights().scene);
  claims.push_back(floor_claim("two_lights.power", {"DirectLight", "OneBy", "PowerChoice"}, two_lights(), 1,
                               power_term, Tracer<PowerByCone, NoRoulette>(1, PowerByCone(by_power))));
}

void add_agreements(std::vector<Claim>& claims) {
  claims.push_back(
      one_against_all<Tracer<OneByCone, NoRoulette>, Tracer<AllByCone, NoRoulette>>("two_lights.one_against_all"));
  claims.push_back(roulette_on_against_off<Tracer<All, Roulette>, Tracer<All, NoRoulette>>("cornell.roulette"));
}

}  // namespace

void add_scene_claims(std::vector<Claim>& claims) {
  add_furnaces(claims);
  add_one_light(claims);
  add_two_lights(claims);
  add_agreements(claims);
}

}  // namespace fairlight
