#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

#include <fairlight/estimators/concepts.h>
#include <fairlight/estimators/stream.h>

namespace fairlight {

/// Point sets: n points of the unit cube, in any number of dimensions, that are spread more evenly
/// than independent points. A number is a function of (key, replicate, point, dimension) and of n.
/// Each point is uniform, with independent dimensions, so the mean of f over the points is unbiased
/// for any n. The points depend on each other, so a test must use whole replicates as its
/// independent draws. A key of a point set must not serve a PhiloxStream: both use the same
/// counters.

/// Returns the number of points of a set. Throws std::invalid_argument unless it is from 1 to 2^28.
inline std::uint32_t checked_size(std::uint32_t n) {
  if (n < 1 || n > 1u << 28) throw std::invalid_argument("a point set of no or too many points (give 1 to 2^28)");
  return n;
}

/// The number first + i of a unit or a replicate (`what`). A key has 2^32 of them; throws
/// std::length_error beyond, where the numbers would repeat and draws would not be independent.
inline std::uint32_t checked_number(std::uint32_t first, std::uint64_t i, const char* what) {
  if (i > 0xFFFFFFFFu - first)
    throw std::length_error(std::string("the ") + what +
                            " of a key have run out (there are 2^32; take a further key)");
  return first + static_cast<std::uint32_t>(i);
}

/// The random words of one replicate of a point set, four for each pair of dimensions 2k and 2k +
/// 1.
class Replicate {
 public:
  Replicate(const StreamKey& key, std::uint32_t number) : key_(key.words()), number_(number) {}

  using Words = Philox<std::uint32_t>::Counter;

  /// The words that all points share: for pair k, and for a group of pairs.
  Words shared(std::uint32_t k) const { return Philox<std::uint32_t>::draw({k, 0, 1, number_}, key_); }
  Words shared_by_group(std::uint32_t group) const {
    return Philox<std::uint32_t>::draw({group, 0, 2, number_}, key_);
  }

  /// The words of one point, for pair k.
  template <class W>
  std::array<W, 4> own(W point, std::uint32_t k) const {
    return Philox<W>::draw({W(k), point, W(0u), W(number_)}, {W(key_[0]), W(key_[1])});
  }

 private:
  Philox<std::uint32_t>::Key key_;
  std::uint32_t number_;
};

/// The point numbers `first`, `first` + 1, ... modulo n, one per lane.
template <class Real>
Word<Real> point_numbers(std::uint32_t first, std::uint32_t n) {
  std::array<std::uint32_t, lanes<Real>> numbers{};
  for (std::size_t i = 0; i < lanes<Real>; ++i) numbers[i] = static_cast<std::uint32_t>((first + i) % n);
  if constexpr (lanes<Real> == 1) {
    return numbers[0];
  } else {
    return Word<Real>::load_unaligned(numbers.data());
  }
}

/// A UniformSource: the numbers of one point of a set, dimension after dimension; in packets, of
/// consecutive points. `set.pair(points, k)` gives dimensions 2k and 2k + 1.
/// Source   Owen 1998, "Latin supercube sampling", for replicates as the unit of randomness
template <class Set>
class PointSource {
 public:
  using Real = typename Set::Scalar;

  PointSource(const Set& set, std::uint32_t first)
      : set_(set), points_(point_numbers<Real>(first, set.size())), pair_{Real(0), Real(0)} {}

  /// The next dimension.
  Real next() {
    const std::uint32_t dimension = dimension_++;
    if (dimension % 2 == 0) pair_ = set_.pair(points_, dimension / 2);
    return pair_[dimension % 2];
  }

 private:
  Set set_;
  Word<Real> points_;
  std::array<Real, 2> pair_;
  std::uint32_t dimension_ = 0;
};

/// n points of a replicate. `source(first)` gives the numbers of point `first` and the following
/// ones, one point per lane.
template <class Set>
concept PointSet = std::constructible_from<Set, const StreamKey&, std::uint32_t, std::uint32_t> &&
    requires(const Set set, std::uint32_t first) {
  { set.size() } -> std::same_as<std::uint32_t>;
  { set.source(first) } -> UniformSource<typename Set::Scalar>;
};

}  // namespace fairlight
