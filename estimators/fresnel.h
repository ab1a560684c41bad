#pragma once

#include <limits>
#include <stdexcept>

#include <fairlight/estimators/vec.h>

namespace fairlight {

/// Fresnel's equations: the fraction of unpolarised light that a smooth boundary reflects, in
/// [0,1]. `cosine` in [0,1], to rounding, is that of the angle to the normal on the incident side.
/// Outside the domain the result is NaN, so that an error shows in a picture. Above `largest_index`
/// it is NaN too, as the fourth power overflows in floats.
/// Source   Born and Wolf, Principles of Optics, 1.5 and 14.2; PBR 4ed, 9.3

/// The largest valid eta or k.
inline constexpr float largest_index = 1e6f;

/// Throws std::invalid_argument unless 0 < eta <= `largest_index` and 0 <= k <= `largest_index` in
/// every channel and lane.
template <class Real>
void require_conductor(const Rgb<Real>& eta, const Rgb<Real>& k) {
  bool inside = true;
  for (int c = 0; c < 3; ++c) {
    inside = inside && all_positive(eta[c]) && all_within(eta[c], 0, largest_index) &&
             all_within(k[c], 0, largest_index);
  }
  if (inside) return;
  throw std::invalid_argument(
      "a conductor's eta must be positive and its k nonnegative, neither above 1e6 (k is how it absorbs, it cannot "
      "emit)");
}

namespace detail {

/// (eta cos_t)^2, with cos_t the cosine of the refracted ray by Snell's law; negative at total
/// internal reflection. Computed from eta - 1, as eta^2 - sin^2 cancels at grazing angles.
template <class Real>
Real refracted_square(Real cosine, Real eta) {
  return (eta - Real(1)) * (eta + Real(1)) + cosine * cosine;
}

/// x, or 1 if x is 0. In the latter case the dividend is 0 or the quotient is unused.
template <class Real>
Real divisor(Real x) {
  return select(x > Real(0), x, Real(1));
}

/// The reflectance if the arguments are in their domain, else NaN. Allows for two directions that
/// are each a unit vector to within 256 ulp.
template <class Real>
Real share_in_domain(Real cosine, const Mask<Real>& indices, Real share) {
  const Real slack(512 * ulp<Real>);
  const Mask<Real> defined = indices && cosine >= -slack && cosine <= Real(1) + slack;
  return select(defined, share, Real(std::numeric_limits<Lane<Real>>::quiet_NaN()));
}

}  // namespace detail

/// Between two dielectrics (air, glass). `eta` in (0, 1e6] is the far side's index over the near
/// side's. Total internal reflection gives 1; eta = 1 gives 0 at every angle.
/// Formula  F = s^2 (1 + q^2) / 2, c = cosine, g = eta cos_t. Amplitude perpendicular to the plane
///          of incidence: s = (g - c) / (g + c) = (eta^2 - 1) / (g + c)^2; parallel: q s = s (c g -
///          sin^2) / (c g + sin^2)
/// Source   Cook and Torrance 1982; s is rewritten so that nothing cancels at grazing angles or eta
///          near 1
template <class Real>
Real fresnel_dielectric(Real cosine, Real eta) {
  using std::sqrt;
  const Real square = detail::refracted_square(cosine, eta);
  const Mask<Real> refracts = square >= Real(0);
  const Real g = sqrt(select(refracts, square, Real(0)));
  const Real sine_squared = (Real(1) - cosine) * (Real(1) + cosine);
  const Real sum = g + cosine;
  const Real s = (eta - Real(1)) * (eta + Real(1)) / detail::divisor(Real(sum * sum));
  const Real q = (cosine * g - sine_squared) / (cosine * g + sine_squared);
  const Real share = select(refracts, Real(Real(0.5) * s * s * (Real(1) + q * q)), Real(1));
  return detail::share_in_domain(cosine, eta > Real(0) && eta <= Real(largest_index), share);
}

/// From a dielectric to a conductor. Its complex index eta + i k, eta in (0, 1e6], k in [0, 1e6],
/// is relative to the dielectric's.
/// Formula  F = (s + p) / 2, c = cosine, (a + i b)^2 = (eta + i k)^2 - sin^2. Perpendicular to the
///          plane of incidence: s = |a + i b - c|^2 / |a + i b + c|^2; parallel: p = s |c (a + i b)
///          - sin^2|^2 / |c (a + i b) + sin^2|^2
/// Source   Born and Wolf, 14.2; PBR 4ed, 9.3.6
template <class Real>
Real fresnel_conductor(Real cosine, Real eta, Real k) {
  using std::abs;
  using std::sqrt;
  const Real sine_squared = (Real(1) - cosine) * (Real(1) + cosine);
  const Real difference = detail::refracted_square(cosine, eta) - k * k;  // a^2 - b^2
  const Real product = eta * k;                                           // a b
  // The larger of a^2 and b^2 is a sum. The smaller is (a b)^2 divided by the larger, so that
  // nothing cancels.
  const Real larger = Real(0.5) * (abs(difference) + sqrt(difference * difference + Real(4) * product * product));
  const Real smaller = product * product / detail::divisor(larger);
  const Mask<Real> refracts_more = difference >= Real(0);
  const Real a = sqrt(select(refracts_more, larger, smaller));
  const Real b_squared = select(refracts_more, smaller, larger);
  const auto ratio = [](Real x, Real y, Real imaginary_squared) {  // |x + iz - y|^2 / |x + iz + y|^2
    const Real sum = (x + y) * (x + y) + imaginary_squared;
    return Real(((x - y) * (x - y) + imaginary_squared) / detail::divisor(sum));
  };
  const Real s = ratio(a, cosine, b_squared);
  const Real p = s * ratio(Real(cosine * a), sine_squared, Real(cosine * cosine * b_squared));
  const Real largest(largest_index);
  const Mask<Real> indices = eta > Real(0) && eta <= largest && k >= Real(0) && k <= largest;
  return detail::share_in_domain(cosine, indices, Real(Real(0.5) * (s + p)));
}

/// Per channel.
template <class Real>
Rgb<Real> fresnel_conductor(Real cosine, const Rgb<Real>& eta, const Rgb<Real>& k) {
  return {fresnel_conductor(cosine, eta[0], k[0]), fresnel_conductor(cosine, eta[1], k[1]),
          fresnel_conductor(cosine, eta[2], k[2])};
}

}  // namespace fairlight
