#include <fairlight/validation/claims/placed_triangles.h>
#include <fairlight/validation/faults/catalogue.h>
#include <fairlight/validation/faults/wrong_triangles.h>

namespace fairlight {
namespace {

template <template <class> class Wrong>
std::vector<Claim> by_area() {
  std::vector<Claim> claims;
  add_mean_over(claims, three_triangles("TriangleByArea", triangle_distances[0].ranges),
                [](const std::vector<double>& values) {
                  return irradiance_of_placed<Wrong>("triangle.by_area.at_any_distance.near", "",
                                                     BoundOfLight::area, placed_triangles(values), 6);
                });
  return claims;
}

}  // namespace

std::vector<Fault> triangle_faults() {
  return {{"triangle-without-root", "measure", "the class of Smerity/montelight-cpp",
           by_area<faults::TriangleWithoutRoot>()},
          {"triangle-of-twice-the-area", "measure", "none: the cross product's length",
           by_area<faults::TriangleOfTwiceTheArea>()}};
}

}  // namespace fairlight
