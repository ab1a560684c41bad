#pragma once

#include <fairlight/estimators/choose_light.h>
#include <fairlight/estimators/rectangle_light.h>
#include <fairlight/estimators/sphere_sampling.h>
#include <fairlight/validation/checks/estimand.h>
#include <fairlight/validation/checks/law_claims.h>
#include <fairlight/validation/claims/irradiance.h>

namespace fairlight {

/// Lights of unit radiance, seen from the origin: integrals over their directions, by a sampling
/// strategy.

/// A sphere. The origin may lie on it.
struct SphereFromOrigin {
  Vec3<double> centre;
  double radius;
  bool origin_on_it = false;

  template <class Real>
  SphereLight<Real> light() const {
    return {rounded_vector<Real>(centre), rounded<Real>(radius), Mask<Real>(origin_on_it)};
  }
  double area() const { return 4 * std::numbers::pi * radius * radius; }
  double nearest() const { return std::abs(centre.norm() - radius); }

  /// The largest 1/p: A cos_L / t^2 by area, the solid angle by cone.
  double area_bound() const { return area() / (nearest() * nearest()); }
  double cone_bound() const {
    // Without the difference 1 - cos, which is 0 for a small cone.
    const double sine = radius / centre.norm();
    return 2 * std::numbers::pi * sine * sine / (1 + std::sqrt(1 - sine * sine));
  }
};

/// A rectangle above the origin, parallel to the plane z = 0.
struct RectangleFromOrigin {
  Vec3<double> corner;
  double width, height;

  template <class Real>
  RectangleLight<Real> light() const {
    return {rounded_vector<Real>(corner), rounded_vector<Real>({width, 0, 0}),
            rounded_vector<Real>({0, height, 0})};
  }
  std::vector<Vec3<double>> corners() const {
    const Vec3<double> x(width, 0, 0), y(0, height, 0);
    return {corner, corner + x, corner + x + y, corner + y};
  }
  double solid_angle() const {
    return rectangle_solid_angle(corner.x(), corner.x() + width, corner.y(), corner.y() + height, corner.z());
  }
  /// The largest 1/p by area, A cos_L / t^2: at the least distance.
  double area_bound() const {
    const double x = std::max({0.0, corner.x(), -corner.x() - width});
    const double y = std::max({0.0, corner.y(), -corner.y() - height});
    const double t = std::hypot(x, y, corner.z());
    return width * height * std::abs(corner.z()) / (t * t * t);
  }
};

template <template <class> class Strategy>
auto sphere_strategy(const SphereFromOrigin& sphere) {
  return [=]<class Real>(std::type_identity<Real>) { return Strategy<Real>(sphere.template light<Real>()); };
}

/// The faces of a surface that receive light.
enum class Faces { front, both };

/// The irradiance from a light: the integral of the cosine over its directions, by draws of
/// cos / p. `make` gives the strategy in an arithmetic; `largest` bounds 1/p.
template <class Make>
auto irradiance(const std::string& name, const std::string& subject, const std::string& statement,
                const std::string& source, const Make& make, const Vec3<double>& normal, Faces faces, double mean,
                double largest) {
  const auto draw = [=]<class Real>(std::type_identity<Real> real, auto& numbers) {
    const auto light = make(real);
    const LightSample<Real> sample = light.sample(rounded_vector<Real>({0, 0, 0}), next_pair<Real>(numbers));
    const Real cosine = rounded_vector<Real>(normal).dot(sample.direction);
    const Real behind = faces == Faces::both ? Real(-cosine) : Real(0);
    return safe_divide(Real(select(cosine > Real(0), cosine, behind)), sample.density);
  };
  return estimand(name, {subject}, statement, source, {{mean, 0, largest * (1 + 1e-9)}}, draw);
}

/// The irradiance from a sphere, with the origin outside or on it.
template <template <class> class Strategy>
auto sphere_irradiance_claim(const std::string& name, const std::string& subject, const SphereFromOrigin& sphere,
                             const Vec3<double>& normal, double largest) {
  const double d = sphere.centre.norm();
  const double mean =
      sphere.origin_on_it ? std::numbers::pi : sphere_irradiance(sphere.radius, d, normal.dot(sphere.centre) / d);
  return irradiance(name, subject, "a sphere of unit radiance makes the irradiance of its cone above the horizon",
                    "Lambert's contour formula; Snyder 1996", sphere_strategy<Strategy>(sphere), normal,
                    Faces::front, mean, largest);
}

/// The irradiance from a sphere around the origin, on both faces of a sheet there: pi on each.
template <template <class> class Strategy>
auto enclosed_irradiance_claim(const std::string& name, const std::string& subject, const SphereFromOrigin& sphere,
                               const Vec3<double>& normal, double largest) {
  return irradiance(name, subject, "inside a sphere of unit radiance the irradiance is pi on either face, wherever",
                    "elementary", sphere_strategy<Strategy>(sphere), normal, Faces::both, 2 * std::numbers::pi,
                    largest);
}

/// The irradiance from a rectangle.
template <template <class> class Strategy>
auto rectangle_irradiance_claim(const std::string& name, const std::string& subject,
                                const RectangleFromOrigin& rectangle, const Vec3<double>& normal, double largest) {
  const auto make = [=]<class Real>(std::type_identity<Real>) {
    return Strategy<Real>(rectangle.template light<Real>());
  };
  return irradiance(name, subject, "a rectangle of unit radiance makes the irradiance of Lambert's polygon formula",
                    "Lambert 1760; Baum, Rushmeier, Winget 1989", make, normal, Faces::front,
                    polygon_irradiance(rectangle.corners(), normal), largest);
}

/// The solid angle of a rectangle: the mean of 1/p.
template <template <class> class Strategy>
auto rectangle_solid_angle_claim(const std::string& name, const std::string& subject,
                                 const RectangleFromOrigin& rectangle, double largest) {
  const auto draw = [=]<class Real>(std::type_identity<Real>, auto& numbers) {
    const Strategy<Real> light(rectangle.template light<Real>());
    const auto sample = light.sample(rounded_vector<Real>({0, 0, 0}), next_pair<Real>(numbers));
    return safe_divide(Real(1), sample.density);
  };
  return estimand(name, {subject}, "the mean of 1/p is the solid angle of the rectangle",
                  "elementary: the sum over the corners of atan(x y / (z r))",
                  {{rectangle.solid_angle(), 0, largest * (1 + 1e-9)}}, draw);
}

/// The directions that a strategy samples from a point, as a law.
template <class Light>
struct DirectionsFrom {
  using Scalar = typename Light::Scalar;
  using Point = Vec3<Scalar>;
  using Measure = SolidAngle;
  Light light;
  Point from;

