#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <type_traits>

#include <fairlight/estimators/concepts.h>
#include <fairlight/estimators/lens.h>
#include <fairlight/render/scene.h>

namespace fairlight {

/// The height of the image plane at distance 1, for a vertical field of view in degrees. Throws
/// std::invalid_argument unless the field of view is in (0, 180).
inline double image_height_of(double field_of_view) {
  if (!(field_of_view > 0 && field_of_view < 180))
    throw std::invalid_argument("the field of view must be between 0 and 180 degrees (the image is a plane)");
  return 2 * std::tan(field_of_view * std::numbers::pi / 360);
}

/// The position, direction and optics of a camera, which is a pinhole or a thin lens.
struct CameraSettings {
  Vec3<double> eye{0, 0, 0};                 ///< [m]
  Vec3<double> look{0, 0, -1};               ///< the direction of the axis, of any length
  Vec3<double> up{0, 1, 0};                  ///< any direction not parallel to the axis
  double image_height = 1;                   ///< of the image plane at distance 1
  double start = 0;                          ///< distance of the plane on which rays start [m]
  double aperture_radius = 0;                ///< radius of the lens [m]; 0 for a pinhole
  double focus_distance = infinity<double>;  ///< distance of the plane in focus [m]
  int blades = 0;                            ///< blades of the aperture; 0 for a round one
  double blade_rotation = 0;                 ///< its first corner, clockwise from the right [rad]
};

/// A pinhole or thin-lens camera. Images are upright, pixel (0, 0) is at the top left, pixels are
/// square.
/// Source   PBR 4ed, 5.2
class Camera {
 public:
  /// Throws std::invalid_argument for settings outside their domain.
  explicit Camera(const CameraSettings& settings)
      : settings_(settings), look_(settings.look.normalized()), right_(look_.cross(settings.up.normalized())) {
    if (!all_finite(right_) || right_.norm() <= 1e-6)
      throw std::invalid_argument("the camera looks straight up or down (up is undefined)");
    if (!all_finite(settings.eye)) throw std::invalid_argument("the camera's place must be finite");
    if (!all_positive(settings.image_height))
      throw std::invalid_argument("the image plane's height must be positive and finite");
    if (!all_nonnegative(settings.start)) throw std::invalid_argument("rays must start at or in front of the eye");
    if (!all_nonnegative(settings.aperture_radius))
      throw std::invalid_argument("the aperture's radius must be finite and not negative (0 is a pinhole)");
    if (!(settings.focus_distance > 0) || !all_finite(1 / settings.focus_distance))
      throw std::invalid_argument("the camera must be focused in front of itself (it sees nothing behind)");
    if (settings.blades != 0 && settings.blades < 3)
      throw std::invalid_argument("an aperture needs three blades or more (or 0, and is round)");
    if (!all_finite(settings.blade_rotation))
      throw std::invalid_argument("the rotation of an aperture's blades must be finite (it is an angle)");
    right_ = right_.normalized() * settings.image_height;
    down_ = look_.cross(right_);
  }

  /// Throws std::invalid_argument if the lengths or ratios of the settings are too large or too
  /// small for their squares to be held by `Real`, double or float. Rays would then have no
  /// direction.
  template <class Real>
  void require_rays() const {
    constexpr bool in_double = std::is_same_v<Real, double>;
    constexpr double most = in_double ? 1e150 : 1e18;
    const auto& s = settings_;
    const bool has_rays = s.image_height * most >= 1 && s.image_height <= most && s.start <= most &&
                          s.start * s.image_height <= most && s.eye.cwiseAbs().maxCoeff() <= most;
    const bool is_lens = s.focus_distance * most >= 1 && s.aperture_radius * most >= 1 &&
                         s.aperture_radius <= most * std::min(s.focus_distance, 1.0);
    if (has_rays && (is_lens || !has_lens())) return;
    throw std::invalid_argument(
        std::string("the camera's place, lens or field of view is not held by ") +
        (in_double ? "doubles (give lengths and ratios between 1e-150 and 1e150)"
                   : "floats (give lengths and ratios between 1e-18 and 1e18, or --real double)"));
  }

  /// The distance [m] from a point to the set where rays start, for an image of `width` x `height`
  /// image_heights. With a bladed aperture it is a lower bound.
  double distance_to_starts(const Vec3<double>& point, double width, double height) const {
    const auto& s = settings_;
    const Vec3<double> way = point - s.eye;
    const auto beyond = [&](const Vec3<double>& side, double size) {
      return std::max(std::abs(way.dot(side.normalized())) - s.start * s.image_height * size / 2, 0.0);
    };
    const double lens = s.aperture_radius * std::abs(1 - s.start / s.focus_distance);
    const double aside = std::max(std::hypot(beyond(right_, width), beyond(down_, height)) - lens, 0.0);
    return std::hypot(aside, way.dot(look_) - s.start);
  }

