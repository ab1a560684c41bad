#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fairlight/estimators/point_set.h>
#include <fairlight/estimators/stream.h>
#include <fairlight/stats/betting_test.h>

namespace fairlight {

/// The number i of a replicate, a set or a pixel, as `what` says, in 32 bits: a key has 2^32 of
/// them. Throws NoMoreDraws beyond.
inline std::uint32_t number_in_key(std::uint64_t i, const char* what) {
  if (i >> 32 != 0) throw NoMoreDraws(std::string(what) + " have run out (there are 2^32 of one key)");
  return static_cast<std::uint32_t>(i);
}

/// The random numbers of one sample (in a packet, one sample for each lane), by dimension. It makes
/// a number when it is first asked for, and keeps it, so that several sources can read the same
/// numbers.
template <class Real>
class SampleNumbers {
 public:
  virtual ~SampleNumbers() = default;
  const Real& at(std::size_t dimension) {
    while (dimension >= kept_.size()) make_more(kept_);
    return kept_[dimension];
  }

 protected:
  void forget() { kept_.clear(); }

 private:
  /// Appends the next number, or several.
  virtual void make_more(std::vector<Real>& kept) = 0;

  std::vector<Real> kept_;
};

/// A UniformSource that reads the numbers of a sample. Its type does not depend on where they come
/// from, so an estimator is compiled once for each arithmetic. A copy continues from the same
/// dimension and reads the same numbers.
template <class Real>
class NumberSource {
 public:
  explicit NumberSource(SampleNumbers<Real>& numbers) : numbers_(&numbers) {}

  /// Throws std::out_of_range past the end of a source made by take().
  Real next() {
    if (dimension_ >= end_) throw std::out_of_range("a source of the next n numbers was asked for more");
    return numbers_->at(dimension_++);
  }

  /// A source of the next n numbers only. This source skips them, so the numbers after them are the
  /// same in each arithmetic, although the lanes of a packet advance together.
  NumberSource take(std::size_t n) {
    NumberSource taken = *this;
    dimension_ += n;
    taken.end_ = std::min(dimension_, end_);
    return taken;
  }

  /// How many numbers it has given or skipped.
  std::size_t drawn() const { return dimension_; }

 private:
  SampleNumbers<Real>* numbers_;
  std::size_t dimension_ = 0, end_ = std::numeric_limits<std::size_t>::max();
};

/// Independent numbers for the samples `first`, `first` + 1, ..., one for each lane.
template <class Real>
class IndependentSamples final : public SampleNumbers<Real> {
 public:
  explicit IndependentSamples(const StreamKey& key, std::uint64_t first = 0) : key_(key), stream_(key, 0, first) {}
  void move_to(std::uint64_t first) {
    this->forget();
    stream_ = PhiloxStream<Real>(key_, 0, first);
  }

 private:
  static constexpr int of_a_block = lanes<Real> == 1 ? 2 : 5;
  void make_more(std::vector<Real>& kept) override {
    for (int i = 0; i < of_a_block; ++i) kept.push_back(stream_.next());
  }

  StreamKey key_;
  PhiloxStream<Real> stream_;
};

/// The numbers of the points of a replicate, from any point set.
template <class Real>
class PointNumbers : public SampleNumbers<Real> {
 public:
  virtual void begin(const StreamKey& key, std::uint32_t replicate, std::uint32_t n) = 0;
  /// Moves to the points `first`, `first` + 1, ..., one for each lane.
  virtual void move_to(std::uint32_t first) = 0;
};

template <PointSet Set>
class PointNumbersOf final : public PointNumbers<typename Set::Scalar> {
 public:
  using Real = typename Set::Scalar;
  void begin(const StreamKey& key, std::uint32_t replicate, std::uint32_t n) override {
    set_.emplace(key, replicate, n);
  }
  void move_to(std::uint32_t first) override {
    this->forget();
    source_.emplace(set_->source(first));
  }

 private:
  void make_more(std::vector<Real>& kept) override { kept.push_back(source_->next()); }

  std::optional<Set> set_;
  std::optional<decltype(std::declval<const Set&>().source(0))> source_;
};

/// The numbers of a packet of samples in double. The float gives the first 24 binary digits,
/// another unit of the stream the next 24. So each lane can be drawn again, alone and in double.
template <class Packets>
class FinerNumbers {
 public:
  FinerNumbers(SampleNumbers<Packets>& floats, const StreamKey& key, std::uint64_t first)
      : floats_(floats), finer_(key, 1, first) {}

  double at(std::size_t dimension, std::size_t lane) {
    while (dimension >= numbers_.size()) add();
    return numbers_[dimension][lane];
  }

 private:
  void add() {
    const Packets number = floats_.at(numbers_.size());
    auto& doubles = numbers_.emplace_back();
    std::array<double, lanes<Packets>> more{};
    store_lanes(number, doubles.data());
    store_lanes(finer_.next(), more.data());
    for (std::size_t i = 0; i < more.size(); ++i) doubles[i] += more[i] * 0x1p-24;
  }

  SampleNumbers<Packets>& floats_;
  PhiloxStream<Packets> finer_;
  std::vector<std::array<double, lanes<Packets>>> numbers_;
};

/// One lane of FinerNumbers.
template <class Packets>
class LaneNumbers final : public SampleNumbers<double> {
 public:
  LaneNumbers(FinerNumbers<Packets>& numbers, std::size_t lane) : numbers_(numbers), lane_(lane) {}

 private:
  void make_more(std::vector<double>& kept) override { kept.push_back(numbers_.at(kept.size(), lane_)); }

  FinerNumbers<Packets>& numbers_;
  std::size_t lane_;
};

}  // namespace fairlight
