#include <fairlight/validation/claims/lights_at_any_distance.h>
#include <fairlight/validation/faults/catalogue.h>
#include <fairlight/validation/faults/wrong_light_distances.h>

namespace fairlight {
namespace {

using Values = std::vector<double>;

template <template <class> class Wrong>
std::vector<Claim> near_rectangle(BoundOfLight by) {
  std::vector<Claim> claims;
  add_mean_over(claims, three_rectangles("RectangleByArea", rectangle_distances[0].ranges),
                [=](const Values& values) {
                  return irradiance_of_placed<Wrong>("rectangle.by_area.at_any_distance.near", "", by,
                                                     placed_rectangles(values), 6);
                });
  return claims;
}

// The rows of range `i` of the distances, by the visible hemisphere.
template <template <class> class Wrong>
std::vector<Claim> visible_sphere(std::size_t i, BoundOfLight by) {
  std::vector<Claim> claims;
  const auto [range, ranges] = sphere_distances(0.6)[i];
  const std::string name = std::string("sphere_light.by_visible.at_any_distance.") + range;
  add_mean_over(claims, three_spheres("SphereByVisibleHemisphere", ranges), [=](const Values& values) {
    return irradiance_of_placed<Wrong>(name, "", by, placed_spheres(ranges, values), 9);
  });
  return claims;
}

}  // namespace

// Faults at some distances alone. The bounds are those of the wrong draws where these are larger.
std::vector<Fault> light_domain_faults() {
  const auto area = BoundOfLight::area, half = BoundOfLight::half_of_area;
  return {{"rectangle-distance-floored", "epsilon", "the class of SORT #29",
           near_rectangle<faults::RectangleFloored>(area)},
          {"sphere-distance-floored", "epsilon", "the class of SORT #29",
           visible_sphere<faults::SphereFloored>(0, half)},
          {"sphere-squared-distance-floored", "epsilon", "the class of SORT #29",
           visible_sphere<faults::SphereSquareFloored>(0, half)},
          {"light-beyond-a-kilometre-unseen", "epsilon", "the class of SORT #29",
           visible_sphere<faults::SphereOfAKilometre>(2, half)},
          {"rectangle-one-sided", "axis", "the class of ByroRedux #3922",
           near_rectangle<faults::RectangleOneSided>(area)}};
}

}  // namespace fairlight
