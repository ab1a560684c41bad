#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <fairlight/stats/evidence.h>
#include <fairlight/stats/second_order.h>

namespace fairlight {
namespace {

double range_variance(const BoundedEstimator& e) { return (e.upper - e.lower) * (e.upper - e.lower) / 2; }

// Half the squared difference of draws 2i and 2i + 1.
double pair_variance(const BoundedEstimator& e, std::uint64_t i) {
  const auto draw = [&](std::uint64_t index) {
    const double x = e.draw(index);
    if (!(x >= e.lower && x <= e.upper)) throw BadDraw(index, x, "outside its declared range");
    return x;
  };
  const double difference = draw(2 * i) - draw(2 * i + 1);
  return difference * difference / 2;
}

// The test of Var A <= ratio Var B, with a = pair_variance(A), b = ratio pair_variance(B). Three tests
// share the pairs: E[a - b] <= 0 is refuted, E[a - (1 + margin) b] >= 0 is excluded, and E[b] is
// bounded for the interval. Their bets need a guess of E[b]; no error rate depends on it.
class VarianceRatio {
 public:
  VarianceRatio(const Trial& trial, double ratio, const BoundedEstimator& a, const BoundedEstimator& b)
      : trial_(trial), ratio_(ratio), a_(a), b_(b) {}

  // Undecided, with a note, if the first pairs show no variance in B.
  Finding finding() try { return of_pairs(); } catch (const BadDraw& bad) {
    Finding finding{Verdict::biased, Guarantee::deterministic, trial_.margin};
    finding.draws = bad.draw() + 1;
    finding.note = (drawing_b_ ? "of the second estimator, " : "") + std::string(bad.what());
    if (trial_.evidence != nullptr) trial_.evidence->margin_grid = refuted_grid(trial_.margin, 1);
    return with_token(trial_, finding);
  }

 private:
  Finding of_pairs() {
    const double scale = guess();
    if (!(scale > 0)) return without_verdict(no_variance);
    const double m = trial_.margin * scale, most_a = std::max(range_variance(a_), 4 * m);
    const double most_b = std::max(ratio_ * range_variance(b_), 2 * (scale + m));
    const double alpha = trial_.alpha, beta = trial_.beta, above = 1 + trial_.margin;
    BettingTest excess({0, m, -most_b - 2 * m, most_a, 0, Sides::not_above}, alpha, beta);
    BettingTest shortfall({-m, m, -above * most_b - 4 * m, most_a, 0, Sides::not_above}, alpha, beta);
    BettingTest scales({scale, m, std::min(0.0, scale - 2 * m), most_b}, alpha, beta);
    const std::string note = run(excess, shortfall, scales);
    Finding finding = without_verdict(note);
    finding.draws = pairs_;
    if (excess.verdict() == Verdict::biased)
      finding.verdict = Verdict::biased;
    else if (shortfall.verdict() == Verdict::certified)
      finding.verdict = Verdict::certified;
    describe(finding, excess.interval(), scales.interval());
    leave_grid(excess, shortfall);
    return finding;
  }

  static constexpr const char* no_variance =
      "the second estimator shows no variance (a ratio to it has no meaning)";

  Finding without_verdict(const std::string& note) const {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    Finding finding{Verdict::undecided, Guarantee::exact, trial_.margin};
    finding.interval = {-infinite, infinite};
    finding.note = note;
    return with_token(trial_, finding);
  }

  double draw_b(std::uint64_t i) {
    drawing_b_ = true;
    const double b = ratio_ * pair_variance(b_, i);
    drawing_b_ = false;
    return b;
  }

  // The mean of b over the first pairs: as many as carry the weight of 100 equal ones, and no more
  // than 2^24. The test draws others.
  double guess() {
    constexpr std::uint64_t most = 1u << 24;
    double sum = 0, squares = 0;
    while (sum * sum <= 100 * squares && first_ < most) {
      const double b = draw_b(first_++);
      sum += b;
      squares += b * b;
      if (first_ % 65536 == 0 && !goes_on(trial_, 0.01)) break;
    }
    return sum / static_cast<double>(first_);
  }

