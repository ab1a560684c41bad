#pragma once

#include <fairlight/stats/law_test.h>
#include <fairlight/stats/rosenblatt.h>
#include <fairlight/stats/second_order.h>
#include <fairlight/validation/checks/estimand.h>
#include <fairlight/validation/checks/variances.h>

namespace fairlight {

/// The claims about every kind of point set. Draw i uses replicate i, so draws are independent.
/// Each point, each lane and 37 pairs of dimensions take turns, which for Sobol' points include
/// padded pairs.

/// Two dimensions of a point: 2k and 2k + 1, or one of pair k and one of another pair.
enum class Dimensions { of_one_pair, of_two_pairs };

template <template <class> class Set, class Real>
Vec2<double> two_dimensions(const StreamKey& key, std::uint64_t i, Dimensions which) {
  const Set<Real> set(key, number_in_key(i, "replicates"), points_a_replicate);
  const auto points = point_numbers<Real>(static_cast<std::uint32_t>(i % set.size()), set.size());
  const auto lane = static_cast<std::size_t>(i / set.size()) % lanes<Real>;
  const auto k = static_cast<std::uint32_t>(i % 37);
  const auto first = set.pair(points, k);
  if (which == Dimensions::of_one_pair) return {detail::lane_of(first[0], lane), detail::lane_of(first[1], lane)};
  const auto second = set.pair(points, k + 1 + static_cast<std::uint32_t>(i % 5));
  return {detail::lane_of(first[i / set.size() % 2], lane), detail::lane_of(second[i / set.size() / 2 % 2], lane)};
}

/// A point of a set is uniform: tests its pairs of dimensions on the square, by chi-square.
template <template <class> class Set>
Claim point_law_claim(const PointSetKind<Set>& kind) {
  return {.name = kind.suffix + ".law",
          .kind = "law",
          .subjects = {kind.subject, kind.source},
          .statement = "any point of a replicate is uniform, in dimensions 2k and 2k + 1",
          .source = "Owen 1995; McKay, Beckman, Conover 1979",
          .margin_factor = 10,
          .check = [](const Trial& trial) {
            const StreamKey key(trial.seed, trial.claim);
            return test_law(
                trial, SquareDomain{0, 1}, [](const Vec2<double>&) { return 1.0; },
                [&](std::uint64_t i) { return two_dimensions<Set, double>(key, i, Dimensions::of_one_pair); });
          }};
}

/// Dimensions of two different pairs are independent: tests them by bounded moments.
template <class Real, template <class> class Set>
Claim point_moments_claim(const PointSetKind<Set>& kind) {
  return {.name = kind.suffix + ".moments" + real_suffix<Real>(),
          .kind = "law",
          .subjects = {kind.subject, kind.source},
          .statement =
              "any point of a replicate has the cosine moments of the uniform law, up to the third, in "
              "dimensions of two pairs",
          .source = "Owen 1995; McKay, Beckman, Conover 1979",
          .margin_factor = 10,
          .check =
              [](const Trial& trial) {
                const StreamKey key(trial.seed, trial.claim);
                return test_rosenblatt(
                    trial, [](double, double) { return 1.0; },
                    [&](std::uint64_t i) { return two_dimensions<Set, Real>(key, i, Dimensions::of_two_pairs); });
              },
          .real = real_name<Real>()};
}

/// Replicates are independent: the same number of two of them has covariance 0. Each has the mean
/// 1/2 and the variance 1/12.
template <template <class> class Set>
Claim replicates_uncorrelated_claim(const PointSetKind<Set>& kind) {
  return {.name = kind.suffix + ".replicates",
          .kind = "second order",
          .subjects = {kind.subject, kind.source},
          .statement = "the same number of two replicates is uncorrelated",
          .source = "the replicates' random words differ",
          .margin_factor = 5,
          .check = [](const Trial& trial) {
            const StreamKey key(trial.seed, trial.claim);
            return test_uncorrelated(trial, {0.5, 0.5}, 0.5, 1.0 / 12, [&](std::uint64_t i) {
              const auto number = [&](std::uint64_t replicate) {
                const Set<double> set(key, number_in_key(replicate, "replicates"), points_a_replicate);
                const auto point = static_cast<std::uint32_t>(i % set.size());
                return set.pair(point, static_cast<std::uint32_t>(i % 37))[i / set.size() % 2];
              };
              return std::pair(number(2 * i), number(2 * i + 1));
            });
          }};
}

/// The integral of x0^2 x2 over the cube is 1/6 even from three points. Errors from strata of a
/// third of the axis, or from a grid with an empty cell, would show.
template <template <class> class Set>
Claim three_points_claim(const PointSetKind<Set>& kind) {
  return {.name = kind.suffix + ".three_points",
          .kind = "mean",
          .subjects = {kind.subject, kind.source},
          .statement = "the integral of x0^2 x2 over the cube is 1/6, over replicates of three points",
          .source = "elementary",
          .margin_factor = 5,
          .check = [](const Trial& trial) {
            const auto body = body_of_source<double>([](auto& source) {
              const double x0 = source.next();
              source.next();
              return x0 * x0 * source.next();
            });
            return check_replicates<Set<double>>(trial, {{1.0 / 6, 0, 1}}, body, 3);
          }};
}

/// The variance of the mean of a coordinate over n points, with equally many in each of `width`
/// strata, uniform and independent within. Scrambling by a hash comes close to this, so the ratio
/// has a slack of 1 %. Any n consecutive Sobol' points are this even in the first coordinate, so
/// the first eight coordinates take turns.
/// Formula  1 / (12 width^2) / n
template <template <class> class Set>
Claim stratified_variance_claim(const PointSetKind<Set>& kind, std::uint32_t n, std::uint32_t width) {
  return {.name = kind.suffix + ".variance",
          .kind = "second order",
          .subjects = {kind.subject, kind.source},
          .statement = "the mean of any of the first eight coordinates over " + std::to_string(n) +
                       " points has at most 1.01 times the variance 1 / (12 x " + std::to_string(width) + "^2 x " +
                       std::to_string(n) + ")",
          .source = "Owen 1997, \"Monte Carlo variance of scrambled net quadrature\"; elementary",
          .margin_factor = 20,
          .check = [n, width](const Trial& trial) {
            const StreamKey key(trial.seed, trial.claim);
            const auto mean = [&](std::uint64_t replicate) {
              return replicate_mean<Set<double>>(key, replicate, n, [&](auto& source) {
                for (std::uint64_t skipped = 0; skipped < replicate % 8; ++skipped) source.next();
                return source.next();
              });
            };
            const double reach = 0.5 / width + n * ulp<double>;
            return test_variance(trial, 1.01 / (12.0 * width * width * n), {mean, 0.5 - reach, 0.5 + reach},
                                 Sides::not_above);
          }};
}

/// The variance of the mean of x0 x2 over n points, against independent ones, which have 7/144 / n.
/// Two parts of it, 3/144 each, come from x0 and from x2 alone; they almost vanish in a
/// well-distributed set. The joint part 1/144 stays: over n - 1 if the two have independent random
/// orders, over 4 or more if they have the same order.
template <template <class> class Set>
Claim product_variance_claim(const PointSetKind<Set>& kind, double ratio) {
  const auto product = [](auto& source) {
    const double x0 = source.pair()[0];
    return x0 * source.pair()[0];
  };
  return variance_claim("variance." + kind.suffix + "_against_independent", {kind.subject, kind.source},
                        "elementary; Owen 1998, \"Latin supercube sampling\"", ratio, 80,
                        replicates_of<Set<double>>("the mean of x0 x2 over 16 points", product, 0, 1, 16),
                        independent_draws(
                            "that over 16 independent ones",
                            [](auto& source) {
                              const double x0 = source.next();
                              return x0 * source.next();
                            },
                            0, 1, 16));
}

/// The integral of x0 x2 over the cube is 1/4.
inline auto product_integral() {
  const auto draw = []<class Real>(std::type_identity<Real>, auto& source) {
    const Real x0 = source.next();
    source.next();
    return Real(x0 * source.next());
  };
  return estimand("stream.product", {"PhiloxStream"}, "the integral of x0 x2 over the cube is 1/4", "elementary",
                  {{0.25, 0, 1}}, draw, 2);
}

/// The numbers of a source, unchanged.
template <class Source>
struct AsTheyCome {
  Source& source;
  auto next() { return source.next(); }
};

/// The integral of x0 x5 x10 over the cube is 1/8. The numbers come from three blocks of Philox,
/// which have five numbers in packets and two in double.
template <template <class> class Numbers = AsTheyCome>
auto blocks_integral() {
  const auto draw = []<class Real>(std::type_identity<Real>, auto& source) {
    Numbers<std::remove_reference_t<decltype(source)>> numbers{source};
    Real product(1);
    for (int i = 0; i <= 10; ++i) {
      const Real x = numbers.next();
      if (i % 5 == 0) product *= x;
    }
    return product;
  };
  return estimand("stream.blocks", {"PhiloxStream"}, "the integral of x0 x5 x10 over the cube is 1/8", "elementary",
                  {{0.125, 0, 1}}, draw, 4);
}

}  // namespace fairlight
