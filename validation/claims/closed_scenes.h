#pragma once

#include <algorithm>
#include <functional>

#include <fairlight/render/built_in_scenes.h>
#include <fairlight/validation/claims/radiance.h>

namespace fairlight {

/// A scene whose camera sees the same radiance everywhere: one surface with the same radiance at
/// each point. In a picture of any size, by any strategy, lens and filter, every pixel has this
/// mean.
struct ClosedScene {
  View view;
  /// The radiance, per channel, from paths of at most `depth` bounces.
  std::function<Rgb<double>(int depth)> radiance;
  Rgb<double> largest_term;  ///< the most that the shadow rays of a vertex bring
  double index = 1;  ///< refractive index of its glass, inside which a path carries 1/index^2 of its radiance

  /// The largest emission of a surface.
  Rgb<double> brightest() const {
    Rgb<double> most(0, 0, 0);
    for (const Surface& surface : view.scene.surfaces()) most = most.max(surface.radiance);
    return most;
  }
  /// The largest albedo.
  double whitest() const {
    double most = 0;
    for (const Surface& surface : view.scene.surfaces()) most = std::max(most, surface.material.albedo.maxCoeff());
    return most;
  }
};

/// A sphere within a sphere, both diffuse and emitting, with different radii, albedos and
/// emissions. By symmetry the radiance of each is the same at all its points. The camera is between
/// them and looks outwards.
/// Formula  L_outer = Le_outer + rho_outer ((1 - F) L_outer + F L_inner),
///          L_inner = Le_inner + rho_inner L_outer, depth by depth from Le. F = (r/R)^2 is the
///          share of the light leaving the outer sphere that reaches the inner one.
/// Source   form factors by reciprocity, A_1 F_12 = A_2 F_21; Goral et al. 1984
inline ClosedScene concentric_spheres() {
  // Bound, with R = 2 r. By area a shadow ray brings at most 4 R^2 rho Le / (R - r)^2 = 16 rho Le
  // from the inner sphere to the outer one, 4 r^2 rho Le / (R - r)^2 = 4 rho Le from the outer to
  // the inner one, and rho Le within the outer one. By cone each brings at most 4 rho Le, as the
  // cone can be all directions. The light sampler picks either sphere with a probability of at
  // least 1/4: the weights (outer : inner) are 56 : 20 by power, and by contribution at the outer
  // sphere; they are 3.5 : 5 by contribution at the inner one. Shadow rays to all lights bring no
  // more.
  const Vec3<double> centre(1, -2, 3);
  const Rgb<double> outer(0.2, 0.4, 0.6), inner(0.25, 0.15, 0.05), from_outer(1, 2, 0.5), from_inner(3, 1, 1);
  Scene scene;
  scene.add_sphere(centre, 4, outer, from_outer);
  scene.add_sphere(centre, 2, inner, from_inner);
  const Camera camera({.eye = centre + Vec3<double>(0, 1, -3), .look = {0.1, 0.3, -1}, .focus_distance = 0.5});
  const auto radiance = [=](int depth) {
    Rgb<double> on_outer = from_outer, on_inner = from_inner;
    for (int k = 0; k < depth; ++k) {
      const Rgb<double> before = on_outer;
      on_outer = from_outer + outer * (0.75 * before + 0.25 * on_inner);
      on_inner = from_inner + inner * before;
    }
    return on_outer;
  };
  const Rgb<double> on_outer = 4 * outer * from_outer.max(from_inner), on_inner = 16 * inner * from_outer;
  return {{"concentric_spheres", scene, camera}, radiance, on_outer.max(on_inner) / 0.25};
}

/// Six emitting rectangles that form a box of 2 x 3 x 4. Every ray ends on a surface that emits Le
/// and reflects rho.
/// Formula  L = Le (1 + rho + rho^2 + ...)
/// Source   geometric series of the transport operator
inline ClosedScene lit_box() {
  // Bound. By solid angle the other faces fill the hemisphere, so all of them bring at most 2 rho
  // Le. A face picked with the probability P brings S rho Le / (pi P), with S < pi. By power
  // P >= 6/52. By contribution the weights are A / max(d^2, R^2), with R half of a face's diagonal,
  // and their sum is below 10.74. A weight of at least 0.6 has P > 1/18. A smaller weight belongs
  // to a face so far away (d^2 > 10) that S < 0.9, and has P > 0.029. Together: 18 rho Le. Where
  // bounces share the light with shadow rays, also by area, a ray brings at most w rho Le, with
  // w = 2 for uniform bounces; six of them bring 12 rho Le.
  const Rgb<double> albedo(0.3, 0.5, 0.7), radiance(1, 2, 0.5);
  const Vec3<double> corner(-1, 0.5, 2), x(2, 0, 0), y(0, 3, 0), z(0, 0, 4);
  Scene scene;
  scene.add_rectangle(corner, x, y, albedo, radiance);
  scene.add_rectangle(corner + z, x, y, albedo, radiance);
  scene.add_rectangle(corner, y, z, albedo, radiance);
  scene.add_rectangle(corner + x, y, z, albedo, radiance);
  scene.add_rectangle(corner, z, x, albedo, radiance);
  scene.add_rectangle(corner + y, z, x, albedo, radiance);
  const Camera camera({.eye = corner + Vec3<double>(0.8, 1.7, 2.1), .look = {0.4, 0.3, -1}, .focus_distance = 1.5});
  const auto reference = [=](int depth) {
    Rgb<double> sum = radiance;
    for (int k = 0; k < depth; ++k) sum = radiance + albedo * sum;
    return sum;
  };
  return {{"lit_box", scene, camera}, reference, 18 * albedo * radiance};
}

/// The white furnace: under a sky of constant radiance Le, objects that reflect all light are
/// invisible. A white ball, a mirror and glass, which also light each other, show Le. Only bounces
/// find the light; every path ends in the sky, with all that it left with.
/// Bound    Le: every path brings exactly this. Except that inside glass a path carries Le / n^2,
///          so roulette by throughput may end it there, and a survivor brings n^2 Le.
/// Source   reciprocity and conservation of energy; Veach 1997, 6.3
inline ClosedScene white_sky() {
  const Rgb<double> none(0, 0, 0), white(1, 1, 1), radiance(1, 2, 0.5);
  Scene scene;
  scene.add_sphere({0, 0, 0}, 16, none, radiance);
  scene.add_sphere({-2.2, 0, 0}, 1, white, none);
  scene.add_sphere({0, 0.3, -1}, 1, Material(Material::Kind::mirror, white, 1), none);
  constexpr double index = 1.5;
  scene.add_sphere({2.2, -0.2, 0.5}, 1, Material(Material::Kind::glass, white, index), none);
  const Camera camera({.eye = {0, 0, 6}, .look = {0, 0, -1}, .focus_distance = 6});
  return {{"white_sky", scene, camera}, [=](int) { return radiance; }, {0, 0, 0}, index};
}

/// The white ball alone. It is convex, so a path has one bounce.
/// Bound    by cone, which is all directions, a shadow ray brings 4 Le; by area 4 R^2
///          Le / (R - r)^2 < 5 Le
/// Source   as above; the irradiance under a constant sky is pi Le
inline ClosedScene white_ball(const std::string& name = "white_ball", double brightness = 1) {
  const Rgb<double> none(0, 0, 0), radiance = brightness * Rgb<double>(1, 2, 0.5);
  Scene scene;
  scene.add_sphere({0, 0, 0}, 16, none, radiance);
  scene.add_sphere({0, 0, 0}, 1, Rgb<double>(1, 1, 1), none);
  const Camera camera({.eye = {0, 0, 4}, .look = {0, 0, -1}, .focus_distance = 3});
  return {{name, scene, camera}, [=](int) { return radiance; }, 5 * radiance};
}

/// A grey ball under a sky of radiance 1, which fills the picture. Roulette by albedo ends half of
/// the paths, so a sample is 0 or 1, each with probability 1/2.
inline ClosedScene grey_ball() {
  const Rgb<double> none(0, 0, 0), one(1, 1, 1);
  Scene scene;
  scene.add_sphere({0, 0, 0}, 16, none, one);
  scene.add_sphere({0, 0, 0}, 1, Rgb<double>(0.5, 0.5, 0.5), none);
  const Camera camera({.eye = {0, 0, 1.2}, .look = {0, 0, -1}, .focus_distance = 0.2});
  return {{"grey_ball", scene, camera}, [](int) { return Rgb<double>(0.5, 0.5, 0.5); }, none};
}

/// Paths of three bounces in the box, where every vertex is on a luminaire and the camera sees one
/// everywhere. Errors there come from rounding, and are small.
/// Bound    at each vertex all faces bring at most 2 rho Le, and a bounce that shares the light
///          with them rho Le
template <class Direct>
auto in_lit_box(const std::string& how) {
  constexpr int depth = 3;
  const ClosedScene box = lit_box();
  const auto tracer = always(PathTracer<BouncesBy<CosineHemisphere>, Direct, NoRoulette>(depth));
  const RadianceAlong radiance(box.view.scene, tracer);
  const auto draw = [camera = box.view.camera, radiance]<class Real>(std::type_identity<Real> real, auto& source) {
    const Vec2<Real> place = next_pair<Real>(source);
    return radiance.along(camera.template ray<Real>(place.x(), place.y(), 1, 1), real, source);
  };
  const auto reference = [&](int c) {
    return Reference{box.radiance(depth)[c], 0, (1 + depth * 3 * box.whitest()) * box.brightest()[c]};
  };
  return estimand(
      "lit_box." + how, {"DirectLight", "AllLights", "RectangleBySolidAngle"},
      "inside a box of lit rectangles the terms up to depth 3 sum to Le (1 - rho^4) / (1 - rho), per channel",
      "geometric series of the transport operator", for_channels(reference), draw, 2);
}

}  // namespace fairlight
