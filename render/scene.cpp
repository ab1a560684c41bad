#include <cmath>
#include <stdexcept>

#include <fairlight/render/scene.h>

namespace fairlight {

void Scene::add_sphere(const Vec3<double>& centre, double radius, const Rgb<double>& albedo,
                       const Rgb<double>& radiance) {
  const Vec3<double> up(0, 1, 0);
  add({centre + radius * up, up, 1 / radius}, radius, albedo, radiance);
}

void Scene::add_wall(const Vec3<double>& point, const Vec3<double>& outward, double radius,
                     const Rgb<double>& albedo, const Rgb<double>& radiance) {
  if (!(std::abs(outward.norm() - 1) <= 1e-9)) {
    throw std::invalid_argument("a wall's normal must be a unit vector (it is the direction away from the centre)");
  }
  add({point, outward, 1 / radius}, radius, albedo, radiance);
}

void Scene::add(const Sphere<double>& shape, double radius, const Rgb<double>& albedo,
                const Rgb<double>& radiance) {
  if (!(radius > 0 && std::isfinite(radius) && shape.anchor.allFinite())) {
    throw std::invalid_argument("a sphere's radius must be positive and finite, and its place finite (in metres)");
  }
  if (!((albedo >= 0) && (albedo <= 1)).all()) {
    throw std::invalid_argument("an albedo must be in [0,1] per channel (a surface reflects no more than it gets)");
  }
  if (!((radiance >= 0).all() && radiance.isFinite().all())) {
    throw std::invalid_argument("a radiance must be nonnegative and finite per channel");
  }
  const int index = static_cast<int>(surfaces_.size());
  surfaces_.push_back({shape, albedo, radiance});
  if ((radiance > 0).any()) luminaires_.push_back({index, shape.anchor - radius * shape.normal, radius, radiance});
}

}  // namespace fairlight
