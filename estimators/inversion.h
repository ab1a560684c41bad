#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include <fairlight/estimators/packet.h>

namespace fairlight::detail {

/// For samplers whose CDF has no inverse in closed form: a start near the root, and steps that
/// converge to it. Both take the same number of operations for every random number, so they work
/// lane by lane.

/// The y with erf(y) = p >= 0. The argument q = 1 - p is the accurate one near p = 1. Relative
/// error 4e-7 for q >= 1e-7.
/// Source   Giles 2012, "Approximating the erfinv function", single precision
template <class Real>
Real rough_inverse_erf(Real p, Real q) {
  using std::log;
  using std::sqrt;
  constexpr std::array<double, 9> central{2.81022636e-08,  3.43273939e-07, -3.5233877e-06,
                                          -4.39150654e-06, 0.00021858087,  -0.00125372503,
                                          -0.00417768164,  0.246640727,    1.50140941};
  constexpr std::array<double, 9> tail{-0.000200214257, 0.000100950558, 0.00134934322,
                                       -0.00367342844,  0.00573950773,  -0.0076224613,
                                       0.00943887047,   1.00167406,     2.83297682};
  const Real w = -log(q * (Real(2) - q));
  const Mask<Real> near = w < Real(5);
  const Real x = select(near, Real(w - Real(2.5)), Real(sqrt(select(near, Real(5), w)) - Real(3)));
  Real polynomial(0);
  for (std::size_t i = 0; i < central.size(); ++i) {
    polynomial = polynomial * x + select(near, rounded<Real>(central[i]), rounded<Real>(tail[i]));
  }
  return polynomial * p;
}

/// One Halley step towards the root of an increasing function, from x in [low, high]. A step that
/// would leave the interval goes half way to that end instead. Triples the number of correct
/// digits.
/// Source   Householder 1970
template <class Real>
Real halley_step(Real x, Real value, Real slope, Real curvature, Real low, Real high) {
  const Real newton = value / slope;
  const Real next = x - newton / (Real(1) - newton * curvature / (Real(2) * slope));
  const Real not_above = select(next <= high, next, Real(Real(0.5) * (x + high)));
  return select(next >= low, not_above, Real(Real(0.5) * (x + low)));
}

}  // namespace fairlight::detail
