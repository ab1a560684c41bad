#pragma once

#include <array>
#include <vector>

#include <rapidcheck.h>

#include <fairlight/estimators/vec.h>

namespace fairlight::testing {

/// Numbers in [0,1), multiples of 2^-53 like those of a source.
inline rc::Gen<double> unit_number() {
  return rc::gen::map(rc::gen::inRange<std::uint64_t>(0, std::uint64_t{1} << 53),
                      [](std::uint64_t i) { return static_cast<double>(i) * 0x1p-53; });
}

/// Points of [0,1)^2.
inline rc::Gen<Vec2<double>> unit_point() {
  return rc::gen::map(rc::gen::pair(unit_number(), unit_number()),
                      [](const std::pair<double, double>& u) { return Vec2<double>(u.first, u.second); });
}

/// The corners and edges of [0,1)^2: all pairs of 0, the smallest number above 0, 1/2 and the
/// largest below 1. In double these are 2^-53 and 1 - 2^-53.
template <class Real = double>
std::vector<Vec2<Real>> edge_points() {
  constexpr Lane<Real> tiny = ulp<Real> / 2;
  std::vector<Vec2<Real>> points;
  for (Lane<Real> a : {Lane<Real>(0), tiny, Lane<Real>(0.5), 1 - tiny}) {
    for (Lane<Real> b : {Lane<Real>(0), tiny, Lane<Real>(0.5), 1 - tiny}) points.emplace_back(Real(a), Real(b));
  }
  return points;
}

/// The lanes of a number, as doubles.
template <class Real>
std::array<double, lanes<Real>> lanes_of(const Real& x) {
  std::array<double, lanes<Real>> values{};
  store_lanes(x, values.data());
  return values;
}

}  // namespace fairlight::testing

namespace rc {

// Prints a vector in rapidcheck's counterexamples.
inline void showValue(const fairlight::Vec2<double>& u, std::ostream& out) { out << u.x() << ' ' << u.y(); }
inline void showValue(const fairlight::Vec3<double>& v, std::ostream& out) { out << v.transpose(); }

}  // namespace rc
