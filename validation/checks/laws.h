#pragma once

#include <vector>

#include <fairlight/estimators/concepts.h>
#include <fairlight/stats/law_test.h>
#include <fairlight/stats/rosenblatt.h>
#include <fairlight/validation/checks/means.h>
#include <fairlight/validation/checks/pairs.h>

namespace fairlight {

/// Gives the draws of a sampler one by one, in order, although it makes them a packet at a time.
template <Sampler Law>
class SamplerDraws {
 public:
  using Real = typename Law::Scalar;

  SamplerDraws(const Law& law, const Pairs<Real>& pairs) : law_(law), pairs_(pairs) {}

  /// Draw i, in double, and the density that the law gives it.
  auto point(std::uint64_t i) { return detail::lane_of(packet(i).point, i % lanes<Real>); }
  double density(std::uint64_t i) { return detail::lane_of(law_.pdf(packet(i).point).value(), i % lanes<Real>); }

 private:
  struct Made {
    std::uint64_t number;
    typename Law::Point point;
  };

  const Made& packet(std::uint64_t i) {
    if (made_.empty() || made_[0].number != i / lanes<Real>)
      made_.assign(1, {i / lanes<Real>, law_.sample(pairs_(i - i % lanes<Real>))});
    return made_[0];
  }

  Law law_;
  Pairs<Real> pairs_;
  std::vector<Made> made_;
};

/// Tests by chi-square that a sampler's draws in double follow its density, which integrates to one
/// over the domain.
template <Sampler Law, class Domain>
Finding check_law(const Trial& trial, const Law& law, const Domain& domain) {
  SamplerDraws draws(law, independent_pairs<double>(StreamKey(trial.seed, trial.claim)));
  return test_law(
      trial, domain, [&](const typename Law::Point& x) { return law.pdf(x).value(); },
      [&](std::uint64_t i) { return typename Law::Point(draws.point(i)); });
}

namespace detail {

/// As check_law_moments, from pairs in replicates of `replicate`.
template <Sampler Drawn, Sampler Law, class Domain>
Finding check_law_moments_of(const Trial& trial, const Drawn& drawn, const Law& law, const Domain& domain,
                             const Pairs<typename Drawn::Scalar>& pairs, std::uint32_t replicate) {
  SamplerDraws draws(drawn, pairs);
  return test_rosenblatt(
      trial, [&](double s, double t) { return law.pdf(domain.at(s, t)).value() * domain.size(); },
      [&](std::uint64_t i) { return domain.coordinates(draws.point(i)); }, replicate, landmarks_of(domain));
}

}  // namespace detail

/// Tests that the draws of `drawn` follow the density of `law`, by bounded moments of the
/// Rosenblatt transform. The guarantee is exact; deviations of high frequency go unseen.
template <Sampler Drawn, Sampler Law, class Domain>
Finding check_law_moments(const Trial& trial, const Drawn& drawn, const Law& law, const Domain& domain) {
  const StreamKey key(trial.seed, trial.claim);
  return detail::check_law_moments_of(trial, drawn, law, domain, independent_pairs<typename Drawn::Scalar>(key), 1);
}

/// The same over Sobol' points. The law of a draw does not depend on the correlation between draws,
/// and the moments hardly vary over a replicate.
template <Sampler Drawn, Sampler Law, class Domain>
Finding check_law_moments_over_points(const Trial& trial, const Drawn& drawn, const Law& law,
                                      const Domain& domain) {
  const StreamKey key(trial.seed, trial.claim);
  constexpr std::uint32_t n = points_a_replicate;
  return detail::check_law_moments_of(trial, drawn, law, domain, point_pairs<typename Drawn::Scalar>(key, n), n);
}

/// Tests that `law` gives the draws of `drawn` the density that `drawn` gives them: the ratio of
/// the two has the mean 1 and is never above 2.
template <Sampler Drawn, Sampler Law>
Finding check_density(const Trial& trial, const Drawn& drawn, const Law& law) {
  using Real = typename Drawn::Scalar;
  SamplerDraws draws(drawn, independent_pairs<Real>(StreamKey(trial.seed, trial.claim)));
  const Reference reference{
      .mean = 1, .lower = 0, .upper = 2, .sides = Sides::both, .rounding = arithmetic_rounding<Real>};
  const auto ratio = [&](std::uint64_t i) {
    return draws.density(i) / law.pdf(typename Law::Point(draws.point(i))).value();
  };
  return test_means(trial, {reference}, one_channel(ratio));
}

}  // namespace fairlight
