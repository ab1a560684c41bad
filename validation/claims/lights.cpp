#include <fairlight/estimators/environment.h>
#include <fairlight/validation/claims/claims.h>
#include <fairlight/validation/claims/lights.h>
#include <fairlight/validation/claims/picks.h>

namespace fairlight {
namespace {

template <class Real>
using ByArea = SphereByArea<Real>;
template <class Real>
using ByVisibleHemisphere = SphereByVisibleHemisphere<Real>;

constexpr double tau = 2 * std::numbers::pi;
Vec3<double> up() { return {0, 0, 1}; }
Vec3<double> aside() { return {1, 0, 0}; }

// Inside a sphere, with its centre above the origin, the density by area is a smooth function of
// the height of a direction.
void add_laws(std::vector<Claim>& claims) {
  const SphereFromOrigin around{{0, 0, 0.5}, 2};
  const SphereFromOrigin touching{{0, 0, 2}, 2, true};
  add_law(claims, sphere_area_law<UniformSphereArea>());
  const auto inside = [&](const auto& law) {
    claims.push_back(law_claim(law));
    claims.push_back(density_claim(law));
  };
  inside(sphere_direction_law<ByArea>("sphere_light.by_area.inside", "SphereByArea", around, SphereDomain{1}));
  inside(
      sphere_direction_law<SphereByCone>("sphere_light.by_cone.inside", "SphereByCone", around, SphereDomain{1}));
  add_law(claims, sphere_direction_law<SphereByCone>("sphere_light.by_cone.surface", "SphereByCone", touching,
                                                     HemisphereDomain{}));
}

// 1/p is at most the area over the square of the least distance, or the solid angle. The spheres
// sampled by area are far away, as most points of near ones face away.
void add_spheres(std::vector<Claim>& claims) {
  const SphereFromOrigin far{{3, 4, 12}, 1};
  const SphereFromOrigin near{{1, 2, 2.5}, 2};
  const SphereFromOrigin cut{{12, 0.5, 0.9}, 1};
  const SphereFromOrigin cut_near{{3, 0.5, 1.75}, 2};
  const SphereFromOrigin touching{{0, 0, 2}, 2, true};
  const auto add = [&]<template <class> class Strategy>(const std::string& name, const std::string& subject,
                                                        const SphereFromOrigin& sphere, double largest) {
    add_mean(claims, sphere_irradiance_claim<Strategy>(name, subject, sphere, up(), largest));
  };
  add.operator()<ByArea>("sphere_light.by_area.above", "SphereByArea", far, far.area_bound());
  add.operator()<ByArea>("sphere_light.by_area.touching", "SphereByArea", touching, 2 * tau);
  add.operator()<ByVisibleHemisphere>("sphere_light.by_visible.above", "SphereByVisibleHemisphere", far,
                                      far.area_bound() / 2);
  add.operator()<ByVisibleHemisphere>("sphere_light.by_visible.horizon", "SphereByVisibleHemisphere", cut,
                                      cut.area_bound() / 2);
  add.operator()<SphereByCone>("sphere_light.by_cone.above", "SphereByCone", near, near.cone_bound());
  add.operator()<SphereByCone>("sphere_light.by_cone.horizon", "SphereByCone", cut_near, cut_near.cone_bound());
  add.operator()<SphereByCone>("sphere_light.by_cone.touching", "SphereByCone", touching, tau);
}

void add_enclosing_spheres(std::vector<Claim>& claims) {
  const SphereFromOrigin around{{0.25, -0.5, 0.25}, 2};
  const Vec3<double> slanted(0.48, -0.6, 0.64);
  add_mean(claims, enclosed_irradiance_claim<ByArea>("sphere_light.by_area.within", "SphereByArea", around, slanted,
                                                     around.area_bound()));
  add_mean(claims, enclosed_irradiance_claim<ByVisibleHemisphere>("sphere_light.by_visible.within",
                                                                  "SphereByVisibleHemisphere", around, slanted,
                                                                  around.area_bound()));
  add_mean(claims, enclosed_irradiance_claim<SphereByCone>("sphere_light.by_cone.within", "SphereByCone", around,
                                                           slanted, 2 * tau));
}

void add_rectangles(std::vector<Claim>& claims) {
  const RectangleFromOrigin above{{-0.5, 0.25, 1.5}, 2, 1.5};
  const RectangleFromOrigin beside{{0.5, -0.5, 1}, 1.5, 2};
  add_mean(claims, rectangle_irradiance_claim<RectangleByArea>("rectangle.by_area.parallel", "RectangleByArea",
                                                               above, up(), above.area_bound()));
  add_mean(claims, rectangle_irradiance_claim<RectangleByArea>("rectangle.by_area.perpendicular", "RectangleByArea",
                                                               beside, aside(), beside.area_bound()));
  add_mean(claims, rectangle_solid_angle_claim<RectangleByArea>("rectangle.by_area.solid_angle", "RectangleByArea",
                                                                beside, beside.area_bound()));
  add_mean(claims,
           rectangle_irradiance_claim<RectangleBySolidAngle>(
               "rectangle.by_solid_angle.parallel", "RectangleBySolidAngle", above, up(), above.solid_angle()));
  add_mean(claims, rectangle_irradiance_claim<RectangleBySolidAngle>("rectangle.by_solid_angle.perpendicular",
                                                                     "RectangleBySolidAngle", beside, aside(),
                                                                     beside.solid_angle()));
  const LawEstimand points{"rectangle.by_solid_angle", "RectangleBySolidAngle", "Urena, Fajardo, King 2013",
                           [=]<class Real>(std::type_identity<Real>) { return RectanglePoints(beside); },
                           SquareDomain{0, 1}};
  claims.push_back(law_claim(points));
  claims.push_back(law_moments_claim(points));
}

void add_environment(std::vector<Claim>& claims) {
  const auto make = component<ConstantEnvironment>();
  add_mean(claims, irradiance("environment.irradiance", "ConstantEnvironment",
                              "under a constant environment of unit radiance the irradiance is pi on either face",
                              "elementary", make, Vec3<double>(0.48, -0.6, 0.64), Faces::both, tau, 2 * tau));
  const auto directions = []<class Real>(std::type_identity<Real>) {
    return DirectionsFrom<ConstantEnvironment<Real>>{{}, rounded_vector<Real>({1, 2, 3})};
  };
  add_law(claims,
          LawEstimand{"environment.constant", "ConstantEnvironment", "Archimedes", directions, SphereDomain{1}});
}

void add_picks(std::vector<Claim>& claims) {
  for (const int n : {1, 2, 1000, 100'000}) {
    const std::string among = std::string(".").append(std::to_string(n));
    const ManyLights lights(n, 0.5);
    add_mean(claims, sum_by_number("pick.one" + among, lights));
    add_mean(claims, sum_by_power<PowerChoice>("pick.power" + among, lights, lights.largest_by_power()));
    if (n <= 1000) {
      add_mean(claims, sum_by_contribution("pick.contribution" + among, ManyLights(n, 0.05), 0.05, 1));
    }
  }
  // No point sets: these need a number for each light, more than a point set has dimensions.
  add_mean(claims, sum_of_all("pick.all.2", ManyLights(2, 0.5)));
  claims.push_back(mean_claim<double>(sum_of_all("pick.all.1000", ManyLights(1000, 0.5))));
  claims.push_back(mean_claim<Packet>(sum_of_all("pick.all.1000", ManyLights(1000, 0.5))));
  // Every pick evaluates all lights, so there are few picks, and no point sets.
  const auto many = sum_by_contribution("pick.contribution.100000", ManyLights(100'000, 0.005), 0.005, 4);
  claims.push_back(mean_claim<double>(many));
  claims.push_back(mean_claim<Packet>(many));
}

}  // namespace

void add_light_claims(std::vector<Claim>& claims) {
  add_laws(claims);
  add_spheres(claims);
  add_enclosing_spheres(claims);
  add_rectangles(claims);
  add_environment(claims);
  add_picks(claims);
}

}  // namespace fairlight
