#pragma once

#include <fairlight/estimators/vec.h>

namespace fairlight::detail {

/// Unit vectors in polar coordinates about +z. Near the pole the height 1 - cos(theta) below it says where a
/// direction is, and z does not, which is 1 but for rounding: so heights are what the samplers reckon with.

/// The unit vector at height z above the equator, at the fraction `turn` of a full turn about +z.
template <class Real>
Vec3<Real> direction_at(Real z, Real radius, Real turn) {
  const auto [sine, cosine] = sine_and_cosine_of_turn(turn);
  return {radius * cosine, radius * sine, z};
}

/// The same at the height 0 <= drop <= 2 below the pole: sin^2 = (1 - cos) (1 + cos) = drop (2 - drop), which
/// cancels nothing.
template <class Real>
Vec3<Real> direction_below_pole(Real drop, Real turn) {
  using std::sqrt;
  return direction_at(Real(Real(1) - drop), Real(sqrt(drop * (Real(2) - drop))), turn);
}

/// The height of a unit vector below the pole, 1 - cos(theta): above the equator as sin^2 / (1 + cos), which keeps
/// every digit of a small angle.
template <class Real>
Real drop_below_pole(const Vec3<Real>& w) {
  using std::abs;
  const Real sine_squared = w.x() * w.x() + w.y() * w.y();
  return select(w.z() > Real(0), Real(sine_squared / (Real(1) + abs(w.z()))), Real(Real(1) - w.z()));
}

/// The fraction of a turn about +z, in [0,1), at which the vector lies; 0 for one along z, which lies at none.
template <class Real>
Real turn_about_z(const Vec3<Real>& w) {
  using std::atan2;
  const auto along_z = w.x() == Real(0) && w.y() == Real(0);
  const Real x = select(along_z, Real(1), Real(w.x()));  // atan2(0, 0) of a packet is not a number
  const Real signed_turn = atan2(Real(w.y()), x) / (Real(2) * pi<Real>);
  const Real turn = select(signed_turn < Real(0), Real(signed_turn + Real(1)), signed_turn);
  return select(turn >= Real(1), Real(0), turn);  // just short of a full turn, the sum rounds to it
}

}  // namespace fairlight::detail
