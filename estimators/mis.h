#pragma once

#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <tuple>
#include <type_traits>
#include <utility>

#include <fairlight/estimators/concepts.h>

namespace fairlight {

/// Heuristics of multiple importance sampling: `weight(n, p, i)` is what a draw x of law i counts, where law k gives n_k
/// draws (or is chosen with probability n_k) and has the density p_k at x. The weights of all laws sum to one where any
/// density is not zero, so together they count x once; a law counts nothing where it draws nothing. Ratios of densities
/// are taken before they are squared or added: what is huge or tiny does not overflow.
///
/// `excess(N)`: by how much, at most, w_i f / (n_i p_i) exceeds f / sum n_k p_k for N laws; for the bounds.

namespace detail {

/// 1 / sum over k of r_k^power, with r_k = n_k p_k / (n_i p_i).
template <int power, class Measure, class Real, std::size_t N>
Real share(const std::array<Real, N>& n, const std::array<Density<Measure, Real>, N>& p, std::size_t i) {
  const Mask<Real> exists = p[i].value() != Real(0);
  const Real own = select(exists, p[i].value(), Real(1));
  Real sum(1);
  for (std::size_t k = 0; k < N; ++k) {
    if (k == i) continue;
    const Real ratio = p[k].value() / own * (n[k] / n[i]);
    sum += power == 2 ? ratio * ratio : ratio;
  }
  return select(exists, Real(Real(1) / sum), Real(0));
}

}  // namespace detail

/// In proportion to the expected number of draws: no heuristic has much less variance.
/// Formula  w_i = n_i p_i / sum n_k p_k
/// Source   Veach and Guibas 1995; Veach 1997, 9.2.2
struct BalanceHeuristic {
  template <class Measure, class Real, std::size_t N>
  static Real weight(const std::array<Real, N>& n, const std::array<Density<Measure, Real>, N>& p, std::size_t i) {
    return detail::share<1>(n, p, i);
  }
  static double excess(std::size_t) { return 1; }
};

/// In proportion to its square, which is sharper, and better where one law is nearly right.
/// Formula  w_i = (n_i p_i)^2 / sum (n_k p_k)^2
/// Bound    with q_i = 1, q sum(q) / sum(q^2) is largest where the other q are 1 / (1 + sqrt N), and is (1 + sqrt N) / 2
/// Source   Veach and Guibas 1995; Veach 1997, 9.2.3
struct PowerHeuristic {
  template <class Measure, class Real, std::size_t N>
  static Real weight(const std::array<Real, N>& n, const std::array<Density<Measure, Real>, N>& p, std::size_t i) {
    return detail::share<2>(n, p, i);
  }
  static double excess(std::size_t laws) { return (1 + std::sqrt(static_cast<double>(laws))) / 2; }
};

/// All to the law that is most likely to draw it; to the first of several such.
/// Formula  w_i = 1 where n_i p_i is the largest, else 0
/// Bound    the largest of N numbers is at least 1/N of their sum
/// Source   Veach and Guibas 1995; Veach 1997, 9.2.3
struct MaximumHeuristic {
  template <class Measure, class Real, std::size_t N>
  static Real weight(const std::array<Real, N>& n, const std::array<Density<Measure, Real>, N>& p, std::size_t i) {
    Mask<Real> largest = p[i].value() != Real(0);
    for (std::size_t k = 0; k < i; ++k) largest = largest && !(n[i] * p[i].value() <= n[k] * p[k].value());
    for (std::size_t k = i + 1; k < N; ++k) largest = largest && !(n[i] * p[i].value() < n[k] * p[k].value());
    return select(largest, Real(1), Real(0));
  }
  static double excess(std::size_t laws) { return static_cast<double>(laws); }
};

/// w_i / (n_i p_i), what f(x) is multiplied by at a draw x of law i; 0 where the draw does not exist.
template <class Heuristic, class Measure, class Real, std::size_t N>
Real mis_factor(const std::array<Real, N>& n, const std::array<Density<Measure, Real>, N>& p, std::size_t i) {
  const Real own = select(p[i].value() != Real(0), p[i].value(), Real(1));
  return Heuristic::weight(n, p, i) / own / n[i];
}

/// sup f / p for the mixture p = sum n_k p_k / n, from the suprema of f / p_k, at least one of them finite: with f <= M_k
/// p_k, f / p <= n / sum n_k / M_k. Where no law alone is good enough, the mixture may be, and whoever knows f says so.
template <std::size_t N>
double mixture_bound(const std::array<double, N>& n, const std::array<double, N>& largest) {
  double rate = 0;
  for (std::size_t k = 0; k < N; ++k) rate += n[k] / largest[k];
  return std::accumulate(n.begin(), n.end(), 0.0) / rate;
}

namespace detail {

/// Laws on one space, of one measure.
template <Sampler First, Sampler... Others>
struct LawsOf {
  using Scalar = typename First::Scalar;
  using Point = typename First::Point;
  using Measure = typename First::Measure;
  static constexpr std::size_t count = 1 + sizeof...(Others);
  static_assert((std::same_as<typename Others::Point, Point> && ...), "the laws must be on one space");
  static_assert((std::same_as<typename Others::Measure, Measure> && ...), "the laws must have one measure");

  std::tuple<First, Others...> laws;

  /// The density of each at x.
  std::array<Density<Measure, Scalar>, count> pdf(const Point& x) const {
    return std::apply([&](const auto&... law) { return std::array{law.pdf(x)...}; }, laws);
  }

