#pragma once

#include <fairlight/estimators/vec.h>

namespace fairlight::detail {

/// Unit vectors in polar coordinates about +z. Near the pole z rounds to 1, but the height 1 -
///   cos(theta) below the pole stays accurate. So the samplers compute with that height.

/// The unit vector at height z above the equator, at the fraction `turn` of a full turn about +z.
/// `radius` is sin(theta).
template <class Real>
Vec3<Real> direction_at(Real z, Real radius, Real turn) {
  const auto [sine, cosine] = sine_and_cosine_of_turn(turn);
  return {radius * cosine, radius * sine, z};
}

/// The same from the height 0 <= drop <= 2 below the pole. sin^2 = (1 - cos) (1 + cos) = drop (2 -
/// drop), where nothing cancels.
template <class Real>
Vec3<Real> direction_below_pole(Real drop, Real turn) {
  using std::sqrt;
  return direction_at(Real(Real(1) - drop), Real(sqrt(drop * (Real(2) - drop))), turn);
}

/// The height 1 - cos(theta) of a unit vector below the pole. Above the equator it is sin^2 / (1 +
/// cos), which keeps all digits of a small angle.
template <class Real>
Real drop_below_pole(const Vec3<Real>& w) {
  using std::abs;
  const Real sine_squared = w.x() * w.x() + w.y() * w.y();
  return select(w.z() > Real(0), Real(sine_squared / (Real(1) + abs(w.z()))), Real(Real(1) - w.z()));
}

/// The azimuth about +z as a fraction of a turn, in [0,1); 0 for a vector along z, which has none.
template <class Real>
Real turn_about_z(const Vec3<Real>& w) {
  using std::atan2;
  const auto along_z = w.x() == Real(0) && w.y() == Real(0);
  const Real x = select(along_z, Real(1), Real(w.x()));  // atan2(0, 0) of a packet is NaN
  const Real signed_turn = atan2(Real(w.y()), x) / (Real(2) * pi<Real>);
  const Real turn = select(signed_turn < Real(0), Real(signed_turn + Real(1)), signed_turn);
  return select(turn >= Real(1), Real(0), turn);  // just short of a full turn, the sum rounds to 1
}

}  // namespace fairlight::detail
