#pragma once

#include <cmath>

#include <fairlight/estimators/strata.h>

namespace fairlight {

/// Jittered strata: for each pair of dimensions, n points in n different cells of a grid, with
/// columns = ceil(sqrt n) and rows = ceil(n / columns), in an independent random order.
/// Formula  (u_2k, u_2k+1) = ((column, row) + jitter) / (columns, rows); row columns + column =
///          pi_k(i)
/// Measure  the unit cube
/// Domain   n from 1 to 2^28 (throws std::invalid_argument otherwise)
/// Random   for each two dimensions: two words per replicate, four per point
/// Source   Cook 1986, "Stochastic sampling in computer graphics"; the permutation by Kensler 2013
template <class Real>
class Stratified {
  // If n fills the grid, every cell holds one point. Otherwise fewer than `columns` cells, chosen
  // at random, stay empty. A point falls into any cell with equal probability, so it is uniform for
  // every n.
 public:
  using Scalar = Real;

  Stratified(const StreamKey& key, std::uint32_t replicate, std::uint32_t n)
      : replicate_(key, replicate),
        n_(checked_size(n)),
        columns_(static_cast<std::uint32_t>(std::ceil(std::sqrt(static_cast<double>(n))))),
        rows_((n + columns_ - 1) / columns_) {}

  std::uint32_t size() const { return n_; }
  std::uint32_t columns() const { return columns_; }
  std::uint32_t rows() const { return rows_; }
  PointSource<Stratified> source(std::uint32_t first) const { return {*this, first}; }

  /// Dimensions 2k and 2k + 1 of the points.
  std::array<Real, 2> pair(const Word<Real>& points, std::uint32_t k) const {
    const auto seeds = replicate_.shared(k);
    const auto jitter = replicate_.own(points, k);
    const auto [row, column] = divide(permute(points, columns_ * rows_, seeds[0], seeds[1]), columns_);
    return {in_stratum(column, columns_, jitter[0], jitter[1]), in_stratum(row, rows_, jitter[2], jitter[3])};
  }

 private:
  Replicate replicate_;
  std::uint32_t n_, columns_, rows_;
};

}  // namespace fairlight
