#include <cmath>
#include <vector>

#include <fairlight/validation/studies/scenes.h>

namespace fairlight {
namespace {

constexpr double paper_radius = 1.5, paper_radiance = 400;

}  // namespace

View dark_box() {
  const View box = cornell_simple();
  Scene scene;
  for (const Surface& surface : box.scene.surfaces()) {
    const Sphere<double>& sphere = surface.shape;
    if (!(surface.radiance > 0).any())
      scene.add_wall(sphere.anchor, sphere.normal, 1 / sphere.curvature, surface.material, surface.radiance);
  }
  return {box.name, scene, box.camera};
}

View box_with_light(double radius) {
  View box = dark_box();
  const double radiance = paper_radiance * std::pow(paper_radius / radius, 2);
  box.scene.add_sphere({50, 65.1, 81.6}, radius, Rgb<double>(0, 0, 0), Rgb<double>::Constant(radiance));
  return box;
}

View box_with_lights(int n) {
  constexpr double radius = 0.15;
  std::vector<double> weights;
  double sum = 0;
  for (int i = 0; i < n; ++i) sum += weights.emplace_back((i % 7 + 1) * (i % 11 + 1));
  View box = dark_box();
  const int columns = static_cast<int>(std::ceil(std::sqrt(n))), rows = (n + columns - 1) / columns;
  for (int i = 0; i < n; ++i) {
    const double x = 10 + 80 * (i % columns + 0.5) / columns, z = 10 + 100 * (i / columns + 0.5) / rows;
    const double radiance =
        paper_radiance * std::pow(paper_radius / radius, 2) * weights[static_cast<std::size_t>(i)] / sum;
    box.scene.add_sphere({x, 70, z}, radius, Rgb<double>(0, 0, 0), Rgb<double>::Constant(radiance));
  }
  return box;
}

}  // namespace fairlight
