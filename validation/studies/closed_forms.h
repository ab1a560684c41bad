#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

/// Closed forms that the studies measure against.
namespace fairlight::closed_forms {

/// The variance of the reflected radiance of a surface of albedo 1 at normal incidence, under a sky of
/// radiance 1 on one side of a vertical plane and 0 on the other. One draw is f cos / p.
/// Uniform: f cos / p = 2 z diffuse, (n + 2) z^(n+1) glossy, with z uniform in [0,1); in half of the
/// draws. By the BRDF: 1 diffuse, (n + 2)/(n + 1) z glossy, with z^(n+1) uniform.
inline double diffuse_uniform_variance() { return 2.0 / 3 - 0.25; }
inline double diffuse_cosine_variance() { return 0.25; }
inline double glossy_uniform_variance(double n) { return (n + 2) * (n + 2) / (2 * (2 * n + 3)) - 0.25; }
inline double glossy_lobe_variance(double n) { return (n + 2) * (n + 2) / (2 * (n + 1) * (n + 3)) - 0.25; }

/// A die with the faces 1 to 6 and these probabilities, as a mean and a mean square.
struct Die {
  double mean, mean_square;
};
inline Die die_of(const std::array<double, 6>& probabilities) {
  Die die{0, 0};
  for (int face = 1; face <= 6; ++face) {
    const double p = probabilities[static_cast<std::size_t>(face - 1)];
    die.mean += face * p;
    die.mean_square += face * face * p;
  }
  return die;
}

/// The variance of the sum of two independent dice, and that of twice the throw of one of them, chosen
/// with probability 1/2: E[(2 X)^2] is the mean of the two mean squares times 4.
inline double two_dice_variance(const Die& a, const Die& b) {
  return a.mean_square - a.mean * a.mean + b.mean_square - b.mean * b.mean;
}
inline double one_die_variance(const Die& a, const Die& b) {
  return 2 * (a.mean_square + b.mean_square) - (a.mean + b.mean) * (a.mean + b.mean);
}

/// The radiance that a path tracer finds which counts emission at every vertex besides the shadow
/// rays. With the transport operator T it is L' = Le + T Le + T L', where T Le is the shadow rays'
/// part, so L' = L + (T + T^2 + ...) Le = 2 L - Le: all reflected light is counted twice.
inline double double_counted(double radiance, double emitted) { return 2 * radiance - emitted; }

/// The area of the picture of a sphere on the image plane at distance 1: an ellipse. The sphere's
/// cone has the half angle a, and its axis the angle b from that of the camera; a + b < 90 degrees.
/// Source   the section of a circular cone by a plane; semi-axes sin a cos a / (cos^2 b - sin^2 a)
///          and sin a / sqrt(cos^2 b - sin^2 a)
inline double sphere_picture_area(double half_angle, double off_axis) {
  const double sine = std::sin(half_angle), cosine = std::cos(off_axis);
  return std::numbers::pi * sine * sine * std::cos(half_angle) / std::pow(cosine * cosine - sine * sine, 1.5);
}

}  // namespace fairlight::closed_forms
