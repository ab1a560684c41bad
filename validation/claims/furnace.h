#pragma once

#include <cmath>
#include <stdexcept>

#include <fairlight/stats/text.h>
#include <fairlight/validation/claims/geometric_sum.h>
#include <fairlight/validation/claims/radiance.h>

namespace fairlight {

/// The furnace: inside a closed diffuse sphere that emits Le and reflects rho everywhere, a path
/// sees Le at every vertex. The sphere is not at the origin and not of unit size; the three
/// channels differ.
/// Formula  L = Le (1 + rho + rho^2 + ...) = Le / (1 - rho) in every direction; the terms up to
///          depth n sum to Le (1 - rho^(n+1)) / (1 - rho)
/// Source   the geometric series of the transport operator, which is rho times the identity here
///          (Kajiya 1986)
struct Furnace {
  Scene scene;
  Ray<double> ray;
  Rgb<double> radiance{1, 2, 0.5};
  Rgb<double> albedo{0.3, 0.5, 0.7};
  std::string description = "inside a closed sphere";

  /// `metre` is the length of a metre in the units of the scene. It must make no difference.
  explicit Furnace(double metre = 1)
      : ray{metre * Vec3<double>(1.5, -2.25, 4), Vec3<double>(2, 3, -6).normalized(), -1} {
    scene.add_sphere(metre * Vec3<double>(3, -2, 5), 7 * metre, albedo, radiance);
  }

  /// Le (1 - rho^(depth+1)) / (1 - rho), or the whole series for a negative depth.
  double reference(int channel, int depth) const {
    const double rho = albedo[channel];
    return radiance[channel] * (depth < 0 ? 1 : 1 - std::pow(rho, depth + 1)) / (1 - rho);
  }

  /// The whole series, from paths that bring `first` and then these terms. Each term is at most
  /// rho/q times the one before, where q >= rho is the probability to go on. The tail slack is 1e-9
  /// of the mean. Throws std::invalid_argument for q < rho, which has no bound.
  Reference reference_within(int channel, double first, const GeometricSum& terms) const {
    const double mean = reference(channel, -1), ratio = albedo[channel] / terms.goes_on;
    if (ratio > 1) throw std::invalid_argument("a path that goes on more rarely than it is reflected has no bound");
    if (ratio < 1) return {mean, 0, first + terms.largest / (1 - ratio) * (1 + 1e-9)};
    const double slack = 1e-9 * mean;
    return {mean, 0, first + terms.bound(slack), slack};
  }
};

/// The whole series from paths with roulette by reflectance (q = 0.7, the largest albedo); from the
/// first bounce on, roulette by throughput is the same. A vertex may bring up to `vertex` times as
/// much.
template <class Tracer>
auto furnace_radiance(const std::string& name, std::vector<std::string> subjects, double margin_factor = 1,
                      const Furnace& furnace = Furnace(), double vertex = 1) {
  // Bound: after k bounces the throughput is (rho/q)^k. If rho < q the sum is below
  // Le / (1 - rho/q). If rho = q a path brings Le at each of a geometric number of vertices. With
  // shadow rays the terms of depth 1 and more come one vertex earlier, times rho, so n vertices
  // bring 1 + rho n instead of n. That is more only for small n, far below the bound.
  const double q = furnace.albedo.maxCoeff();
  const auto reference = [&](int c) {
    const double le = vertex * furnace.radiance[c];
    return furnace.reference_within(c, 0, GeometricSum{le, le, q});
  };
  return estimand(name, std::move(subjects), furnace.description + " the radiance is Le / (1 - rho), per channel",
                  "geometric series of the transport operator", for_channels(reference),
                  RadianceAlong(furnace.scene, furnace.ray, always(Tracer())), margin_factor);
}

/// A furnace with a white mirror ball, which is invisible: it shows what the sphere shows. The ray
/// meets it head on. A vertex of the sphere may bring twice as much: from its shadow ray, and from
/// a bounce that sees the sphere in the mirror.
inline Furnace furnace_with_mirror() {
  Furnace furnace;
  furnace.scene.add_sphere({2.5, -0.75, 1}, 1, Material(Material::Kind::mirror, Rgb<double>::Ones(), 1),
                           Rgb<double>::Zero());
  furnace.description = "inside a closed sphere in which a white mirror ball stands";
  return furnace;
}

template <class Direct>
auto mirror_in_furnace(const std::string& how, std::vector<std::string> subjects) {
  using Tracer = PathTracer<BouncesBy<CosineHemisphere>, Direct, RouletteByReflectance<>>;
  return furnace_radiance<Tracer>("furnace.mirror_ball." + how, std::move(subjects), 8, furnace_with_mirror(), 2);
}

inline Furnace furnace_with_another() {
  Furnace furnace;
  furnace.scene.add_sphere({5, -2, 5}, 1, furnace.albedo, furnace.radiance);
  return furnace;
}

/// A furnace with a second sphere of the same emission and reflectance. Every ray still ends on a
/// surface that emits Le and reflects rho, so L = Le / (1 - rho). But now two luminaires of
/// different sizes occlude each other in part, and the terms of shadow rays vary. Shadow rays at a
/// vertex bring rho Le in the mean, and at most `largest` rho Le.
template <class Make>
auto two_spheres(const std::string& name, std::vector<std::string> subjects, double largest, const Make& make) {
  // Bounds, in units of rho Le. Points of the two spheres are at least 4 apart. By area a shadow
  // ray to the larger sphere brings at most 4 R^2 / 4^2 = 12.25 from the smaller one, and 1 from
  // the larger one itself. One to the smaller sphere, of radius 1, brings at most 0.25, and nothing
  // from itself, as it is convex. If one of two is picked, it counts twice. By cone the larger
  // sphere, which surrounds everything, brings at most S f Le = 4. The smaller fills at most 0.0102
  // of all directions as seen from the larger, and brings 0.041. So all lights bring 4.1, and a
  // choice by power, 1 to 49, also 4.1. Roulette as in furnace_radiance.
  const Furnace furnace = furnace_with_another();
  const double q = furnace.albedo.maxCoeff();
  const auto reference = [&](int c) {
    const double le = furnace.radiance[c], term = furnace.albedo[c] * le;
    return furnace.reference_within(c, le, GeometricSum{term, largest * term, q});
  };
  return estimand(name, std::move(subjects),
                  "with two spheres of one emission and reflectance, one in the other, the radiance is Le / (1 - "
                  "rho), per channel",
                  "geometric series of the transport operator", for_channels(reference),
                  RadianceAlong(furnace.scene, furnace.ray, make), 3);
}

/// Paths of at most `depth` bounces against the partial sum.
/// Bound    a bounce multiplies the throughput by at most `largest_weight` rho / q, and a shadow
///          ray brings at most `largest_weight` rho Le; q is 1 without roulette
template <class Tracer>
auto furnace_partial_sum(const std::string& name, std::vector<std::string> subjects, int depth,
                         double largest_weight) {
  const Furnace furnace;
  const auto reference = [&](int c) {
    double upper = 0;
    for (int k = 0; k <= depth; ++k) upper += std::pow(largest_weight * furnace.albedo[c], k);
    return Reference{furnace.reference(c, depth), 0, furnace.radiance[c] * upper * (1 + 1e-9)};
  };
  return estimand(
      name, std::move(subjects),
      formatted("inside a closed sphere the terms up to depth %d sum to Le (1 - rho^%d) / (1 - rho), per channel",
                depth, depth + 1),
      "geometric series of the transport operator", for_channels(reference),
      RadianceAlong(furnace.scene, furnace.ray, always(Tracer(depth))));
}

}  // namespace fairlight
