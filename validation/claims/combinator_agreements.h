#pragma once

#include <fairlight/render/built_in_scenes.h>
#include <fairlight/validation/claims/sphere_over_plane.h>

namespace fairlight {

/// Strategies that must have the same mean: the difference of independent draws has mean 0. The
/// margin is relative to `scale`, the size of the two means. The verdict `biased` does not depend
/// on `scale`.

/// One of two unequal lights, weighted by |L|, against both, all by cone.
/// Bound    the one counts twice, which is at most twice the sum of the largest terms
template <class One, class All>
auto one_against_all(const std::string& name) {
  const SpheresOverPlane floor = two_lights();
  const auto reference = [&](int c) {
    const double all = floor.sum_of_cone_terms(c);
    return Reference{0, -all, 2 * all, 0, floor.reference(c)};
  };
  const RadianceAlong one(floor.scene, floor.ray, always(One(1)));
  const RadianceAlong both(floor.scene, floor.ray, always(All(1)));
  const auto draw = [=]<class Real>(std::type_identity<Real> real, auto& source) {
    const Rgb<Real> a = one(real, source);
    return Rgb<Real>(a - both(real, source));
  };
  return estimand(name, {"UniformLightSampler", "AllLights", "DirectLight"},
                  "one of two unequal lights, weighted by their number, agrees with both, per channel",
                  "the paper, A.1", for_channels(reference), draw, 2);
}

/// Roulette on against roulette off, over a patch of the floor of the Cornell box, up to four
/// bounces.
template <class On, class Off>
auto roulette_on_against_off(const std::string& name) {
  // Bound: the light has the area 4 pi r^2 = 9 pi and is at least 15 from every surface (the
  // ceiling). So a shadow ray brings at most 9 x 400 x 0.8 / 15^2 = 12.8, times a throughput of at
  // most 1; there are four.
  // Scale: the light alone, unoccluded, gives 0.75 x 400 (r/d)^2 cos >= 0.75 x 400 (1.5/80)^2
  // (63/80) = 0.083 in grey; bounces and shorter distances raise it to about 0.25. The scale is
  // 0.15, so the margin is no wider than stated.
  const View box = built_in_scene("cornell-simple");
  const Vec3<double> eye(50, 52, 150);
  const Ray<double> down{eye, {0, -1, 0}, -1};
  const RadianceAlong on(box.scene, down, always(On(4)));
  const RadianceAlong off(box.scene, down, always(Off(4)));
  const auto draw = [=]<class Real>(std::type_identity<Real> real, auto& source) {
    const Vec2<Real> u = next_pair<Real>(source);
    const Vec3<Real> from = rounded_vector<Real>(eye);
    const Vec3<Real> way = Vec3<Real>(Real(30) + Real(40) * u.x(), Real(0), Real(95) + Real(40) * u.y()) - from;
    const Ray<Real> ray{from, way / way.norm(), Real(-1)};
    auto ahead = source.take(14);  // four shadow rays and three bounces
    const Rgb<Real> without = off.along(ray, real, ahead);
    return Rgb<Real>(on.along(ray, real, source) - without);
  };
  const Reference reference{0, -52, 52, 0, /*scale=*/0.15};
  return estimand(name, {"RouletteByReflectance", "NoRoulette", "PathTracer"},
                  "on the floor of the Cornell box, up to four bounces, roulette on agrees with roulette off, per "
                  "channel",
                  "the paper, 3.2.1", {reference, reference, reference}, draw, 30);
}

}  // namespace fairlight
