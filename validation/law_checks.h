#pragma once

#include <algorithm>
#include <array>
#include <stdexcept>
#include <vector>

#include <fairlight/estimators/concepts.h>
#include <fairlight/estimators/sobol.h>
#include <fairlight/stats/law_test.h>
#include <fairlight/stats/rosenblatt.h>
#include <fairlight/validation/checks.h>

namespace fairlight {

/// The numbers of draws i, i + 1, ..., one a lane: independent ones.
template <class Real>
auto independent_numbers(const StreamKey& key) {
  return [key](std::uint64_t i) { return PhiloxStream<Real>(key, 0, i); };
}

/// In double the first two of each draw, made for several draws at once by packets of words: the same numbers.
class PairsAtOnce {
 public:
  explicit PairsAtOnce(const StreamKey& key) : key_(key) {}

  /// A UniformSource of two numbers; std::out_of_range for a third.
  struct Pair {
    std::array<double, 2> numbers;
    std::size_t used = 0;
    double next() { return numbers.at(used++); }
  };
  Pair operator()(std::uint64_t i) {
    if (pairs_.empty() || made_ != i / lanes<Packet>) make(i / lanes<Packet>);
    return pairs_[i % lanes<Packet>];
  }

 private:
  void make(std::uint64_t number) {
    using W = Word<Packet>;
    const std::uint64_t first = number * lanes<Packet>;
    const W samples = W(static_cast<std::uint32_t>(first)) + lane_numbers<W::arch_type>();
    const auto block = Philox<W>::draw({W(0u), samples, W(static_cast<std::uint32_t>(first >> 32)), W(0u)},
                                       {W(key_.words()[0]), W(key_.words()[1])});
    std::array<std::array<std::uint32_t, lanes<Packet>>, 4> words;
    for (std::size_t k = 0; k < words.size(); ++k) block[k].store_unaligned(words[k].data());
    pairs_.clear();
    for (std::size_t i = 0; i < lanes<Packet>; ++i) {
      pairs_.push_back(
          {{unit_number_of_halves(words[2][i], words[3][i]), unit_number_of_halves(words[0][i], words[1][i])}});
    }
    made_ = number;
  }

  StreamKey key_;
  std::vector<Pair> pairs_;
  std::uint64_t made_ = 0;
};

/// Or Sobol' points, one replicate of n after the other, which must fill whole packets (else std::invalid_argument).
template <class Real>
auto numbers_of_points(const StreamKey& key, std::uint32_t n) {
  if (n % lanes<Real> != 0)
    throw std::invalid_argument("a replicate must fill whole packets (give a multiple of lanes)");
  return [key, n](std::uint64_t i) {
    return OwenSobol<Real>(key, number_in_key(i / n, "replicates"), n).source(static_cast<std::uint32_t>(i % n));
  };
}

/// The draws of a sampler one by one, in order, though they are made a packet at a time, from `numbers(i)`.
template <Sampler Law, class Numbers>
class Draws {
 public:
  using Real = typename Law::Scalar;

  Draws(const Law& law, const Numbers& numbers) : law_(law), numbers_(numbers) {}

  /// Draw i, in double; and the density that the law gives it.
  auto point(std::uint64_t i) { return detail::lane_of(packet(i).point, i % lanes<Real>); }
  double density(std::uint64_t i) { return detail::lane_of(law_.pdf(packet(i).point).value(), i % lanes<Real>); }

 private:
  struct Made {
    std::uint64_t number;
    typename Law::Point point;
  };

  const Made& packet(std::uint64_t i) {
    if (made_.empty() || made_[0].number != i / lanes<Real>) {
      auto source = numbers_(i - i % lanes<Real>);
      made_.assign(1, {i / lanes<Real>, law_.sample(next_pair<Real>(source))});
    }
    return made_[0];
  }

  Law law_;
  Numbers numbers_;
  std::vector<Made> made_;
};

/// A sampler's draws in double follow its density, which integrates to one over the domain.
template <Sampler Law, class Domain>
Finding check_law(const Trial& trial, const Law& law, const Domain& domain) {
  Draws draws(law, PairsAtOnce(StreamKey(trial.seed, trial.claim)));
  return test_law(
      trial, domain, [&](const typename Law::Point& x) { return law.pdf(x).value(); },
      [&](std::uint64_t i) { return typename Law::Point(draws.point(i)); });
}

namespace detail {

/// As check_law_moments, from numbers that come in replicates.
template <Sampler Drawn, Sampler Law, class Domain, class Numbers>
Finding check_law_moments_of(const Trial& trial, const Drawn& drawn, const Law& law, const Domain& domain,
                             const Numbers& numbers, std::uint32_t replicate) {
  Draws draws(drawn, numbers);
  return test_rosenblatt(
      trial, [&](double s, double t) { return law.pdf(domain.at(s, t)).value() * domain.size(); },
      [&](std::uint64_t i) { return domain.coordinates(draws.point(i)); }, replicate);
}

}  // namespace detail

/// That the draws of `drawn` follow the density of `law`, by bounded moments of the Rosenblatt transform: exact,
/// and blind to fine waves.
template <Sampler Drawn, Sampler Law, class Domain>
Finding check_law_moments(const Trial& trial, const Drawn& drawn, const Law& law, const Domain& domain) {
  const StreamKey key(trial.seed, trial.claim);
  return detail::check_law_moments_of(trial, drawn, law, domain, independent_numbers<typename Drawn::Scalar>(key),
                                      1);
}

/// The same over Sobol' points. A draw's law does not depend on how its numbers are spread, and over a replicate of points its
/// moments hardly vary.
template <Sampler Drawn, Sampler Law, class Domain>
Finding check_law_moments_over_points(const Trial& trial, const Drawn& drawn, const Law& law,
                                      const Domain& domain) {
  const StreamKey key(trial.seed, trial.claim);
  constexpr std::uint32_t n = points_a_replicate;
  return detail::check_law_moments_of(trial, drawn, law, domain, numbers_of_points<typename Drawn::Scalar>(key, n),
                                      n);
}

/// Two arithmetics give the draws of the first the same density: the ratio has the mean 1, and is nowhere above 2.
template <Sampler Drawn, Sampler Law>
Finding check_density(const Trial& trial, const Drawn& drawn, const Law& law) {
  using Real = typename Drawn::Scalar;
  Draws draws(drawn, independent_numbers<Real>(StreamKey(trial.seed, trial.claim)));
  const Reference reference{
      .mean = 1, .lower = 0, .upper = 2, .sides = Sides::both, .rounding = arithmetic_rounding<Real>};
  return test_means(trial, {reference}, [&](std::uint64_t first, std::vector<std::vector<double>>& channels) {
    for (std::size_t i = 0; i < channels[0].size(); ++i) {
      channels[0][i] = draws.density(first + i) / law.pdf(typename Law::Point(draws.point(first + i))).value();
    }
  });
}

}  // namespace fairlight