  std::string run(BettingTest& excess, BettingTest& shortfall, BettingTest& scales) {
    std::vector<double> over, under, b;
    std::uint64_t looks = 1024;
    while (excess.verdict() != Verdict::biased && shortfall.verdict() != Verdict::certified) {
      const auto n = static_cast<double>(pairs_);
      if (pairs_ >= looks) {
        if (n > std::max(excess.patience(), shortfall.patience())) return "the cap on draws came first";
        if (!goes_on(trial_, n / std::max(shortfall.expected_draws(), 1.01 * n))) return told_to_end;
        looks = pairs_ + pairs_ / 64;
      }
      const std::size_t block = std::min(excess.block_size(), shortfall.block_size());
      for (auto* draws : {&over, &under, &b}) draws->resize(block);
      for (std::size_t i = 0; i < block; ++i) {
        b[i] = draw_b(first_ + pairs_ + i);
        const double of_a = pair_variance(a_, first_ + pairs_ + i);
        over[i] = of_a - b[i];
        under[i] = of_a - (1 + trial_.margin) * b[i];
        sum_a_ += of_a;
        sum_b_ += b[i];
      }
      pairs_ += block;
      excess.add(over);
      shortfall.add(under);
      scales.add(b);
    }
    return {};
  }

  // An end of a / b - 1 is the end of E[a - b] divided by that end of E[b] which puts it farther out.
  // What is certified bounds the upper end too.
  void describe(Finding& finding, const Interval& excess, const Interval& scale) const {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const double least = std::max(scale.lo, 0.0), most = scale.hi;
    finding.bias = sum_b_ > 0 ? sum_a_ / sum_b_ - 1 : infinite;
    finding.interval.lo = excess.lo > 0 ? excess.lo / most : -infinite;
    finding.interval.hi = excess.hi < 0 ? excess.hi / most : least > 0 ? excess.hi / least : infinite;
    if (finding.verdict == Verdict::certified) finding.interval.hi = std::min(finding.interval.hi, finding.margin);
  }

  // At finer margins other differences would have to be bet on, so certifying evidence is left for the
  // claim's own margin alone.
  void leave_grid(const BettingTest& excess, const BettingTest& shortfall) const {
    if (trial_.evidence == nullptr) return;
    constexpr double infinite = std::numeric_limits<double>::infinity();
    MarginGrid grid{first_level(trial_.margin), {{}}};
    grid.channels[0].assign(levels_of_run(trial_.margin).size(), {excess.wealth().above_reference, 0, 0, infinite});
    grid.channels[0][0].below_upper_margin = shortfall.wealth().below_upper_margin;
    trial_.evidence->margin_grid = grid;
  }

  const Trial& trial_;
  double ratio_;
  const BoundedEstimator &a_, &b_;
  std::uint64_t first_ = 0, pairs_ = 0;
  double sum_a_ = 0, sum_b_ = 0;
  bool drawing_b_ = false;
};

}  // namespace

Finding test_variance(const Trial& trial, double variance, const BoundedEstimator& estimator, Sides sides) {
  const Reference reference{variance, 0, range_variance(estimator), 0, variance, sides};
  return test_means(trial, {reference}, one_channel([&](std::uint64_t i) { return pair_variance(estimator, i); }));
}

Finding test_variance_ratio(const Trial& trial, double ratio, const BoundedEstimator& a,
                            const BoundedEstimator& b) {
  check_trial(trial);
  if (!(ratio > 0)) throw std::invalid_argument("a ratio of variances must be positive");
  return VarianceRatio(trial, ratio, a, b).finding();
}

Finding test_uncorrelated(const Trial& trial, std::pair<double, double> means, double reach, double scale,
                          const std::function<std::pair<double, double>(std::uint64_t)>& draw) {
  const Reference reference{0, -reach * reach, reach * reach, 0, scale};
  return test_means(trial, {reference}, one_channel([&](std::uint64_t i) {
                      const auto [a, b] = draw(i);
                      return (a - means.first) * (b - means.second);
                    }));
}

}  // namespace fairlight
