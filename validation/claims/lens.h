#pragma once

#include <fairlight/estimators/gaussian_filter.h>
#include <fairlight/estimators/importance.h>
#include <fairlight/estimators/lens.h>
#include <fairlight/validation/checks/law_claims.h>

namespace fairlight {

// Moments of apertures and lenses in closed form.
//
// Area and second moment of a regular polygon with n corners at the distance R: its 2n right
// triangles have the legs R cos(a) and R sin(a), with a = pi / n. A point of one is s (R cos(a), v
// R sin(a)) with s^2 and v uniform in [0,1]. With E[s^2] = 1/2 and E[v^2] = 1/3, E[x^2 + y^2] = R^2
// (cos^2(a) + sin^2(a) / 3) / 2 = R^2 (2 + cos(2 a)) / 6. For a square this is R^2 / 3. As n grows
// it tends to that of the disk, R^2 / 2.
//
// Blur: the ray through the point l of a lens focused at f meets the pinhole's ray at the distance
// f. So at the distance d they are |l| |1 - d/f| apart. Over a disk E[|l|^2] = R^2 / 2, so the mean
// squared distance is R^2/2 ((d - f) / f)^2.

/// A Gaussian filter with a deviation of half a pixel, cut off at two deviations.
template <template <class> class Filter>
auto gaussian_law() {
  return LawEstimand{"filter.gaussian",           "GaussianFilter",    "Ernst, Stamminger, Greiner 2006",
                     component<Filter>(0.5, 1.0), SquareDomain{-1, 1}, 8};
}

/// Uniform points on a disk of radius 2.5.
template <template <class> class Aperture>
auto circular_aperture_law() {
  return LawEstimand{"aperture.circle", "CircularAperture", "Shirley and Chiu 1997", component<Aperture>(2.5),
                     DiskDomain{2.5}};
}

/// Uniform points on a rotated pentagon: the coordinates of the draws have the moments of a uniform
/// point of the square.
template <class Real>
Claim polygonal_aperture_claim() {
  return {
      .name = "aperture.polygon.moments" + real_suffix<Real>(),
      .kind = "law",
      .subjects = {"PolygonalAperture"},
      .statement =
          "in coordinates that preserve area the draws have the cosine moments of the uniform law, up to the third",
      .source = "Turk 1990",
      .margin_factor = 10,
      .check =
          [](const Trial& trial) {
            const PolygonDomain pentagon{2.5, 5, 0.25};
            SamplerDraws draws(PolygonalAperture<Real>(Real(2.5), 5, Real(0.25)),
                               point_pairs<Real>(StreamKey(trial.seed, trial.claim), points_a_replicate));
            return test_rosenblatt(
                trial, [](double, double) { return 1.0; },
                [&](std::uint64_t i) { return pentagon.coordinates(draws.point(i)); }, points_a_replicate);
          },
      .real = real_name<Real>()};
}

inline auto polygon_second_moment(int blades) {
  constexpr double radius = 2.5;
  const double mean = radius * radius * (2 + std::cos(2 * std::numbers::pi / blades)) / 6;
  const auto draw = [=]<class Real>(std::type_identity<Real>, auto& source) {
    const PolygonalAperture<Real> aperture(rounded<Real>(radius), blades);
    return Real(aperture.sample(next_pair<Real>(source)).squaredNorm());
  };
  return estimand("aperture.polygon.second_moment." + std::to_string(blades), {"PolygonalAperture"},
                  "over a regular polygon of " + std::to_string(blades) +
                      " corners the mean squared distance from the centre is R^2 (2 + cos(2 pi / n)) / 6",
                  "elementary", {{mean, 0, radius * radius * (1 + 1e-12)}}, draw);
}

/// The direction of the pinhole's ray in the claims about lenses. It is far from the axis, so that
/// distances along the ray and along the axis differ.
template <class Real>
Vec3<Real> off_axis() {
  return {Real(0.75), Real(0.5), Real(1)};
}

/// The squared distance between the rays of a lens and of a pinhole at `distance`. The lens is
/// focused at 2.
template <template <class> class Aperture, template <class, class> class Lens>
auto circle_of_confusion(double distance) {
  constexpr double focus = 2;
  constexpr double radius = 0.25;
  const double largest = std::pow(radius * (distance - focus) / focus, 2);
  const auto draw = [=]<class Real>(std::type_identity<Real>, auto& source) {
    const Lens lens(rounded<Real>(focus), Aperture<Real>(rounded<Real>(radius)));
    const LensRay<Real> ray = lens.ray(off_axis<Real>(), next_pair<Real>(source));
    const Real d = rounded<Real>(distance);
    return Real((ray.origin + ray.direction * d - off_axis<Real>() * d).squaredNorm());
  };
  return estimand(
      distance > focus ? "lens.confusion.behind" : "lens.confusion.before", {"ThinLens", "CircularAperture"},
      "the rays of a lens cross the plane at distance d at a mean squared distance of R^2/2 ((d - f)/f)^2 "
      "from the pinhole's",
      "similar triangles", {{largest / 2, 0, largest * (1 + 1e-9)}}, draw);
}

/// A sum of coordinates of the point where a ray crosses the plane of focus. It is the same for
/// every point of the lens.
template <template <class, class> class Lens>
auto lens_focus() {
  constexpr double focus = 2;
  const auto draw = []<class Real>(std::type_identity<Real>, auto& source) {
    const Lens lens(Real(focus), CircularAperture<Real>(Real(0.25)));
    const LensRay<Real> ray = lens.ray(off_axis<Real>(), next_pair<Real>(source));
    const Vec3<Real> crossing = ray.origin + ray.direction * Real(focus);
    return Real(crossing.x() + Real(2) * crossing.y());
  };
  return constant("lens.focus", {"ThinLens"}, "all rays of a lens meet in the point in focus",
                  "the lens equation; Cook, Porter, Carpenter 1984", focus * (0.75 + 2 * 0.5), 8, draw);
}

/// The mean radiance over an aperture of this area, for a field of constant radiance.
/// `make(type_identity<Real>)` gives the aperture.
template <class Make>
auto uniform_field(const std::string& shape, const std::string& subject, double area, const Make& make) {
  constexpr double radiance = 3;
  const auto draw = [=]<class Real>(std::type_identity<Real> real, auto& source) {
    const Real per_area = rounded<Real>(radiance / area);
    return Importance(make(real), [=](const Vec2<Real>&) { return per_area; }).estimate(source);
  };
  return constant("aperture." + shape + ".uniform_field", {subject, "Importance"},
                  "a uniform field of radiance L, averaged over the aperture, is L",
                  "the area of a disk, and of a regular polygon", radiance, 8, draw);
}

/// The same for a disk, and for a pentagon with its corners at the same radius.
inline constexpr double field_radius = 0.375;
template <template <class> class Aperture>
auto uniform_field_of_disk() {
  return uniform_field("circle", "CircularAperture", std::numbers::pi * field_radius * field_radius,
                       component<Aperture>(field_radius));
}
inline auto uniform_field_of_pentagon() {
  return uniform_field(
      "polygon", "PolygonalAperture", 2.5 * field_radius * field_radius * std::sin(2 * std::numbers::pi / 5),
      []<class Real>(std::type_identity<Real>) { return PolygonalAperture<Real>(Real(field_radius), 5); });
}

}  // namespace fairlight
