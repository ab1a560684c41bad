#pragma once

#include <cmath>

#include <fairlight/estimators/lambertian.h>
#include <fairlight/estimators/roulette.h>
#include <fairlight/validation/checks/estimand.h>

namespace fairlight {

/// A path from one diffuse surface to the next that sums its throughput at each, and ends only by
/// roulette. The sum is that of the powers of the albedo, 1 / (1 - albedo), for each channel.
/// Bound    a bounce has the weight albedo or, with uniform directions, 2 albedo z. So the
///          throughput is at most `most`, 1 or 2, and the sum at most this times the number N of
///          vertices. From bounce `first` on, the path goes on with a mean probability of at most
///          q, the largest albedo, so N - first is at most geometric, and
///          E[(N - K)+] <= q^(K + 1 - first) / (1 - q).
template <class Roulette, template <class> class Directions>
auto roulette_walk(const std::string& name, const std::string& subject, double most, int first = 1,
                   const Roulette& roulette = Roulette()) {
  const Rgb<double> albedo(0.125, 0.25, 0.05);
  const double q = albedo.maxCoeff();
  const int vertices = 16 + first;  // the tail is negligible for the finest margins
  const double slack = most * std::pow(q, vertices + 1 - first) / (1 - q);
  const auto reference = [&](int c) { return Reference{1 / (1 - albedo[c]), 0, most * vertices, slack}; };
  const auto draw = [=]<class Real>(std::type_identity<Real>, auto& source) {
    const Rgb<Real> reflectance = rounded_colour<Real>(albedo);
    const Lambertian<Real, Directions> surface(reflectance);
    const Vec3<Real> out(Real(0), Real(0), Real(1));
    Rgb<Real> sum = Rgb<Real>::Zero();
    Rgb<Real> throughput = Rgb<Real>::Ones();
    for (int depth = 0; any(max_channel(throughput) > Real(0)); ++depth) {
      sum += throughput;
      const auto [alive, weight] =
          roulette.template play<Real>(reflectance, throughput, rounded<Real>(depth), source);
      const auto bounce = surface.sample(out, next_pair<Real>(source));
      throughput = select(alive, Rgb<Real>(throughput * bounce.weight * weight), zero<Rgb<Real>>());
    }
    return sum;
  };
  return estimand(name, {subject}, "bounces without end carry 1 / (1 - albedo) together, per channel",
                  "geometric series", for_channels(reference), draw);
}

/// The same without roulette at the first bounce.
template <template <class> class FromBounce>
auto later_roulette_walk() {
  using Later = FromBounce<RouletteByThroughput<>>;
  return roulette_walk<Later, UniformHemisphere>("roulette.walk.throughput_later", "RouletteFromBounce", 2, 2,
                                                 Later(2));
}

/// The number of vertices of a path, which is its cost, on surfaces with albedos of at most 1/4. No
/// mean of the throughput shows that paths are too long. The tail, E[(N - 17)+], is that of a path
/// that goes on with probability 1/4; it is the same if the first bounce is certain and the second
/// has probability 1/16.
template <class Roulette>
auto walk_length(const std::string& name, const std::string& subject, const std::string& statement, double mean,
                 const Roulette& roulette) {
  constexpr double q = 0.25;
  constexpr int vertices = 17;
  const auto draw = [roulette]<class Real>(std::type_identity<Real>, auto& source) {
    const Rgb<Real> reflectance(Real(0.125), Real(q), Real(0.0625));
    Rgb<Real> throughput = Rgb<Real>::Ones();
    Real length(1);
    Mask<Real> alive(true);
    for (int depth = 0; any(alive); ++depth) {
      const auto [goes_on, weight] =
          roulette.template play<Real>(reflectance, throughput, rounded<Real>(depth), source);
      alive = alive && goes_on;
      throughput *= reflectance * weight;
      length += select(alive, Real(1), Real(0));
    }
    return length;
  };
  return estimand(name, {subject}, statement, "geometric series; the paper, 3.2.1",
                  {{mean, 0, vertices, std::pow(q, vertices) / (1 - q)}}, draw, 2);
}

template <class Roulette>
auto roulette_walk_length() {
  return walk_length("roulette.walk.length", "RouletteByReflectance",
                     "a path that goes on with the largest reflectance, 1/4, has 4/3 vertices", 4.0 / 3,
                     Roulette());
}

/// The second bounce leaves a throughput of 1/4 x 1/4, each later one 1/4, as a survivor carries 1.
template <class Roulette>
auto later_roulette_walk_length() {
  return walk_length(
      "roulette.walk.length_later", "RouletteByThroughput",
      "a path that goes on from its second bounce with what it will carry, 1/16 and then 1/4, has 25/12 "
      "vertices",
      2 + 1.0 / 16 / (1 - 0.25), RouletteFromBounce<Roulette>(2));
}

}  // namespace fairlight
