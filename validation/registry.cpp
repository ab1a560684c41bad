#include <stdexcept>

#include <fnmatch.h>

#include <fairlight/estimators/filter.h>
#include <fairlight/validation/agreements.h>
#include <fairlight/validation/analytic/furnace.h>
#include <fairlight/validation/analytic/integrals.h>
#include <fairlight/validation/analytic/sphere_over_plane.h>
#include <fairlight/validation/laws.h>
#include <fairlight/validation/registry.h>

namespace fairlight {
namespace {

template <class Direct, class Roulette, template <class> class Directions = CosineHemisphere>
using Tracer = PathTracer<Directions, Direct, Roulette>;
using All = DirectLight<AllOf>;
using One = DirectLight<OneOf>;
using Roulette = RouletteByReflectance<>;

void add_laws(std::vector<Claim>& claims) {
  add_law(claims, LawExperiment{"stream.philox", "PhiloxStream", "Salmon et al. 2011",
                                []<class Real>(std::type_identity<Real>) { return StreamPairs<Real>{}; },
                                SquareDomain{0, 1}});
  add_law(claims, LawExperiment{"hemisphere.uniform", "UniformHemisphere", "PBR 4ed, A.5.2",
                                []<class Real>(std::type_identity<Real>) { return UniformHemisphere<Real>{}; },
                                HemisphereDomain{}});
  add_law(claims, cosine_law<CosineHemisphere>());
  add_law(claims, sphere_area_law<UniformSphereArea>());
  add_law(claims, LawExperiment{"filter.tent", "TentFilter", "Ernst, Stamminger, Greiner 2006",
                                []<class Real>(std::type_identity<Real>) { return TentFilter<Real>{}; },
                                SquareDomain{-1, 1}});
}

void add_components(std::vector<Claim>& claims) {
  constexpr double tau = 2 * std::numbers::pi;
  add_mean(claims,
           hemisphere_integral<UniformHemisphere>("importance.uniform.cosine", "UniformHemisphere", 1, tau));
  add_mean(claims, hemisphere_integral<CosineHemisphere>("importance.cosine.cosine_squared", "CosineHemisphere", 2,
                                                         tau / 2));
  add_mean(claims, lambertian_albedo<UniformHemisphere>("lambertian.uniform.albedo", "UniformHemisphere"));
  claims.push_back(lambertian_constant<double>());
  claims.push_back(lambertian_constant<Packet>());
  add_mean(claims, roulette_integral<RussianRoulette>("roulette.integral", 0.3));
  add_mean(claims, two_dice<AllOf>("pick.all.dice", {"AllOf"}));
  add_mean(claims, two_dice<OneOf>("pick.one.dice", {"OneOf", "UniformChoice"}));
}

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

std::vector<Claim> build() {
  std::vector<Claim> claims;
  add_laws(claims);
  add_components(claims);
  add_furnaces(claims);
  add_direct_light(claims);
  add_agreements(claims);
  return claims;
}

bool matches(const std::string& pattern, const std::string& name) {
  return fnmatch(pattern.c_str(), name.c_str(), 0) == 0 || name.starts_with(pattern + ".");
}

}  // namespace

const std::vector<Claim>& registry() {
  static const std::vector<Claim> claims = build();
  return claims;
}

std::vector<const Claim*> select_claims(const std::vector<std::string>& patterns) {
  std::vector<bool> chosen(registry().size(), patterns.empty());
  for (const std::string& pattern : patterns) {
    bool found = false;
    for (std::size_t i = 0; i < registry().size(); ++i) {
      if (!matches(pattern, registry()[i].name)) continue;
      chosen[i] = found = true;
    }
    if (found) continue;
    std::string known;
    for (const Claim& claim : registry()) known += " " + claim.name;
    throw std::invalid_argument("no claim matches \"" + pattern + "\" (there are:" + known + ")");
  }
  std::vector<const Claim*> claims;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    if (chosen[i]) claims.push_back(&registry()[i]);
  }
  return claims;
}

}  // namespace fairlight
