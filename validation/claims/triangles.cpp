#include <fairlight/validation/claims/claims.h>
#include <fairlight/validation/claims/placed_triangles.h>

namespace fairlight {
namespace {

using Values = std::vector<double>;

template <template <class> class Strategy>
void add_triangle(std::vector<Claim>& claims, const std::string& family, const std::string& light,
                  BoundOfLight by) {
  for (const auto& [range, ranges] : triangle_distances) {
    add_mean_over(claims, three_triangles(light, ranges),
                  [=, name = family + ".at_any_distance." + range](const Values& values) {
                    return irradiance_of_placed<Strategy>(name, light, by, placed_triangles(values), 6);
                  });
  }
  add_mean_over(claims, three_triangles(light, large_triangles), [=](const Values& values) {
    return shared_irradiance_of_placed<Strategy>(family + ".shared", light, placed_triangles(values), 10);
  });
}

}  // namespace

void add_triangle_claims(std::vector<Claim>& claims) {
  add_triangle<TriangleByArea>(claims, "triangle.by_area", "TriangleByArea", BoundOfLight::area);
  add_triangle<TriangleBySolidAngle>(claims, "triangle.by_solid_angle", "TriangleBySolidAngle",
                                     BoundOfLight::solid_angle);
}

}  // namespace fairlight
