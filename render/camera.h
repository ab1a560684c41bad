#pragma once

#include <cmath>
#include <stdexcept>

#include <fairlight/render/scene.h>

namespace fairlight {

/// A pinhole. Images are upright, pixel (0, 0) at the top left, pixels square.
class Camera {
 public:
  /// `eye` [m]; `look` any direction but straight up or down; `image_height` the height of the image plane at
  /// distance 1; rays start on the plane at `start` [m] along the look direction. Throws std::invalid_argument
  /// otherwise.
  Camera(const Vec3<double>& eye, const Vec3<double>& look, double image_height, double start)
      : eye_(eye), look_(look.normalized()), right_(look_.cross(Vec3<double>(0, 1, 0))), start_(start) {
    if (!(right_.norm() > 1e-6))
      throw std::invalid_argument("the camera looks straight up or down (up is undefined)");
    if (!(image_height > 0)) throw std::invalid_argument("the image plane's height must be positive");
    if (!(start >= 0)) throw std::invalid_argument("rays must start at or in front of the eye");
    right_ = right_.normalized() * image_height;
    down_ = look_.cross(right_);
  }

  /// The ray through the point (x, y) of the image, in pixels from the top left corner, of an image width x height.
  template <class Real>
  Ray<Real> ray(Real x, Real y, int width, int height) const {
    const Real across = (x - Real(0.5) * Real(width)) / Real(height);
    const Real along = y / Real(height) - Real(0.5);
    const Vec3<Real> direction = look_ + right_ * across + down_ * along;
    return {eye_ + direction * start_, direction.normalized(), -1};
  }

 private:
  Vec3<double> eye_, look_, right_, down_;
  double start_;
};

}  // namespace fairlight
