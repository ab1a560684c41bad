#pragma once

#include <limits>
#include <stdexcept>

#include <fairlight/estimators/vec.h>

namespace fairlight {

/// Fresnel's equations: the share of unpolarised light that a smooth boundary reflects, in [0,1]. `cosine` is that of the
/// angle to the normal on the side that the light comes from, in [0,1], to rounding. Outside the domain the share is not a
/// number, lest a picture hide it. Nor is it above `largest_index`, where floats do not hold the square of a square.
/// Source   Born and Wolf, Principles of Optics, 1.5 and 14.2; PBR 4ed, 9.3

/// The largest eta or k.
inline constexpr float largest_index = 1e6f;

/// Throws std::invalid_argument unless eta > 0 and k >= 0 in every channel and lane, and neither is above `largest_index`.
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

/// (eta cos_t)^2, cos_t the cosine of the refracted ray by Snell's law; negative where there is none. Of eta - 1 and not of
/// eta^2, lest at grazing angles little be left of a difference.
template <class Real>
Real refracted_square(Real cosine, Real eta) {
  return (eta - Real(1)) * (eta + Real(1)) + cosine * cosine;
}

/// x, or 1 where x is 0: a divisor whose quotient is not used, or of 0, there.
template <class Real>
Real divisor(Real x) {
  return select(x > Real(0), x, Real(1));
}

/// A share where its arguments are in their domain. Two directions may each be a unit vector to within 256 ulp.
template <class Real>
Real share_in_domain(Real cosine, const Mask<Real>& indices, Real share) {
  const Real slack(512 * ulp<Real>);
  const Mask<Real> defined = indices && cosine >= -slack && cosine <= Real(1) + slack;
  return select(defined, share, Real(std::numeric_limits<Lane<Real>>::quiet_NaN()));
}

}  // namespace detail

/// Between two insulators (air, glass). `eta` in (0, 1e6] is the index of refraction on the far side over that on the near side; at
/// total internal reflection all is reflected, and at eta = 1 nothing is, at any angle.
/// Formula  F = s^2 (1 + q^2) / 2, where c = cosine, g = eta cos_t, s = (g - c) / (g + c) = (eta^2 - 1) / (g + c)^2 is the
///          amplitude polarised across the plane of incidence, and q s = s (c g - sin^2) / (c g + sin^2) that along it
/// Source   Cook and Torrance 1982, in c and g, with s written so that nothing cancels at grazing angles or eta near 1
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

/// From an insulator to a conductor of complex index eta + i k, relative to the insulator's: eta in (0, 1e6], k in [0, 1e6].
/// Formula  (a + i b)^2 = (eta + i k)^2 - sin^2 and c = cosine give the shares polarised across and along the plane of
///          incidence, s = |a + i b - c|^2 / |a + i b + c|^2, p = s |c (a + i b) - sin^2|^2 / |c (a + i b) + sin^2|^2;
///          F = (s + p) / 2
/// Source   Born and Wolf, 14.2; PBR 4ed, 9.3.6
template <class Real>
Real fresnel_conductor(Real cosine, Real eta, Real k) {
  using std::abs;
  using std::sqrt;
  const Real sine_squared = (Real(1) - cosine) * (Real(1) + cosine);
  const Real difference = detail::refracted_square(cosine, eta) - k * k;  // a^2 - b^2
  const Real product = eta * k;                                           // a b
  // The larger of a^2 and b^2 is a sum; the smaller is the product's square over it, not a difference.
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

/// The same per channel.
template <class Real>
Rgb<Real> fresnel_conductor(Real cosine, const Rgb<Real>& eta, const Rgb<Real>& k) {
  return {fresnel_conductor(cosine, eta[0], k[0]), fresnel_conductor(cosine, eta[1], k[1]),
          fresnel_conductor(cosine, eta[2], k[2])};
}

}  // namespace fairlight
