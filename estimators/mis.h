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

/// Heuristics of multiple importance sampling. `weight(n, p, i)` is the weight of a draw x from law
/// i. Law k gives n_k draws (or is chosen with probability n_k), and has the density p_k at x. The
/// weights of all laws sum to 1 wherever any density is not 0; a law of density 0 has weight 0.
/// Ratios of densities come before squares and sums, so huge or tiny densities do not overflow.
/// `excess(N)` is for the bounds: for N laws, w_i f / (n_i p_i) is at most excess(N) times f / sum
/// n_k p_k.

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

/// Proportional to n_i p_i, the expected number of draws. No other heuristic has a much smaller
/// variance.
/// Formula  w_i = n_i p_i / sum n_k p_k
/// Source   Veach and Guibas 1995; Veach 1997, 9.2.2
struct BalanceHeuristic {
  template <class Measure, class Real, std::size_t N>
  static Real weight(const std::array<Real, N>& n, const std::array<Density<Measure, Real>, N>& p, std::size_t i) {
    return detail::share<1>(n, p, i);
  }
  static double excess(std::size_t) { return 1; }
};

/// Proportional to (n_i p_i)^2. It is sharper, and better if one law is almost the ideal one.
/// Formula  w_i = (n_i p_i)^2 / sum (n_k p_k)^2
/// Bound    with q_i = 1, sum(q) / sum(q^2) is largest if all other q are 1 / (1 + sqrt N); it then
///          is (1 + sqrt N) / 2
/// Source   Veach and Guibas 1995; Veach 1997, 9.2.3
struct PowerHeuristic {
  template <class Measure, class Real, std::size_t N>
  static Real weight(const std::array<Real, N>& n, const std::array<Density<Measure, Real>, N>& p, std::size_t i) {
    return detail::share<2>(n, p, i);
  }
  static double excess(std::size_t laws) { return (1 + std::sqrt(static_cast<double>(laws))) / 2; }
};

/// All weight to the law with the largest n_i p_i; the first one wins a tie.
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

/// w_i / (n_i p_i), the factor of f(x) for a draw x from law i; 0 if the draw does not exist.
template <class Heuristic, class Measure, class Real, std::size_t N>
Real mis_factor(const std::array<Real, N>& n, const std::array<Density<Measure, Real>, N>& p, std::size_t i) {
  const Real own = select(p[i].value() != Real(0), p[i].value(), Real(1));
  return Heuristic::weight(n, p, i) / own / n[i];
}

/// A bound on f / p for the mixture p = sum n_k p_k / n, from the bounds M_k of f / p_k, of which
/// at least one is finite: f <= M_k p_k gives f / p <= n / sum n_k / M_k. A caller who knows f may
/// know that f / p is bounded even where no f / p_k is.
template <std::size_t N>
double mixture_bound(const std::array<double, N>& n, const std::array<double, N>& largest) {
  double rate = 0;
  for (std::size_t k = 0; k < N; ++k) rate += n[k] / largest[k];
  return std::accumulate(n.begin(), n.end(), 0.0) / rate;
}

namespace detail {

/// Laws on the same space, with the same measure.
template <Sampler First, Sampler... Others>
struct LawsOf {
  using Scalar = typename First::Scalar;
  using Point = typename First::Point;
  using Measure = typename First::Measure;
  static constexpr std::size_t count = 1 + sizeof...(Others);
  static_assert((std::same_as<typename Others::Point, Point> && ...), "the laws must be on one space");
  static_assert((std::same_as<typename Others::Measure, Measure> && ...), "the laws must have one measure");

  std::tuple<First, Others...> laws;

  /// The density of each law at x.
  std::array<Density<Measure, Scalar>, count> pdf(const Point& x) const {
    return std::apply([&](const auto&... law) { return std::array{law.pdf(x)...}; }, laws);
  }

  /// Calls visit(law, i) for each law.
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

/// Estimates the integral of f from n_i draws of each of several laws.
/// Formula  sum over i and j of  w_i(x_ij) f(x_ij) / (n_i p_i(x_ij))
/// Domain   laws on one space; at least one has p_i > 0 wherever f is not 0; n_i >= 1 (else
///          std::invalid_argument)
/// Random   two dimensions for each draw, law by law
/// Bound    the heuristic's excess times the bound of f / p, p = sum n_i p_i / n the mixture; or 0
/// Source   Veach and Guibas 1995; Veach 1997, 9.2
template <class Heuristic, class Integrand, Sampler... Laws>
class MultiSampleMis {
 public:
  using Scalar = typename detail::LawsOf<Laws...>::Scalar;

  /// `mixture` is the bound of f / p.
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

/// Estimates the integral of f from one draw of one law, chosen at random. With the balance
/// heuristic this is importance sampling from the mixture.
/// Formula  w_i(x) f(x) / (c_i p_i(x)), where i is chosen with probability c_i
/// Domain   laws on one space; at least one has p_i > 0 wherever f is not 0; c_i > 0 (else
///          std::invalid_argument); c_i is divided by sum c
/// Random   three dimensions: the choice, and a pair for the draw
/// Bound    the heuristic's excess times the bound of f / p, p = sum c_i p_i the mixture; or 0
/// Source   Veach and Guibas 1995; Veach 1997, 9.2.4
template <class Heuristic, class Integrand, Sampler... Laws>
class OneSampleMis {
 public:
  using Scalar = typename detail::LawsOf<Laws...>::Scalar;

  /// `mixture` is the bound of f / p.
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
    // Each lane takes the last law whose interval of [0,1) starts at or below its number.
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