  Point sample(const Vec2<Scalar>& u) const { return light.sample(from, u).direction; }
  Density<Measure, Scalar> pdf(const Point& w) const { return light.pdf(from, w); }
};

/// The law of directions from the origin to a sphere around it.
template <template <class> class Strategy, class Domain>
auto sphere_direction_law(const std::string& name, const std::string& subject, const SphereFromOrigin& sphere,
                          const Domain& domain) {
  const auto make = [=]<class Real>(std::type_identity<Real>) {
    return DirectionsFrom<Strategy<Real>>{Strategy<Real>(sphere.template light<Real>()),
                                          rounded_vector<Real>({0, 0, 0})};
  };
  return LawEstimand{name, subject, "Shirley, Wang, Zimmerman 1996", make, domain};
}

/// The points of a rectangle as fractions of its edges, drawn uniformly in solid angle. The density
/// per solid angle is constant; the class takes it at the middle of the rectangle, and converts it
/// to area at each point.
class RectanglePoints {
 public:
  using Scalar = double;
  using Point = Vec2<double>;
  using Measure = Area;

  explicit RectanglePoints(const RectangleFromOrigin& rectangle)
      : rectangle_(rectangle),
        light_(rectangle.light<double>()),
        density_(light_.pdf({0, 0, 0}, to_point({0.5, 0.5}).normalized())) {}

  Point sample(const Vec2<double>& u) const {
    const auto sample = light_.sample({0, 0, 0}, u);
    const Vec3<double> x = sample.distance * sample.direction - rectangle_.corner;
    return {x.x() / rectangle_.width, x.y() / rectangle_.height};
  }
  Density<Measure, double> pdf(const Point& x) const {
    const Vec3<double> way = to_point(x);
    const double distance = way.norm();
    const double area = rectangle_.width * rectangle_.height;
    return Density<Measure, double>(to_area(density_, distance, way.z() / distance).value() * area);
  }

 private:
  Vec3<double> to_point(const Point& x) const {
    return rectangle_.corner + Vec3<double>(rectangle_.width * x.x(), rectangle_.height * x.y(), 0);
  }

  RectangleFromOrigin rectangle_;
  RectangleBySolidAngle<double> light_;
  Density<SolidAngle, double> density_;
};

}  // namespace fairlight
