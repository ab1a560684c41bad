#pragma once

#include <fairlight/estimators/latin_hypercube.h>
#include <fairlight/estimators/sobol.h>
#include <fairlight/estimators/stratified.h>
#include <fairlight/validation/checks/padded_sets.h>

/// Point sets that are less random than they look.
namespace fairlight::faults {

/// Scrambles every replicate alike, so more replicates add nothing.
template <class Real>
struct OneReplicateSobol : OwenSobol<Real> {
  OneReplicateSobol(const StreamKey& key, std::uint32_t, std::uint32_t n) : OwenSobol<Real>(key, 0, n) {}
};

/// Scrambles every dimension with the same seeds: the dimensions of a point depend on each other.
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

/// Visits the cells of every pair of dimensions in the same order: the pairs depend on each other.
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

/// Puts each number in the middle of its stratum instead of anywhere in it.
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

/// Gives every vertex of a path the same numbers.
struct OneVertexSobol : PaddedSobol {
  using PaddedSobol::PaddedSobol;

  template <class Real>
  SampleBlock<Real> block(const PathVertex<Real>& at, std::uint32_t b, BlockPart part = BlockPart::all) const {
    return PaddedSobol::block(PathVertex<Real>{at.pixel, at.sample, Word<Real>(0u)}, b, part);
  }
};

/// Gives the points of a set in the same order in every pair: each pair is right, but pairs depend
/// on each other over a set.
struct OneOrderSobol : PaddedSobol {
  OneOrderSobol(const StreamKey& of, std::uint32_t n) : PaddedSobol(of, n), key(of) {}

  template <class Real>
  SampleBlock<Real> block(const PathVertex<Real>& at, std::uint32_t b, BlockPart /*part*/ = BlockPart::all) const {
    const auto point = sets().point_of(at.sample);
    const auto shifts = five_of(sets().shared_words(key, at, b));
    const auto factors = sets().order_words(key, at, b);
    const auto number = [&](std::size_t d) {
      const auto digits = reverse_bits(scramble_upwards(point, Word<Real>(shifts[d] >> 8), factors[d / 2]));
      return Real(unit_number(digits & Word<Real>(0xFFFFFF00u), Word<Real>(0u)));
    };
    return {number(0), number(1), number(2), number(3), number(4)};
  }

  StreamKey key;
};

template <class Real>
using OneVertexSobolSet = PaddedSet<Real, OneVertexSobol>;
template <class Real>
using OneOrderSobolSet = PaddedSet<Real, OneOrderSobol>;

/// Leaves out the first point and adds one at the end, so that the set is no net.
/// On record: pytorch #32047, scikit-optimize #953.
template <class Real>
struct SobolWithoutFirst : OwenSobol<Real> {
  using OwenSobol<Real>::OwenSobol;
  PointSource<SobolWithoutFirst> source(std::uint32_t first) const { return {*this, first}; }
  std::array<Real, 2> pair(const Word<Real>& points, std::uint32_t k) const {
    return OwenSobol<Real>::pair(points + Word<Real>(1u), k);
  }
};

/// Shifts all points by the same digits instead of scrambling them.
/// On record: openturns #2686.
template <class Real>
struct ShiftedSobol : OwenSobol<Real> {
  ShiftedSobol(const StreamKey& key, std::uint32_t number, std::uint32_t n)
      : OwenSobol<Real>(key, number, n), replicate(key, number) {}

  PointSource<ShiftedSobol> source(std::uint32_t first) const { return {*this, first}; }
  std::array<Real, 2> pair(const Word<Real>& points, std::uint32_t k) const {
    const auto shifts = replicate.shared(k);
    const auto number = [&](std::uint32_t dimension, std::size_t shift) {
      return unit_number(sobol(dimension % sobol_dimensions, points) ^ Word<Real>(shifts[shift]),
                         Word<Real>(shifts[shift + 1]));
    };
    return {number(2 * k, 0), number(2 * k + 1, 2)};
  }

  Replicate replicate;
};

/// Uses one jitter for all points of a replicate, not one for each.
template <class Real>
struct OneJitterLatinHypercube : LatinHypercube<Real> {
  OneJitterLatinHypercube(const StreamKey& key, std::uint32_t number, std::uint32_t n)
      : LatinHypercube<Real>(key, number, n), replicate(key, number) {}

  PointSource<OneJitterLatinHypercube> source(std::uint32_t first) const { return {*this, first}; }
  std::array<Real, 2> pair(const Word<Real>& points, std::uint32_t k) const {
    const auto seeds = replicate.shared(k);
    const auto jitter = replicate.own(Word<Real>(0u), k);
    return {in_stratum(permute(points, this->size(), seeds[0], seeds[1]), this->size(), jitter[0], jitter[1]),
            in_stratum(permute(points, this->size(), seeds[2], seeds[3]), this->size(), jitter[2], jitter[3])};
  }

  Replicate replicate;
};

/// Gives every pixel the numbers of the first.
/// On record: the class of SORT #35.
struct NumbersOfOnePixel {
  static SampleBlock<double> of(const StreamKey& key, std::uint32_t, std::uint32_t path, std::uint32_t vertex) {
    return IndependentNumbers(key).block<double>({0, path, vertex}, 0);
  }
};

/// Gives every vertex of a path the numbers of the first.
/// On record: OpenCL-path-tracing-tutorial-3-Part-2 #2.
struct NumbersOfOneVertex {
  static SampleBlock<double> of(const StreamKey& key, std::uint32_t pixel, std::uint32_t path, std::uint32_t) {
    return IndependentNumbers(key).block<double>({pixel, path, 0}, 0);
  }
};

/// Numbers with 16 binary digits.
template <class Real>
struct CoarseNumbers {
  using Scalar = Real;
  using Point = Vec2<Real>;
  using Measure = UnitCube;
  Point sample(const Vec2<Real>& u) const { return {cut(u.x()), cut(u.y())}; }
  Density<Measure, Real> pdf(const Point&) const { return Density<Measure, Real>(Real(1)); }

 private:
  static Real cut(Real u) {
    using std::floor;
    return floor(u * Real(65536)) / Real(65536);
  }
};

/// Repeats the first five numbers of a source, like a counter that does not advance.
template <class Source>
class OneBlock {
 public:
  using Real = decltype(std::declval<Source&>().next());
  OneBlock(Source& source) {
    for (Real& x : five_) x = source.next();
  }
  Real next() { return five_[used_++ % five_.size()]; }

 private:
  std::array<Real, 5> five_;
  std::size_t used_ = 0;
};

}  // namespace fairlight::faults
