#pragma once

#include <algorithm>
#include <functional>

#include <fairlight/render/built_in_scenes.h>
#include <fairlight/validation/claims/radiance.h>

namespace fairlight {

/// A scene whose camera sees one radiance everywhere, that of a surface that is the same all over: so a picture of it, of any size,
/// by any strategy and through any lens and filter, has that mean in every pixel.
struct ClosedScene {
  View view;
  /// The radiance, per channel, of paths of at most so many bounces.
  std::function<Rgb<double>(int depth)> radiance;
  Rgb<double> largest_term;  ///< what the shadow rays of a vertex bring at most
  double index = 1;          ///< of its glass, in which a path carries so much less in square

  /// What a surface emits at most.
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

/// A sphere within a sphere, both diffuse and lit, unlike in everything. Of what leaves the outer one F = (r/R)^2 goes to the inner one, and
/// all that leaves the inner one to the outer one (form factors of concentric spheres), so that
///   L_outer = Le_outer + rho_outer ((1 - F) L_outer + F L_inner),   L_inner = Le_inner + rho_inner L_outer,
/// depth by depth from what they emit. By symmetry each has one radiance all over; the camera stands between and looks outwards.
/// Bound: R = 2 r. By area a shadow ray from the inner sphere to the outer one brings at most 4 R^2 rho Le / (R - r)^2 = 16 rho Le, one
/// from the outer to the inner one 4 r^2 rho Le / (R - r)^2 = 4 rho Le, and one within the outer rho Le; by cone each brings 4 rho Le at most, as the
/// cone may be all directions. One of the two is chosen with 1/4 at least: outer to inner is 56 : 20 by power, and by contribution at the outer
/// sphere; 3.5 : 5 at the inner one. All of them bring no more.
/// Source: form factors by reciprocity, A_1 F_12 = A_2 F_21, all of the inner sphere's light going to the outer one; Goral et al. 1984
inline ClosedScene concentric_spheres() {
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

/// Six lit rectangles about a box of 2 x 3 x 4: every ray ends on what emits Le and reflects rho, so that L = Le (1 + rho + rho^2 + ...).
/// Bound: by solid angle the other faces fill the hemisphere, so all of them bring 2 rho Le at most, and a face that is
/// chosen with P brings S rho Le / (pi P), with S < pi. By power P >= 6/52. By contribution, weights being A / max(d^2, R^2) with R half of a face's
/// diagonal, their sum is below 10.74; a weight of 0.6 has P > 1/18, and one below that is of a face so far off (d^2 > 10) that S < 0.9 and
/// P > 0.029. So 18 rho Le. Where bounces share the light, also by area, a ray brings w rho Le at most, with w = 2 by uniform bounces;
/// six of them 12 rho Le.
/// Source: geometric series of the transport operator
inline ClosedScene lit_box() {
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

/// Under a sky of one radiance what reflects all light is not seen: a white ball, a mirror and glass, which light each other too, show Le as
/// the sky does (the white furnace). By bounces alone, as long as they go: every path ends in the sky, with all that it left with.
/// Bound: that of the sky itself, as no path brings more or less; but roulette by throughput takes what a path carries in glass for little,
/// Le / n^2, so that survivors leave it with n^2 Le.
/// Source: reciprocity and conservation of energy; Veach 1997, 6.3
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

/// The ball alone, which is convex, so that one bounce is all.
/// Bound: by cone, which is all directions, a shadow ray brings 4 Le; by area 4 R^2 Le / (R - r)^2 < 5 Le.
/// Source: as above; the irradiance under a constant sky is pi Le
inline ClosedScene white_ball() {
  const Rgb<double> none(0, 0, 0), radiance(1, 2, 0.5);
  Scene scene;
  scene.add_sphere({0, 0, 0}, 16, none, radiance);
  scene.add_sphere({0, 0, 0}, 1, Rgb<double>(1, 1, 1), none);
  const Camera camera({.eye = {0, 0, 4}, .look = {0, 0, -1}, .focus_distance = 3});
  return {{"white_ball", scene, camera}, [=](int) { return radiance; }, 5 * radiance};
}

/// Paths of three bounces in the box, where every vertex lies on a luminaire, wherever the camera looks: what goes wrong there is rounding, and small.
/// Bound: at each vertex all faces bring 2 rho Le at most, and a bounce that shares the light with them rho Le.
template <class Direct>
auto in_lit_box(const std::string& how) {
  constexpr int depth = 3;
  const ClosedScene box = lit_box();
  const auto tracer = always(PathTracer<BouncesBy<CosineHemisphere>, Direct, NoRoulette>(depth));
  const RadianceAlong radiance(box.view.scene, Ray<double>{{0, 0, 0}, {0, 0, 1}, -1}, tracer);
  const auto draw = [camera = box.view.camera, radiance]<class Real>(std::type_identity<Real> real, auto& source) {
    const Vec2<Real> place = next_pair<Real>(source);
    return radiance.along(camera.template ray<Real>(place.x(), place.y(), 1, 1), real, source);
  };
  std::vector<Reference> references;
  for (int c = 0; c < 3; ++c)
    references.push_back({box.radiance(depth)[c], 0, (1 + depth * 3 * box.whitest()) * box.brightest()[c]});
  return Estimand{
      "lit_box." + how,
      {"DirectLight", "AllLights", "RectangleBySolidAngle"},
      "inside a box of lit rectangles the terms up to depth 3 sum to Le (1 - rho^4) / (1 - rho), per channel",
      "geometric series of the transport operator",
      2,
      references,
      draw};
}

}  // namespace fairlight
