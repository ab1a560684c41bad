#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fairlight/estimators/mis.h>

// Checks the guarantees of the heuristics for terms and variance, for two to five laws over a few
// points. All are sums, without randomness.
namespace fairlight {
namespace {

// A nonnegative number over six orders of magnitude; every fourth one is 0.
double any_number() {
  const int e = *rc::gen::inRange(-30, 31);
  return e % 4 == 0 ? 0 : std::pow(10, e / 10.0);
}

template <std::size_t N>
struct Combination {
  std::array<double, N> n;                 // draws of each law
  std::vector<std::array<double, N>> p;    // at each point, the probabilities of the laws
  std::vector<double> f;                   // at each point
  std::vector<std::array<double, N>> odd;  // at each point, weights unlike any heuristic's

  double mean() const { return std::accumulate(f.begin(), f.end(), 0.0); }
};

// A law of density 0 at a point has weight 0 there; the other weights sum to 1.
template <std::size_t N>
std::array<double, N> any_weights(const std::array<double, N>& p) {
  std::array<double, N> w;
  for (std::size_t i = 0; i < N; ++i) w[i] = p[i] == 0 ? 0 : 1 + any_number();
  const double sum = std::accumulate(w.begin(), w.end(), 0.0);
  for (double& weight : w) weight /= sum;
  return w;
}

// f is 0 where all densities are 0, so every combination is unbiased.
template <std::size_t N>
Combination<N> any_combination() {
  Combination<N> made;
  for (double& draws : made.n) draws = *rc::gen::inRange(1, 10);
  std::array<double, N> totals{};
  for (int point = 0; point < 6; ++point) {
    std::array<double, N> p;
    for (std::size_t i = 0; i < N; ++i) totals[i] += p[i] = point == 0 ? 1 : any_number();
    made.p.push_back(p);
  }
  for (auto& p : made.p) {
    for (std::size_t i = 0; i < N; ++i) p[i] /= totals[i];
    const bool drawn = std::ranges::any_of(p, [](double x) { return x > 0; });
    made.f.push_back(drawn ? any_number() : 0);
    made.odd.push_back(drawn ? any_weights(p) : p);
  }
  return made;
}

template <std::size_t N>
std::array<Density<Discrete, double>, N> densities(const std::array<double, N>& p) {
  return std::apply([](auto... x) { return std::array{Density<Discrete, double>(x)...}; }, p);
}

// The sum over i of n_i sum over x of p_i (w_i f / (n_i p_i))^2, with the kit's factor w_i / (n_i
// p_i).
template <class Heuristic, std::size_t N>
double second_moment(const Combination<N>& c) {
  double sum = 0;
  for (std::size_t x = 0; x < c.f.size(); ++x) {
    for (std::size_t i = 0; i < N; ++i) {
      const double term = c.f[x] * mis_factor<Heuristic>(c.n, densities(c.p[x]), i);
      sum += c.n[i] * c.p[x][i] * term * term;
    }
  }
  return sum;
}

// The same for given weights.
template <std::size_t N>
double second_moment(const Combination<N>& c, const std::vector<std::array<double, N>>& weights) {
  double sum = 0;
  for (std::size_t x = 0; x < c.f.size(); ++x) {
    for (std::size_t i = 0; i < N; ++i) {
      if (c.p[x][i] > 0) sum += std::pow(weights[x][i] * c.f[x], 2) / (c.n[i] * c.p[x][i]);
    }
  }
  return sum;
}

// The sum over i of (sum over x of w_i f)^2 / n_i, which the variance subtracts for the squared
// means of the laws' parts.
template <std::size_t N>
double squared_parts(const Combination<N>& c, const std::vector<std::array<double, N>>& weights) {
  double sum = 0;
  for (std::size_t i = 0; i < N; ++i) {
    double part = 0;
    for (std::size_t x = 0; x < c.f.size(); ++x) part += weights[x][i] * c.f[x];
    sum += part * part / c.n[i];
  }
  return sum;
}

template <class Heuristic, std::size_t N>
std::vector<std::array<double, N>> weights_of(const Combination<N>& c) {
  std::vector<std::array<double, N>> all;
  for (const auto& p : c.p) {
    std::array<double, N> w;
    for (std::size_t i = 0; i < N; ++i) w[i] = Heuristic::weight(c.n, densities(p), i);
    all.push_back(w);
  }
  return all;
}

template <class Heuristic, std::size_t N>
double variance(const Combination<N>& c) {
  return second_moment<Heuristic>(c) - squared_parts(c, weights_of<Heuristic>(c));
}

// Calls check(combination) for two, three, four and five laws.
template <class Check>
void for_two_to_five_laws(const Check& check) {
  check(any_combination<2>());
  check(any_combination<3>());
  check(any_combination<4>());
  check(any_combination<5>());
}

// The sums have about 30 nonnegative terms, each with a few rounding errors.
constexpr double rounding = 1e-14;

// Measured in units of the balance heuristic's term, f / sum n_k p_k.
template <class Heuristic>
void expect_no_more_than_its_excess() {
  for_two_to_five_laws([]<std::size_t N>(const Combination<N>& c) {
    for (const auto& p : c.p) {
      const double all = std::inner_product(p.begin(), p.end(), c.n.begin(), 0.0);
      for (std::size_t i = 0; i < N; ++i) {
        const double term = mis_factor<Heuristic>(c.n, densities(p), i) * all;
        RC_ASSERT(term <= Heuristic::excess(N) * (1 + rounding));
      }
    }
  });
}

RC_GTEST_PROP(BalanceHeuristic, ExceedsItselfNowhere, ()) { expect_no_more_than_its_excess<BalanceHeuristic>(); }
RC_GTEST_PROP(PowerHeuristic, ExceedsTheBalanceByNoMoreThanItSays, ()) {
  expect_no_more_than_its_excess<PowerHeuristic>();
}
RC_GTEST_PROP(MaximumHeuristic, ExceedsTheBalanceByNoMoreThanItSays, ()) {
  expect_no_more_than_its_excess<MaximumHeuristic>();
}

// Veach 1997, theorem 9.2: V[balance] <= V[any other] + (1 / min n_i - 1 / sum n_i) mu^2.
template <std::size_t N>
void expect_balance_within(const Combination<N>& c, double variance_of_other, double scale) {
  const double most = 1 / std::ranges::min(c.n) - 1 / std::accumulate(c.n.begin(), c.n.end(), 0.0);
  RC_ASSERT(variance<BalanceHeuristic>(c) <=
            variance_of_other + most * c.mean() * c.mean() + rounding * (scale + c.mean() * c.mean()));
}

RC_GTEST_PROP(BalanceHeuristic, HasLittleMoreVarianceThanAnyOtherFromSeveralSamples, ()) {
  for_two_to_five_laws([](const auto& c) {
    const double balance = second_moment<BalanceHeuristic>(c);
    expect_balance_within(c, variance<PowerHeuristic>(c), balance);
    expect_balance_within(c, variance<MaximumHeuristic>(c), balance);
    expect_balance_within(c, second_moment(c, c.odd) - squared_parts(c, c.odd), balance);
  });
}

// Veach 1997, theorem 9.4: in the one-sample model no combination has a smaller variance. With c_i
// = n_i / n every second moment is n times that of n_i, and the means are equal, so comparing the
// sums above is enough.
RC_GTEST_PROP(BalanceHeuristic, HasTheLeastVarianceFromOneSample, ()) {
  for_two_to_five_laws([](const auto& c) {
    const double balance = second_moment<BalanceHeuristic>(c) * (1 - rounding);
    RC_ASSERT(balance <= second_moment<PowerHeuristic>(c));
    RC_ASSERT(balance <= second_moment<MaximumHeuristic>(c));
    RC_ASSERT(balance <= second_moment(c, c.odd));
  });
}

// Two points, two equal laws that are proportional to f: every draw contributes 1.
TEST(BalanceHeuristic, HasNoVarianceFromLawsThatAreProportionalToWhatTheySample) {
  const Combination<2> c{{1, 3}, {{0.25, 0.25}, {0.75, 0.75}}, {1, 3}, {}};
  EXPECT_NEAR(variance<BalanceHeuristic>(c), 0, 1e-15);
}

}  // namespace
}  // namespace fairlight
