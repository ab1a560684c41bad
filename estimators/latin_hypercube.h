#pragma once

#include <fairlight/estimators/strata.h>

namespace fairlight {

/// Latin hypercube sampling: in every dimension each of n strata holds one point, uniform within
/// it. Each dimension has its own order of strata.
/// Formula  u_d = (pi_d(i) + jitter) / n, with pi_d a permutation for every (replicate, dimension)
/// Measure  the unit cube
/// Domain   n from 1 to 2^28 (throws std::invalid_argument otherwise)
/// Random   for each two dimensions: four words per replicate, four per point
/// Source   McKay, Beckman, Conover 1979; the permutation by Kensler 2013
template <class Real>
class LatinHypercube {
 public:
  using Scalar = Real;

  LatinHypercube(const StreamKey& key, std::uint32_t replicate, std::uint32_t n)
      : replicate_(key, replicate), n_(checked_size(n)) {}

  std::uint32_t size() const { return n_; }
  PointSource<LatinHypercube> source(std::uint32_t first) const { return {*this, first}; }

  /// Dimensions 2k and 2k + 1 of the points.
  std::array<Real, 2> pair(const Word<Real>& points, std::uint32_t k) const {
    const auto seeds = replicate_.shared(k);
    const auto jitter = replicate_.own(points, k);
    return {in_stratum(permute(points, n_, seeds[0], seeds[1]), n_, jitter[0], jitter[1]),
            in_stratum(permute(points, n_, seeds[2], seeds[3]), n_, jitter[2], jitter[3])};
  }

 private:
  Replicate replicate_;
  std::uint32_t n_;
};

}  // namespace fairlight
