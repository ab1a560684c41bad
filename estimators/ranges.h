#pragma once

#include <stdexcept>
#include <string>

#include <fairlight/estimators/vec.h>

namespace fairlight {

/// The ranges in which the squares and products that a component computes neither overflow nor
/// underflow in its Real. Components throw outside them.

/// Whether Real is a float, or a packet of floats.
template <class Real>
inline constexpr bool in_floats = sizeof(Lane<Real>) == sizeof(float);

/// The longest edge or radius of a light, and the largest coordinate [m]. The shortest edge or
/// radius is 1 / longest.
template <class Real>
inline constexpr double longest = in_floats<Real> ? 1e10 : 1e75;

namespace detail {

/// Throws std::invalid_argument. It is a separate function, one for each Real, so that the checks
/// stay short enough for a loop over shadow rays.
template <class Real>
[[noreturn, gnu::cold, gnu::noinline]] void refuse(const char* what, const char* range) {
  throw std::invalid_argument(std::string(what) + range);
}

/// Throws unless `x`, called `what`, is in [1 / most, most]. `range` describes that interval in
/// words.
template <class Real>
void require_within(const Real& x, double most, const char* what, const char* range) {
  if (!all_within(x, 1 / most, most)) refuse<Real>(what, range);
}

}  // namespace detail

/// Throws std::invalid_argument unless a light's length [m], called `what`, is in its range.
template <class Real>
void require_length(const Real& x, const char* what) {
  detail::require_within(x, longest<Real>, what,
                         " must be positive and finite, in floats from 1e-10 to 1e10 m, in double from 1e-75 to "
                         "1e75 m (scale the scene)");
}

/// The same for a point.
template <class Real>
void require_place(const Vec3<Real>& v, const char* what) {
  constexpr double far = longest<Real>;
  if (all_within(v.x(), -far, far) && all_within(v.y(), -far, far) && all_within(v.z(), -far, far)) return;
  detail::refuse<Real>(
      what, " must be finite, in floats within 1e10 m of the origin, in double within 1e75 m (scale the scene)");
}

/// The same for the radius of an aperture [m]. Only its square is used, so the range is wider.
template <class Real>
void require_aperture(const Real& radius) {
  detail::require_within(radius, in_floats<Real> ? 1e18 : 1e150, "an aperture's radius",
                         " must be positive and finite, in floats from 1e-18 to 1e18 m, in double from 1e-150 to "
                         "1e150 m (a pinhole has none)");
}

/// The same for the radius or the deviation of a filter [pixel].
template <class Real>
void require_pixels(const Real& x, const char* what) {
  detail::require_within(x, 1e6, what, " must be positive and finite, from 1e-6 to 1e6 pixels (it divides)");
}

}  // namespace fairlight
