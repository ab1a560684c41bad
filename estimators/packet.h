#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include <Eigen/Core>
#include <xsimd/xsimd.hpp>

#include <fairlight/estimators/real.h>

namespace fairlight {

/// Several floats that are worked on at once: 4, 8 or 16 of them, by the instruction set that the code is compiled for.
/// Source: xsimd.
using Packet = xsimd::batch<float>;

template <class A>
struct LaneOf<xsimd::batch<float, A>> {
  using Type = float;
};

template <class A>
inline constexpr std::size_t lanes<xsimd::batch<float, A>> = xsimd::batch<float, A>::size;

template <class A>
struct IndexOf<xsimd::batch<float, A>> {
  using Type = xsimd::batch<std::int32_t, A>;
};

/// A vector or a colour, lane by lane.
template <class A, int Size>
Eigen::Matrix<xsimd::batch<float, A>, Size, 1> select(const xsimd::batch_bool<float, A>& mask,
                                                      const Eigen::Matrix<xsimd::batch<float, A>, Size, 1>& a,
                                                      const Eigen::Matrix<xsimd::batch<float, A>, Size, 1>& b) {
  Eigen::Matrix<xsimd::batch<float, A>, Size, 1> chosen;
  for (int i = 0; i < Size; ++i) chosen[i] = select(mask, a[i], b[i]);
  return chosen;
}
template <class A, int Size>
Eigen::Array<xsimd::batch<float, A>, Size, 1> select(const xsimd::batch_bool<float, A>& mask,
                                                     const Eigen::Array<xsimd::batch<float, A>, Size, 1>& a,
                                                     const Eigen::Array<xsimd::batch<float, A>, Size, 1>& b) {
  return select(mask, a.matrix().eval(), b.matrix().eval()).array();
}

template <class A>
xsimd::batch<std::int32_t, A> whole(const xsimd::batch<float, A>& x) {
  return xsimd::to_int(x);
}

template <class Real, class A>
Mask<Real> same_index(const xsimd::batch<std::int32_t, A>& a, const xsimd::batch<std::int32_t, A>& b) {
  return xsimd::to_float(a) == xsimd::to_float(b);
}

template <class A>
void store_lanes(const xsimd::batch<float, A>& x, double* out) {
  std::array<float, lanes<xsimd::batch<float, A>>> values{};
  x.store_unaligned(values.data());
  std::copy(values.begin(), values.end(), out);
}

template <class A>
void load_lanes(const double* in, xsimd::batch<float, A>& x) {
  std::array<float, lanes<xsimd::batch<float, A>>> values{};
  std::transform(in, in + values.size(), values.begin(), [](double value) { return static_cast<float>(value); });
  x = xsimd::batch<float, A>::load_unaligned(values.data());
}
template <class A>
void load_lanes(const int* in, xsimd::batch<std::int32_t, A>& x) {
  x = xsimd::batch<std::int32_t, A>::load_unaligned(in);
}

template <class A>
xsimd::batch<float, A> gather(const float* table, const xsimd::batch<std::int32_t, A>& i) {
  return xsimd::batch<float, A>::gather(table, i);
}

/// The high and the low 32 bits of the products of 32-bit words, from those of their halves.
template <class A>
std::array<xsimd::batch<std::uint32_t, A>, 2> multiply_high_low(std::uint32_t a,
                                                                const xsimd::batch<std::uint32_t, A>& b) {
  using Word = xsimd::batch<std::uint32_t, A>;
  const Word half(0xFFFFu);
  const Word a_low(a & 0xFFFFu);
  const Word a_high(a >> 16);
  const Word b_low = b & half;
  const Word b_high = b >> 16;
  const Word low = a_low * b_low;
  const Word cross = a_low * b_high;
  const Word middle = (low >> 16) + (cross & half) + a_high * b_low;
  return {a_high * b_high + (cross >> 16) + (middle >> 16), Word(a) * b};
}

}  // namespace fairlight

namespace Eigen {

/// A packet as the scalar of a vector.
template <class A>
struct NumTraits<xsimd::batch<float, A>> {
  using Real = xsimd::batch<float, A>;
  using NonInteger = Real;
  using Nested = Real;
  using Literal = float;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 0,
    ReadCost = 1,
    AddCost = 1,
    MulCost = 1
  };
  static Real epsilon() { return Real(NumTraits<float>::epsilon()); }
  static Real dummy_precision() { return Real(NumTraits<float>::dummy_precision()); }
  static int digits10() { return NumTraits<float>::digits10(); }
};

}  // namespace Eigen
