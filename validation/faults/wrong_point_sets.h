#pragma once

#include <fairlight/estimators/latin_hypercube.h>
#include <fairlight/estimators/sobol.h>
#include <fairlight/estimators/stratified.h>
#include <fairlight/validation/padded_sets.h>

/// Point sets whose numbers are not as random as they look.
namespace fairlight::faults {

/// Every replicate is scrambled alike, so more of them bring nothing.
template <class Real>
struct OneReplicateSobol : OwenSobol<Real> {
  OneReplicateSobol(const StreamKey& key, std::uint32_t, std::uint32_t n) : OwenSobol<Real>(key, 0, n) {}
};

/// Every dimension is scrambled with the same seeds: a point's dimensions depend on each other.
template <class Real>
struct OneScrambleSobol : OwenSobol<Real> {
  OneScrambleSobol(const StreamKey& key, std::uint32_t replicate, std::uint32_t n)
      : OwenSobol<Real>(key, replicate, n), seeds(Replicate(key, replicate).shared(0)) {}

  PointSource<OneScrambleSobol> source(std::uint32_t first) const { return {*this, first}; }
  std::array<Real, 2> pair(const Word<Real>& points, std::uint32_t k) const {
    const auto number = [&](std::uint32_t dimension) {
      const auto digits = sobol(dimension % sobol_dimensions, points);
      return unit_number(nested_scramble(digits, seeds[0], seeds[1]), Word<Real>(0u));
    };
    return {number(2 * k), number(2 * k + 1)};
  }

  Replicate::Words seeds;
};

/// The cells of every pair of dimensions are visited in the same order: the pairs depend on each other.
template <class Real>
struct OneOrderStratified : Stratified<Real> {
  OneOrderStratified(const StreamKey& key, std::uint32_t number, std::uint32_t n)
      : Stratified<Real>(key, number, n), replicate(key, number) {}

  PointSource<OneOrderStratified> source(std::uint32_t first) const { return {*this, first}; }
  std::array<Real, 2> pair(const Word<Real>& points, std::uint32_t k) const {
    const auto seeds = replicate.shared(0);
    const auto jitter = replicate.own(points, k);
    const auto cell = permute(points, this->columns() * this->rows(), seeds[0], seeds[1]);
    const auto [row, column] = divide(cell, this->columns());
    return {in_stratum(column, this->columns(), jitter[0], jitter[1]),
            in_stratum(row, this->rows(), jitter[2], jitter[3])};
  }

  Replicate replicate;
};

/// Each number is the middle of its stratum, not anywhere in it.
template <class Real>
struct MidpointLatinHypercube : LatinHypercube<Real> {
  MidpointLatinHypercube(const StreamKey& key, std::uint32_t number, std::uint32_t n)
      : LatinHypercube<Real>(key, number, n), replicate(key, number) {}

  PointSource<MidpointLatinHypercube> source(std::uint32_t first) const { return {*this, first}; }
  std::array<Real, 2> pair(const Word<Real>& points, std::uint32_t k) const {
    const auto seeds = replicate.shared(k);
    const Word<Real> middle(0x80000000u);
    const Word<Real> none(0u);
    return {in_stratum(permute(points, this->size(), seeds[0], seeds[1]), this->size(), middle, none),
            in_stratum(permute(points, this->size(), seeds[2], seeds[3]), this->size(), middle, none)};
  }

  Replicate replicate;
};

/// Every vertex of a path has the same numbers.
struct OneVertexSobol : PaddedSobol {
  using PaddedSobol::PaddedSobol;

  template <class Real>
  Five<Real> block(const PathVertex<Real>& at, std::uint32_t b) const {
    return PaddedSobol::block(PathVertex<Real>{at.pixel, at.sample, Word<Real>(0u)}, b);
  }
};

/// The points of a set come in the same order in every pair: each is right, but pairs depend on each other over a set.
struct OneOrderSobol : PaddedSobol {
  OneOrderSobol(const StreamKey& of, std::uint32_t n) : PaddedSobol(of, n), key(of) {}

  template <class Real>
  Five<Real> block(const PathVertex<Real>& at, std::uint32_t b) const {
    const auto point = sets().point_of(at.sample);
    const auto number = [&](std::uint32_t i, std::size_t shift) {
      const auto seeds = sets().shared_words(key, at, b, i);
      return Real(unit_number(reverse_bits(scramble_upwards(point, seeds[shift], seeds[2])), Word<Real>(0u)));
    };
    return {number(0, 0), number(0, 1), number(1, 0), number(1, 1), number(0, 3)};
  }

  StreamKey key;
};

template <class Real>
using OneVertexSobolSet = PaddedSet<Real, OneVertexSobol>;
template <class Real>
using OneOrderSobolSet = PaddedSet<Real, OneOrderSobol>;

}  // namespace fairlight::faults
