#pragma once

#include <fairlight/render/cornell.h>
#include <fairlight/render/path_tracer.h>
#include <fairlight/validation/analytic/sphere_over_plane.h>
#include <fairlight/validation/checks.h>

namespace fairlight {

/// Strategies that must have the same mean: the difference of independent draws has the mean 0. The margin is
/// relative to `scale`, the size of the two means, on which the verdict that they differ does not rest.

/// One of two unequal lights, weighted by |L|, against all of them, both by cone.
/// Bound: one of them counts twice, which is at most twice the sum of their largest terms.
template <class One, class All>
Claim one_against_all(const std::string& name) {
  return {name,
          "agreement",
          {"OneOf", "AllOf", "DirectLight"},
          "one of two unequal lights, weighted by their number, agrees with both, per channel",
          "the paper, A.1",
          2,
          [](const Trial& trial) {
            const SpheresOverPlane floor = two_lights();
            std::vector<Reference> references;
            for (int c = 0; c < 3; ++c) {
              const double all = floor.sum_of_cone_terms(c);
              references.push_back({0, -all, 2 * all, 0, floor.reference(c)});
            }
            const One one(1);
            const All both(1);
            return check_mean(trial, references, [&](auto& source) {
              const Rgb<double> a = one.template radiance<double>(floor.scene, floor.ray, source);
              return Rgb<double>(a - both.template radiance<double>(floor.scene, floor.ray, source));
            });
          }};
}

/// Roulette on against off, in the Cornell box, over a patch of its floor, up to four bounces.
/// Bound: the light's sphere, 4 pi r^2 = 9 pi, is nowhere nearer to a surface than 15 (the ceiling), so a shadow
/// ray brings at most 9 x 400 x 0.8 / 15^2 = 12.8, times a throughput of at most 1; there are four.
/// Scale: the light alone, unoccluded, shows 0.75 x 400 (r/d)^2 cos >= 0.75 x 400 (1.5/80)^2 (63/80) = 0.083 in grey, and
/// bounces and nearness make it about 0.25. 0.15 is taken, so the margin is no wider than it says.
template <class On, class Off>
Claim roulette_on_against_off(const std::string& name) {
  return {name,
          "agreement",
          {"RouletteByReflectance", "NoRoulette", "PathTracer"},
          "on the floor of the Cornell box, up to four bounces, roulette on agrees with roulette off, per channel",
          "the paper, 3.2.1",
          30,
          [](const Trial& trial) {
            const View box = built_in_scene("cornell-simple");
            const Vec3<double> eye(50, 52, 150);
            const Reference reference{0, -52, 52, 0, /*scale=*/0.15};
            const On on(4);
            const Off off(4);
            return check_mean(trial, {reference, reference, reference}, [&](auto& source) {
              const Vec2<double> u = next_pair<double>(source);
              const Vec3<double> target(30 + 40 * u.x(), 0, 95 + 40 * u.y());
              const Ray<double> ray{eye, (target - eye).normalized(), -1};
              const Rgb<double> a = on.template radiance<double>(box.scene, ray, source);
              return Rgb<double>(a - off.template radiance<double>(box.scene, ray, source));
            });
          }};
}

}  // namespace fairlight