  const CameraSettings& settings() const { return settings_; }
  bool has_lens() const { return settings_.aperture_radius != 0; }

  /// The ray of a pinhole camera through the point (x, y), in pixels from the top left corner of a
  /// width x height image.
  template <class Real>
  Ray<Real> ray(Real x, Real y, int width, int height) const {
    const Vec3<Real> direction = rounded_vector<Real>(look_) +
                                 rounded_vector<Real>(right_) * across(x, width, height) +
                                 rounded_vector<Real>(down_) * along(y, height);
    return starting(rounded_vector<Real>(settings_.eye), direction);
  }

  /// The ray through the same point of the image and a random point of the lens. Takes two numbers
  /// of the source; a pinhole takes none.
  template <class Real, UniformSource<Real> Source>
  Ray<Real> ray(Real x, Real y, int width, int height, Source& source) const {
    if (!has_lens()) return ray(x, y, width, height);
    const Real scale = rounded<Real>(settings_.image_height);
    const Vec3<Real> pinhole(scale * across(x, width, height), scale * along(y, height), Real(1));
    const LensRay<Real> local = through_lens<Real>(pinhole, next_pair<Real>(source));
    return starting(Vec3<Real>(rounded_vector<Real>(settings_.eye) + to_world(local.origin)),
                    to_world(local.direction));
  }

 private:
  // The position on the image, from its middle, in units of the image's height.
  template <class Real>
  static Real across(Real x, int width, int height) {
    return (x - Real(0.5) * rounded<Real>(width)) / rounded<Real>(height);
  }
  template <class Real>
  static Real along(Real y, int height) {
    return y / rounded<Real>(height) - Real(0.5);
  }

  template <class Real>
  LensRay<Real> through_lens(const Vec3<Real>& pinhole, const Vec2<Real>& u) const {
    const Real focus = rounded<Real>(settings_.focus_distance);
    const Real radius = rounded<Real>(settings_.aperture_radius);
    if (settings_.blades == 0) return ThinLens(focus, CircularAperture<Real>(radius)).ray(pinhole, u);
    const PolygonalAperture<Real> aperture(radius, settings_.blades, rounded<Real>(settings_.blade_rotation));
    return ThinLens(focus, aperture).ray(pinhole, u);
  }

  // From the lens's frame to the world. right_ and down_ are as long as the image is high.
  template <class Real>
  Vec3<Real> to_world(const Vec3<Real>& local) const {
    const Real scale = rounded<Real>(settings_.image_height);
    return rounded_vector<Real>(look_) * local.z() + rounded_vector<Real>(right_) * (local.x() / scale) +
           rounded_vector<Real>(down_) * (local.y() / scale);
  }

  // A ray from a point of the lens; `direction` has the component 1 along the axis.
  template <class Real>
  Ray<Real> starting(const Vec3<Real>& origin, const Vec3<Real>& direction) const {
    return {origin + direction * rounded<Real>(settings_.start), direction * Real(Real(1) / direction.norm()),
            Real(-1)};
  }

  CameraSettings settings_;
  Vec3<double> look_, right_, down_;
};

/// The ray of one sample of a pixel: through a point that the filter samples around `middle`, the
/// pixel's middle in pixels from the top left corner, and a point of the lens. Takes two numbers of
/// the source, and two more for a lens.
template <class Filter, UniformSource<typename Filter::Scalar> Source>
Ray<typename Filter::Scalar> pixel_ray(const Camera& camera, const Filter& filter,
                                       const Vec2<typename Filter::Scalar>& middle, int width, int height,
                                       Source& source) {
  using Real = typename Filter::Scalar;
  const Vec2<Real> place = filter.sample(next_pair<Real>(source)) + middle;
  return camera.ray<Real>(place.x(), place.y(), width, height, source);
}

/// The same for pixel (x, y), in every lane.
template <class Filter, UniformSource<typename Filter::Scalar> Source>
Ray<typename Filter::Scalar> pixel_ray(const Camera& camera, const Filter& filter, int x, int y, int width,
                                       int height, Source& source) {
  using Real = typename Filter::Scalar;
  return pixel_ray(camera, filter, Vec2<Real>(rounded<Real>(x + 0.5), rounded<Real>(y + 0.5)), width, height,
                   source);
}

}  // namespace fairlight
