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
using Roulette = RouletteByReflectance<>;

void add_furnaces(std::vector<Claim>& claims) {
  claims.push_back(furnace_claim<Tracer<NoDirectLight, Roulette>>(
      "furnace.bounce", {"PathTracer", "NoDirectLight", "RouletteByReflectance"}));
  claims.push_back(furnace_claim<Tracer<All, Roulette>>("furnace.light",
                                                        {"PathTracer", "DirectLight", "RouletteByReflectance"}));
  claims.push_back(two_spheres_claim<Tracer<All, Roulette>>(
      "furnace.two_spheres.all", {"PathTracer", "DirectLight", "AllOf", "RouletteByReflectance"}));
  claims.push_back(two_spheres_claim<Tracer<One, Roulette>>(
      "furnace.two_spheres.one", {"PathTracer", "DirectLight", "OneOf", "RouletteByReflectance"}));
  claims.push_back(furnace_partial_sum<Tracer<NoDirectLight, NoRoulette, UniformHemisphere>>(
      "furnace.depth3.uniform", {"PathTracer", "NoRoulette", "UniformHemisphere"}, 3, 2));
  claims.push_back(furnace_partial_sum<Tracer<All, NoRoulette, UniformHemisphere>>(
      "furnace.depth3.light", {"PathTracer", "NoRoulette", "DirectLight"}, 3, 2));
}

void add_direct_light(std::vector<Claim>& claims) {
  const auto all_terms = [](const SpheresOverPlane& s, int c) { return s.sum_of_terms(c); };
  const auto one_term = [](const SpheresOverPlane& s, int c) {
    double largest = 0;
    for (const auto& light : s.lights) largest = std::max(largest, s.largest_term(light, c));
    return static_cast<double>(s.lights.size()) * largest;
  };
  const auto cosine_hit = [](const SpheresOverPlane& s, int c) { return s.albedo[c] * s.largest_radiance(c); };
  const auto uniform_hit = [=](const SpheresOverPlane& s, int c) { return 2 * cosine_hit(s, c); };
  claims.push_back(floor_claim<Tracer<All, NoRoulette>>(
      "sphere_over_plane.light", {"DirectLight", "UniformSphereArea"}, one_light(), 1, all_terms));
  claims.push_back(floor_claim<Tracer<NoDirectLight, NoRoulette>>(
      "sphere_over_plane.cosine", {"NoDirectLight", "CosineHemisphere"}, large_light(), 2, cosine_hit));
  claims.push_back(floor_claim<Tracer<NoDirectLight, NoRoulette, UniformHemisphere>>(
      "sphere_over_plane.uniform", {"NoDirectLight", "UniformHemisphere"}, large_light(), 2, uniform_hit));
  claims.push_back(
      floor_claim<Tracer<All, NoRoulette>>("two_lights.all", {"DirectLight", "AllOf"}, two_lights(), 1, all_terms));
  claims.push_back(
      floor_claim<Tracer<One, NoRoulette>>("two_lights.one", {"DirectLight", "OneOf"}, two_lights(), 1, one_term));
}

void add_agreements(std::vector<Claim>& claims) {
  claims.push_back(one_against_all<Tracer<One, NoRoulette>, Tracer<All, NoRoulette>>("two_lights.one_against_all"));
  claims.push_back(roulette_on_against_off<Tracer<All, Roulette>, Tracer<All, NoRoulette>>("cornell.roulette"));
}

}  // namespace

void add_scene_claims(std::vector<Claim>& claims) {
  add_furnaces(claims);
  add_direct_light(claims);
  add_agreements(claims);
}

}  // namespace fairlight
