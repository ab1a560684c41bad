#pragma once

#include <fairlight/validation/claims/radiance.h>

namespace fairlight {

/// Spheres of radiance Le over a diffuse floor of albedo rho, which shows rho E / pi in every
/// direction. Lights add up. A sphere of radius r at the distance d, wholly above the horizon,
/// fills a cone of half-angle asin(r/d), whose projected solid angle is pi sin^2 cos(theta), with
/// theta the angle of its centre.
/// Formula  E = pi Le (r/d)^2 cos(theta)
/// Source   Nusselt's analogue; Snyder 1996
struct SpheresOverPlane {
  struct Light {
    Vec3<double> centre;
    double radius;
    Rgb<double> radiance;
  };

  Scene scene;
  std::vector<Light> lights;
  Rgb<double> albedo{0.75, 0.5, 0.25};
  // The floor is a sphere of radius 1e5 seen from outside, so all lights are above its horizon at
  // the origin.
  Ray<double> ray{{0, 0.5, 0}, {0, -1, 0}, -1};

  explicit SpheresOverPlane(std::vector<Light> all) : lights(std::move(all)) {
    scene.add_wall({0, 0, 0}, {0, 1, 0}, 1e5, albedo, Rgb<double>::Zero());
    for (const Light& light : lights)
      scene.add_sphere(light.centre, light.radius, Rgb<double>::Zero(), light.radiance);
  }

  /// The radiance of the floor at the origin.
  double reference(int channel) const {
    double sum = 0;
    for (const Light& light : lights) {
      const double ratio = light.radius / light.centre.norm();
      sum += light.radiance[channel] * ratio * ratio * light.centre.y() / light.centre.norm();
    }
    return albedo[channel] * sum;
  }

  /// The largest shadow-ray term of a light: A Le f / d^2 with d the distance to its nearest point.
  double largest_term(const Light& light, int channel) const {
    const double nearest = light.centre.norm() - light.radius;
    return 4 * light.radius * light.radius * light.radiance[channel] * albedo[channel] / (nearest * nearest);
  }

  /// The largest shadow-ray term by cone: S Le f with the solid angle S = 2 pi (1 - cos).
  double largest_cone_term(const Light& light, int channel) const {
    const double sine = light.radius / light.centre.norm();
    return 2 * (1 - std::sqrt(1 - sine * sine)) * light.radiance[channel] * albedo[channel];
  }

  double sum_of_terms(int channel) const {
    double sum = 0;
    for (const Light& light : lights) sum += largest_term(light, channel);
    return sum;
  }

  double sum_of_cone_terms(int channel) const {
    double sum = 0;
    for (const Light& light : lights) sum += largest_cone_term(light, channel);
    return sum;
  }

  double largest_radiance(int channel) const {
    double largest = 0;
    for (const Light& light : lights) largest = std::max(largest, light.radiance[channel]);
    return largest;
  }
};

/// One light, so far away that half of its points are visible.
inline SpheresOverPlane one_light() { return SpheresOverPlane({{{3, 12, 4}, 1, {1, 4, 2}}}); }

/// One light, so near that bounces often hit it.
inline SpheresOverPlane large_light() { return SpheresOverPlane({{{1.5, 2.5, 1}, 2.4, {1, 4, 2}}}); }

/// Two lights of different size, distance and power; neither occludes the other.
inline SpheresOverPlane two_lights() {
  return SpheresOverPlane({{{3, 5, 2}, 1.5, {1, 4, 2}}, {{-2, 4, -1.5}, 0.6, {12, 8, 20}}});
}

/// The radiance of the floor from paths of one bounce, by the tracers that `make` gives. `bound`
/// gives the largest draw of a channel.
template <class Make, class Bound>
auto floor_radiance(const std::string& name, std::vector<std::string> subjects, const SpheresOverPlane& floor,
                    double margin_factor, const Bound& bound, const Make& make) {
  const auto reference = [&](int c) { return Reference{floor.reference(c), 0, bound(floor, c) * (1 + 1e-9)}; };
  return estimand(name, std::move(subjects),
                  "under " + std::to_string(floor.lights.size()) +
                      " sphere light(s) a diffuse floor shows rho sum Le (r/d)^2 cos(theta), per channel",
                  "projected solid angle of a cone; Snyder 1996", for_channels(reference),
                  RadianceAlong(floor.scene, floor.ray, make), margin_factor);
}
template <class Tracer, class Bound>
auto floor_radiance(const std::string& name, std::vector<std::string> subjects, const SpheresOverPlane& floor,
                    double margin_factor, const Bound& bound) {
  return floor_radiance(name, std::move(subjects), floor, margin_factor, bound, always(Tracer(1)));
}

/// Light that shadow rays and bounces share by the balance heuristic: from one large light by cone,
/// or from two, with a shadow ray to one of them. `Direct` is the strategy.
/// Bound    a shadow ray brings no more than alone, as the densities add up, and a bounce at most
///          rho Le
template <class Direct>
using SharedTracer = PathTracer<BouncesBy<CosineHemisphere>, Direct, NoRoulette>;

template <class Direct = DirectLight<AllLights, PointsBy<SphereByCone>, MisWeighted<>>>
auto shared_light() {
  const auto bound = [](const SpheresOverPlane& s, int c) {
    return s.sum_of_cone_terms(c) + s.albedo[c] * s.largest_radiance(c);
  };
  return floor_radiance<SharedTracer<Direct>>(
      "sphere_over_plane.shared", {"DirectLight", "SphereByCone", "CosineHemisphere", "BalanceHeuristic"},
      large_light(), 2, bound);
}

template <class Direct = DirectLight<UniformLightSampler, PointsBy<SphereByCone>, MisWeighted<>>>
auto shared_lights() {
  const auto bound = [](const SpheresOverPlane& s, int c) {
    return 2 * s.sum_of_cone_terms(c) + s.albedo[c] * s.largest_radiance(c);
  };
  return floor_radiance<SharedTracer<Direct>>(
      "two_lights.shared", {"DirectLight", "UniformLightSampler", "SphereByCone", "BalanceHeuristic"}, two_lights(),
      4, bound);
}

}  // namespace fairlight
