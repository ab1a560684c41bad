#include <cmath>

#include <fairlight/estimators/stream.h>
#include <fairlight/validation/studies/confusion.h>

namespace fairlight {
namespace {

struct Axes {
  Vec3<double> look, right, down;
};

Axes axes_of(const CameraSettings& camera) {
  const Vec3<double> look = camera.look.normalized(), right = look.cross(camera.up).normalized();
  return {look, right, look.cross(right)};
}

}  // namespace

SeenAt seen_at(const CameraSettings& camera, const Vec3<double>& point, int width, int height) {
  const Axes axes = axes_of(camera);
  const Vec3<double> way = point - camera.eye;
  const double distance = way.dot(axes.look), scale = height / (camera.image_height * distance);
  return {width / 2.0 + way.dot(axes.right) * scale, height / 2.0 + way.dot(axes.down) * scale, distance};
}

double circle_of_confusion(const CameraSettings& camera, double distance, int height) {
  const double f = camera.focus_distance;
  return camera.aperture_radius * std::abs(distance - f) / (f * distance) * height / camera.image_height;
}

Measured measured_confusion(const CameraSettings& settings, double distance, int height,
                            const StudyOptions& options, const std::string& purpose) {
  const Camera camera(settings);
  const Axes axes = axes_of(settings);
  const auto crossing = [&](const Ray<double>& ray) {
    const double along = (distance - (ray.origin - settings.eye).dot(axes.look)) / ray.direction.dot(axes.look);
    return Vec3<double>(ray.origin + along * ray.direction);
  };
  const double middle = height / 2.0;
  const Vec3<double> pinhole = crossing(camera.ray<double>(middle, middle, height, height));
  const StreamKey key(options.seed, "study " + purpose);
  std::vector<double> radii;
  for (std::uint32_t block = 0; block < 20; ++block) {
    double square = 0;
    constexpr int rays = 4096;
    for (std::uint32_t i = 0; i < rays; ++i) {
      PhiloxStream<double> source(key, block, i);
      square +=
          (crossing(camera.ray<double>(middle, middle, height, height, source)) - pinhole).squaredNorm() / rays;
    }
    radii.push_back(std::sqrt(2 * square) / distance * height / settings.image_height);
  }
  return measured_mean(radii);
}

}  // namespace fairlight
