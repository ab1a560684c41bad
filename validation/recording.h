#pragma once

#include <array>
#include <vector>

#include <fairlight/estimators/stream.h>

namespace fairlight {

/// The numbers that a packet of samples was drawn from, kept, so that each lane can be followed once more, alone and in double. A float
/// has the first 24 digits of the double's 48; the others come from another unit of the stream.
class Recording {
 public:
  /// Of the samples `first`, `first` + 1, ..., one a lane.
  Recording(const StreamKey& key, std::uint64_t first)
      : floats_(key, 0, first), beyond_(floats_), finer_(key, 1, first) {}

  const PhiloxStream<Packet>& stream() const { return floats_; }

  /// A copy of a source may bring a number that is kept already.
  void keep(std::size_t dimension, const Packet& number) {
    if (dimension < numbers_.size()) return;
    auto& doubles = numbers_.emplace_back();
    std::array<double, lanes<Packet>> more{};
    store_lanes(number, doubles.data());
    store_lanes(finer_.next(), more.data());
    for (std::size_t i = 0; i < more.size(); ++i) doubles[i] += more[i] * 0x1p-24;
  }

  /// The number of a lane in a dimension, which no lane of the packet need have come to.
  double in_double(std::size_t dimension, std::size_t lane) {
    while (dimension >= numbers_.size()) {
      for (; passed_ < numbers_.size(); ++passed_) beyond_.next();
      keep(passed_++, beyond_.next());
    }
    return numbers_[dimension][lane];
  }

 private:
  PhiloxStream<Packet> floats_, beyond_, finer_;
  std::size_t passed_ = 0;  ///< of the numbers of `beyond_`
  std::vector<std::array<double, lanes<Packet>>> numbers_;
};

/// A UniformSource of independent numbers that may have to do with a recording, so that what draws from it is compiled once.
template <class Real>
class StreamNumbers;

template <class A>
class StreamNumbers<xsimd::batch<float, A>> {
 public:
  /// Of the samples `first`, `first` + 1, ..., one a lane.
  StreamNumbers(const StreamKey& key, std::uint64_t first) : stream_(key, 0, first) {}
  /// Of the recording's samples, which it is to keep.
  explicit StreamNumbers(Recording& recording) : stream_(recording.stream()), recording_(&recording) {}

  xsimd::batch<float, A> next() {
    const auto number = stream_.next();
    if (recording_ != nullptr) recording_->keep(dimension_, number);
    ++dimension_;
    return number;
  }
  /// How many it has given.
  std::size_t drawn() const { return dimension_; }

 private:
  PhiloxStream<xsimd::batch<float, A>> stream_;
  Recording* recording_ = nullptr;
  std::size_t dimension_ = 0;
};

template <>
class StreamNumbers<double> {
 public:
  StreamNumbers(const StreamKey& key, std::uint64_t sample) : stream_(key, 0, sample) {}
  /// Of a lane of what was recorded.
  StreamNumbers(const StreamKey& key, Recording& recording, std::size_t lane)
      : stream_(key, 0, 0), recording_(&recording), lane_(lane) {}

  double next() {
    const std::size_t dimension = dimension_++;
    return recording_ == nullptr ? stream_.next() : recording_->in_double(dimension, lane_);
  }
  std::size_t drawn() const { return dimension_; }

 private:
  PhiloxStream<double> stream_;
  Recording* recording_ = nullptr;
  std::size_t lane_ = 0, dimension_ = 0;
};

}  // namespace fairlight
