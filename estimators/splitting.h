#pragma once

#include <stdexcept>
#include <type_traits>
#include <utility>

#include <fairlight/estimators/concepts.h>

namespace fairlight {

/// Runs an estimator k times on average, and weights each run by 1/k: the same mean, with less
/// variance. The fraction of k is the probability of one more run; k < 1 is roulette.
/// Formula  1/k times the sum of floor(k) runs, and of one more with probability k - floor(k)
/// Domain   0 < k <= 10^9; throws std::invalid_argument elsewhere
/// Random   the dimensions of each run; before them one more if k is not an integer
/// Bound    the estimator's; if k is not an integer, that of floor(k) or floor(k) + 1 draws, over k
/// Source   Arvo and Kirk 1990; the fraction: Booth 1985, "Monte Carlo variance comparison for
///          expected-value versus sampled splitting"
template <class Inner>
class Splitting {
 public:
  using Scalar = typename Inner::Scalar;

  Splitting(Inner inner, double k) : inner_(std::move(inner)), k_(k) {
    if (!all_positive(k) || !(k <= 1e9))
      throw std::invalid_argument(
          "the number of runs must be positive and at most 10^9 (each is counted 1/k times)");
  }

  template <UniformSource<Scalar> Source>
  auto estimate(Source& source) const {
    using Value = std::remove_cvref_t<decltype(inner_.estimate(source))>;
    Mask<Scalar> one_more(false);
    if (fraction() > 0) one_more = source.next() < rounded<Scalar>(fraction());
    Value sum = zero<Value>();
    for (int run = 0; run < whole_runs(); ++run) sum += inner_.estimate(source);
    if (any(one_more)) sum += select(one_more, Value(inner_.estimate(source)), zero<Value>());
    return Value(sum / rounded<Scalar>(k_));
  }

  Bound bound() const {
    if (fraction() == 0) return inner_.bound();
    return 1 / k_ * hull(whole_runs() * inner_.bound(), (whole_runs() + 1) * inner_.bound());
  }

 private:
  int whole_runs() const { return to_int(k_); }
  double fraction() const { return k_ - whole_runs(); }

  Inner inner_;
  double k_;
};

}  // namespace fairlight
