#pragma once

#include <fairlight/estimators/vertex_source.h>

namespace fairlight {

/// Padded jittered strata for path vertices.
/// Formula  (u_0, u_1) = ((column, row) + jitter) / (columns, rows), with (column, row) the cell
///          order(i)
/// Measure  the unit cube
/// Domain   sets of n = 2^m <= 1024 points (throws std::invalid_argument otherwise)
/// Random   four words for five numbers of a set, and an independent block for the jitter
/// Source   Cook 1986, "Stochastic sampling in computer graphics"; PBR 4ed, 8.5 (StratifiedSampler)
class PaddedStrata {
  // Each pair of each vertex has its own grid of 2^ceil(m/2) by 2^floor(m/2) cells. Each cell holds
  // one of the 2^m points of a set, in the pair's own order. A single number has 2^m strata.
 public:
  PaddedStrata(const StreamKey& key, std::uint32_t n) : key_(key), sets_(n) {}

  const SampleSets& sets() const { return sets_; }

  template <class Real>
  SampleBlock<Real> block(const PathVertex<Real>& at, std::uint32_t b, BlockPart part = BlockPart::all) const {
    using W = Word<Real>;
    const auto words = sets_.shared_words(key_, at, b);
    const W point = sets_.point_of(at.sample);
    SampleBlock<Fixed64<W>> digits = independent_digits(key_, at, b);
    const std::uint32_t rows = sets_.bits() / 2;  // logarithms of the numbers of rows and columns
    const std::uint32_t columns = sets_.bits() - rows;
    for (std::size_t i = 0; i < (part == BlockPart::all ? 2 : 1); ++i) {
      const W cell = place(point, words, i);
      digits[2 * i] = in_stratum_of(cell & W((1u << columns) - 1), columns, digits[2 * i]);
      digits[2 * i + 1] = in_stratum_of(cell >> static_cast<int>(columns), rows, digits[2 * i + 1]);
    }
    if (part == BlockPart::all) digits[4] = in_stratum_of(place(point, words, 2), sets_.bits(), digits[4]);
    return unit_numbers<Real>(digits);
  }

 private:
  // The place of a point in order i. A digital shift, ten bits of a word for each order, makes
  // every place equally likely.
  template <class W>
  W place(const W& point, const std::array<W, 4>& words, std::size_t i) const {
    const W shift = words[3] >> (10 * static_cast<int>(i));
    return shuffled(point, sets_.bits(), words[i]) ^ (shift & W(sets_.size() - 1));
  }

  // The stratum's digits, and then the jitter's. There are 2^bits strata.
  template <class W>
  static Fixed64<W> in_stratum_of(const W& stratum, std::uint32_t bits, const Fixed64<W>& jitter) {
    if (bits == 0) return jitter;
    const int own = static_cast<int>(bits);
    return {(stratum << (32 - own)) | (jitter.high >> own), (jitter.high << (32 - own)) | (jitter.low >> own)};
  }

  StreamKey key_;
  SampleSets sets_;
};

}  // namespace fairlight
