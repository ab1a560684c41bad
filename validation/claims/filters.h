#pragma once

#include <cmath>
#include <numbers>

#include <fairlight/validation/checks/estimand.h>

namespace fairlight {

/// The mean squared offset of a filter along an axis, in closed form [pixel^2]. r is the reach:
///   box            r^2 / 3
///   tent           1/6, for a reach of 1
///   Gaussian       s^2 (1 - 2 a phi(a) / (2 Phi(a) - 1)), a = r/s, cut off at r
///   cosine series  r^2 (1/3 + sum 2 (-1)^k (a_k / a_0) / (k pi)^2),
///                  as int_0^1 x^2 cos(k pi x) dx = 2 (-1)^k / (k pi)^2
inline double cut_gaussian_moment(double deviation, double reach) {
  const double a = reach / deviation;
  const double density = std::exp(-a * a / 2) / std::sqrt(2 * std::numbers::pi);
  return deviation * deviation * (1 - 2 * a * density / std::erf(a / std::numbers::sqrt2));
}

inline double blackman_harris_moment(double reach) {
  constexpr double a[] = {0.35875, 0.48829, 0.14128, 0.01168};  // Harris 1978
  double sum = 1.0 / 3;
  for (int k = 1; k < 4; ++k) {
    const double turn = k * std::numbers::pi;
    sum += 2 * (k % 2 == 1 ? -1 : 1) * a[k] / a[0] / (turn * turn);
  }
  return reach * reach * sum;
}

/// The means of 1 - x^2 / reach^2, of the same in y, and of their product, over the offsets of a
/// filter. They are in [0,1], and vary less than x^2.
template <class Make>
auto filter_moment(const std::string& name, const std::string& subject, double moment, double reach,
                   const Make& make) {
  const auto draw = [=]<class Real>(std::type_identity<Real> real, auto& source) {
    const Vec2<Real> x = make(real).sample(next_pair<Real>(source));
    const auto within = [=](Real offset) { return Real(Real(1) - offset * offset / rounded<Real>(reach * reach)); };
    return Rgb<Real>(within(x.x()), within(x.y()), (within(x.x()) + within(x.y())) / Real(2));
  };
  const Reference reference{1 - moment / (reach * reach), -1e-12, 1};
  return estimand(name + ".spread", {subject},
                  "one less the mean squared offset over the reach's square, along either axis and over both, is "
                  "the closed form",
                  "elementary", {reference, reference, reference}, draw);
}

}  // namespace fairlight