  /// visit(law, i) for each.
  template <class Visit>
  void each(const Visit& visit) const {
    [&]<std::size_t... i>(std::index_sequence<i...>) { (visit(std::get<i>(laws), i), ...); }
    (std::make_index_sequence<count>());
  }
};

template <class Real, class Number, std::size_t N>
std::array<Real, N> all_rounded(const std::array<Number, N>& numbers) {
  std::array<Real, N> reals;
  for (std::size_t i = 0; i < N; ++i) reals[i] = rounded<Real>(static_cast<double>(numbers[i]));
  return reals;
}

}  // namespace detail

/// The integral of f from n_i draws of each of several laws, together.
/// Formula  sum over i and j of  w_i(x_ij) f(x_ij) / (n_i p_i(x_ij))
/// Domain   laws on one space, of which one at least has p_i > 0 wherever f is not zero; n_i at least 1 (throws
///          std::invalid_argument otherwise)
/// Random   two dimensions for each draw, law by law
/// Bound    the heuristic's excess times that of f / p, with p = sum n_i p_i / n the mixture, or nothing
/// Source   Veach and Guibas 1995; Veach 1997, 9.2
template <class Heuristic, class Integrand, Sampler... Laws>
class MultiSampleMis {
 public:
  using Scalar = typename detail::LawsOf<Laws...>::Scalar;

  /// `mixture`: where f / p lies.
  MultiSampleMis(Heuristic, std::tuple<Laws...> laws, const std::array<int, sizeof...(Laws)>& n,
                 Integrand integrand, const Bound& mixture = {})
      : laws_{std::move(laws)}, n_(n), integrand_(std::move(integrand)), mixture_(mixture) {
    for (int draws : n) {
      if (draws < 1) throw std::invalid_argument("a law that gives no draws (leave it out)");
    }
  }

  template <UniformSource<Scalar> Source>
  auto estimate(Source& source) const {
    using Point = typename decltype(laws_)::Point;
    using Value = std::invoke_result_t<Integrand, const Point&>;
    const auto n = detail::all_rounded<Scalar>(n_);
    Value sum = zero<Value>();
    laws_.each([&](const auto& law, std::size_t i) {
      for (int draw = 0; draw < n_[i]; ++draw) {
        const Point x = law.sample(next_pair<Scalar>(source));
        sum += Value(integrand_(x) * mis_factor<Heuristic>(n, laws_.pdf(x), i));
      }
    });
    return sum;
  }

  Bound bound() const { return or_nothing(Heuristic::excess(sizeof...(Laws)) * mixture_); }

 private:
  detail::LawsOf<Laws...> laws_;
  std::array<int, sizeof...(Laws)> n_;
  Integrand integrand_;
  Bound mixture_;
};

/// The integral of f from one draw of one of several laws, chosen by probability. By the balance heuristic it is plain
/// importance sampling from their mixture.
/// Formula  w_i(x) f(x) / (c_i p_i(x)),  i chosen with probability c_i
/// Domain   laws on one space, of which one at least has p_i > 0 wherever f is not zero; c_i > 0, in any unit, for they
///          are divided by their sum (throws std::invalid_argument otherwise)
/// Random   three dimensions: the choice, and a pair for the draw
/// Bound    the heuristic's excess times that of f / p, with p = sum c_i p_i the mixture, or nothing
/// Source   Veach and Guibas 1995; Veach 1997, 9.2.4
template <class Heuristic, class Integrand, Sampler... Laws>
class OneSampleMis {
 public:
  using Scalar = typename detail::LawsOf<Laws...>::Scalar;

  /// `mixture`: where f / p lies.
  OneSampleMis(Heuristic, std::tuple<Laws...> laws, const std::array<double, sizeof...(Laws)>& c,
               Integrand integrand, const Bound& mixture = {})
      : laws_{std::move(laws)}, c_(c), integrand_(std::move(integrand)), mixture_(mixture) {
    const double sum = std::accumulate(c.begin(), c.end(), 0.0);
    for (double& probability : c_) {
      if (!(probability > 0 && all_finite(sum)))
        throw std::invalid_argument("the probability of a law must be positive and finite (leave out what is 0)");
      probability /= sum;
    }
  }

  template <UniformSource<Scalar> Source>
  auto estimate(Source& source) const {
    using Point = typename decltype(laws_)::Point;
    using Value = std::invoke_result_t<Integrand, const Point&>;
    const Scalar choice = source.next();
    const Vec2<Scalar> u = next_pair<Scalar>(source);
    // A lane takes the last law whose part of [0,1) begins at or below its number.
    std::array<Mask<Scalar>, sizeof...(Laws)> chosen;
    Point x;
    double begin = 0;
    laws_.each([&](const auto& law, std::size_t i) {
      chosen[i] = choice >= rounded<Scalar>(begin);
      x = i == 0 ? Point(law.sample(u)) : select(chosen[i], Point(law.sample(u)), x);
      begin += c_[i];
    });
    const auto c = detail::all_rounded<Scalar>(c_);
    const auto p = laws_.pdf(x);
    Scalar factor(0);
    for (std::size_t i = 0; i < c.size(); ++i) factor = select(chosen[i], mis_factor<Heuristic>(c, p, i), factor);
    return Value(integrand_(x) * factor);
  }

  Bound bound() const { return or_nothing(Heuristic::excess(sizeof...(Laws)) * mixture_); }

 private:
  detail::LawsOf<Laws...> laws_;
  std::array<double, sizeof...(Laws)> c_;
  Integrand integrand_;
  Bound mixture_;
};

}  // namespace fairlight
