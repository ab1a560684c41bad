#pragma once

#include <cmath>
#include <numbers>

#include <fairlight/estimators/filter.h>
#include <fairlight/render/camera.h>
#include <fairlight/validation/checks/estimand.h>

namespace fairlight {

// Where the rays of one pixel cross a plane across the axis, in closed form.
//
// At the distance d along the axis a pixel has the width s = d h / H. h is the height of the image
// plane at distance 1, H that of the image in pixels. In an image of W x H pixels, the centre of
// pixel (x, y) is s (x + 1/2 - W/2) to the right of the axis and s (y + 1/2 - H/2) below it. A
// filter draw has mean 0 and variance v along each axis, and moves the crossing by s times the
// draw. A point l of a lens of radius R, focused at f, moves it by l (1 - d/f), and
// E|l|^2 = R^2 / 2 over the disk. Both are independent and have mean 0. So the mean crossing is the
// centre, and its mean squared distance from it is 2 v s^2 + (1 - d/f)^2 R^2 / 2.

/// The rays of a pixel as renders use them. A fault can replace it.
struct PixelRays {
  template <class... Arguments>
  auto operator()(Arguments&&... arguments) const {
    return pixel_ray(std::forward<Arguments>(arguments)...);
  }
};

/// A camera with a tilted frame: the coordinates of right, down and axis are multiples of 1/3. Its
/// rays start beyond the eye.
struct CameraAskew {
  static constexpr int width = 4, height = 3, x = 3, y = 2;
  static constexpr double image_height = 1.5, distance = 4, focus = 2.5;
  double radius;

  static Vec3<double> axis() { return Vec3<double>(2, -1, -2) / 3; }
  static Vec3<double> right() { return Vec3<double>(2, 2, 1) / 3; }
  static Vec3<double> down() { return Vec3<double>(1, -2, 2) / 3; }
  static Vec3<double> eye() { return {0.5, -0.25, 1}; }

  Camera camera() const {
    return Camera({.eye = eye(),
                   .look = 6 * axis(),
                   .up = axis() - 2 * down(),
                   .image_height = image_height,
                   .start = 0.25,
                   .aperture_radius = radius,
                   .focus_distance = focus});
  }
  double pixel() const { return distance * image_height / height; }
  double across() const { return pixel() * (x + 0.5 - width / 2.0); }
  double below() const { return pixel() * (y + 0.5 - height / 2.0); }
  double blur() const { return std::abs(1 - distance / focus) * radius; }
};

/// The coordinates where a ray crosses that plane, to the right of the axis and below it.
template <class Real>
Vec2<Real> crossing(const Ray<Real>& ray) {
  const Vec3<Real> from = ray.origin - rounded_vector<Real>(CameraAskew::eye());
  const Vec3<Real> axis = rounded_vector<Real>(CameraAskew::axis());
  const Real along = (Real(CameraAskew::distance) - from.dot(axis)) / ray.direction.dot(axis);
  const Vec3<Real> point = from + ray.direction * along;
  return {point.dot(rounded_vector<Real>(CameraAskew::right())),
          point.dot(rounded_vector<Real>(CameraAskew::down()))};
}

/// The means of the two coordinates of the crossing, and of 1 - (squared distance from the
/// centre) / (its maximum), which varies less. The filter from `make(type_identity<Real>)` has the
/// given variance and reach, in pixels.
template <class Rays = PixelRays, class Make>
auto pixel_crossings(const std::string& name, std::vector<std::string> subjects, double radius, double variance,
                     double reach, const Make& make) {
  const CameraAskew askew{radius};
  const double s = askew.pixel();
  const double farthest = s * reach + askew.blur();
  const auto within = [=](double middle) {
    return Reference{middle, middle - farthest * (1 + 1e-9), middle + farthest * (1 + 1e-9)};
  };
  const double spread = 2 * variance * s * s + askew.blur() * askew.blur() / 2;
  const double largest = std::pow(std::numbers::sqrt2 * s * reach + askew.blur(), 2);
  const auto draw = [=, camera = askew.camera()]<class Real>(std::type_identity<Real> real, auto& source) {
    const Ray<Real> ray = Rays()(camera, make(real), askew.x, askew.y, askew.width, askew.height, source);
    const Vec2<Real> place = crossing(ray);
    const Vec2<Real> off(place.x() - rounded<Real>(askew.across()), place.y() - rounded<Real>(askew.below()));
    return Rgb<Real>(place.x(), place.y(), Real(1) - off.squaredNorm() / rounded<Real>(largest));
  };
  return estimand(name, std::move(subjects),
                  "the rays of a pixel cross a plane about its middle, in the mean, and as far from it as the "
                  "filter and the circle of confusion say",
                  "elementary; similar triangles",
                  {within(askew.across()), within(askew.below()), {1 - spread / largest, -1e-9, 1}}, draw);
}

/// The crossings of a pinhole camera.
template <class Rays = PixelRays>
auto pinhole_crossings() {
  return pixel_crossings<Rays>("camera.pinhole", {"Camera", "TentFilter"}, 0, 1.0 / 6, 1, component<TentFilter>());
}

/// The crossings of a lens out of focus.
template <class Rays = PixelRays>
auto lens_crossings() {
  return pixel_crossings<Rays>("camera.lens", {"Camera", "BoxFilter", "ThinLens", "CircularAperture"}, 1.5,
                               1.0 / 12, 0.5, component<BoxFilter>(0.5));
}

}  // namespace fairlight
