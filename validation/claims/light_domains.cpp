#include <fairlight/validation/claims/claims.h>
#include <fairlight/validation/claims/lights_at_any_distance.h>

namespace fairlight {
namespace {

using Values = std::vector<double>;

// Lights that many cosine-weighted directions meet.
constexpr std::array<RectangleRange, 3> large_rectangles{
    {{{1e-8, 1e-2}, {0.5, 2}, {0.2, 1}}, {{0.09, 10}, {0.5, 4}, {0.1, 1}}, {{1e2, 1e8}, {0.5, 2}, {0.2, 1}}}};
constexpr auto inside = PlaceAtSphere::inside, on_it = PlaceAtSphere::on_it;
constexpr std::array<SphereRange, 3> large_spheres{{{{1e-8, 1e-2}, {0.3, 0.9}, {0.05, 1}},
                                                    {{0.09, 10}, {0.3, 0.9}, {-0.3, 1}, PlaceAtSphere::cut},
                                                    {{1e2, 1e7}, {1.25, 100}, {-1, 1}, inside}}};
constexpr std::array<SphereRange, 3> around{{{{1e-8, 1e-2}, {1.25, 100}, {-1, 1}, inside},
                                             {{1e-2, 10}, {1.25, 100}, {-1, 1}, inside},
                                             {{10, 1e7}, {1.25, 100}, {-1, 1}, inside}}};
constexpr std::array<SphereRange, 3> touching{{{{1e-8, 1e-2}, {1, 1}, {-0.5, 1}, on_it},
                                               {{1e-2, 10}, {1, 1}, {-0.5, 1}, on_it},
                                               {{10, 1e9}, {1, 1}, {-0.5, 1}, on_it}}};
constexpr std::array<SphereRange, 3> nearly_touching{{{{1e-8, 1e-2}, {0.9, 0.999}, {-0.5, 1}},
                                                      {{1e-2, 10}, {0.9, 0.999}, {-0.5, 1}},
                                                      {{10, 1e9}, {0.9, 0.999}, {-0.5, 1}}}};

template <template <class> class Strategy>
void add_rectangle(std::vector<Claim>& claims, const std::string& family, const std::string& light,
                   BoundOfLight by) {
  for (const auto& [range, ranges] : rectangle_distances) {
    add_mean_over(claims, three_rectangles(light, ranges),
                  [=, name = family + ".at_any_distance." + range](const Values& values) {
                    return irradiance_of_placed<Strategy>(name, light, by, placed_rectangles(values), 6);
                  });
  }
  add_mean_over(claims, three_rectangles(light, large_rectangles), [=](const Values& values) {
    return shared_irradiance_of_placed<Strategy>(family + ".shared", light, placed_rectangles(values), 10);
  });
}

template <template <class> class Strategy>
void add_spheres(std::vector<Claim>& claims, const std::string& name, const std::string& light, BoundOfLight by,
                 const std::array<SphereRange, 3>& ranges, double margin_factor) {
  add_mean_over(claims, three_spheres(light, ranges), [=](const Values& values) {
    return irradiance_of_placed<Strategy>(name, light, by, placed_spheres(ranges, values), margin_factor);
  });
}

template <template <class> class Strategy>
void add_sphere(std::vector<Claim>& claims, const std::string& family, const std::string& light, BoundOfLight by) {
  for (const auto& [range, ranges] : sphere_distances(by == BoundOfLight::solid_angle ? 0.9 : 0.6))
    add_spheres<Strategy>(claims, family + ".at_any_distance." + range, light, by, ranges,
                          by == BoundOfLight::solid_angle ? 6 : 9);
  add_spheres<Strategy>(claims, family + ".around", light, by, around, 6);
  add_mean_over(claims, three_spheres(light, large_spheres), [=](const Values& values) {
    return shared_irradiance_of_placed<Strategy>(family + ".shared", light, placed_spheres(large_spheres, values),
                                                 10);
  });
}

template <class Real>
using ByArea = SphereByArea<Real>;
template <class Real>
using ByVisibleHemisphere = SphereByVisibleHemisphere<Real>;

}  // namespace

void add_light_domain_claims(std::vector<Claim>& claims) {
  add_rectangle<RectangleByArea>(claims, "rectangle.by_area", "RectangleByArea", BoundOfLight::area);
  add_rectangle<RectangleBySolidAngle>(claims, "rectangle.by_solid_angle", "RectangleBySolidAngle",
                                       BoundOfLight::solid_angle);
  add_mean_over(claims, three_near_planes("RectangleBySolidAngle"), [](const Values& values) {
    return irradiance_of_placed<RectangleBySolidAngle>("rectangle.by_solid_angle.near_plane",
                                                       "RectangleBySolidAngle", BoundOfLight::solid_angle,
                                                       placed_near_planes(values), 6);
  });
  add_sphere<ByArea>(claims, "sphere_light.by_area", "SphereByArea", BoundOfLight::area);
  add_sphere<ByVisibleHemisphere>(claims, "sphere_light.by_visible", "SphereByVisibleHemisphere",
                                  BoundOfLight::half_of_area);
  add_sphere<SphereByCone>(claims, "sphere_light.by_cone", "SphereByCone", BoundOfLight::solid_angle);
  add_spheres<SphereByCone>(claims, "sphere_light.by_cone.on_it", "SphereByCone", BoundOfLight::solid_angle,
                            touching, 6);
  add_spheres<SphereByCone>(claims, "sphere_light.by_cone.nearly_touching", "SphereByCone",
                            BoundOfLight::solid_angle, nearly_touching, 6);
}

}  // namespace fairlight
