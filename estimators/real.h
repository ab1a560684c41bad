#pragma once

#include <cmath>
#include <limits>
#include <numbers>

namespace fairlight {

/// Samplers, geometry and the path tracer are templates over Real: `double`, the readable reference, or a SIMD
/// packet. What differs between the two is here: a packet type overloads these three, and a comparison of packets
/// is a mask.

/// a where the mask holds, b elsewhere. Both are evaluated.
template <class Value>
Value select(bool mask, const Value& a, const Value& b) {
  return mask ? a : b;
}

/// Whether the mask holds anywhere.
inline bool any(bool mask) { return mask; }

/// The type of a comparison of two Reals.
template <class Real>
using Mask = decltype(Real() < Real());

template <class Real>
inline const Real pi = Real(std::numbers::pi);

template <class Real>
inline const Real infinity = Real(std::numeric_limits<double>::infinity());

}  // namespace fairlight
