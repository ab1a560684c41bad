#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <Eigen/Core>
#include <boost/math/distributions/normal.hpp>

#include <fairlight/stats/betting_test.h>
#include <fairlight/stats/text.h>

namespace fairlight {
namespace {

// A tail slack above this part of the margin would slow certification, whose bets ignore the slack.
constexpr double largest_slack = 0.05;

// Sums of many cubes of numbers in such a range do not overflow.
constexpr double largest_range = 1e100;

// The part of alpha for giving up on right code; the rest is for calling it biased.
constexpr double part_for_giving_up = 0.02;

// The bet divided by the best l. It costs 1 % of the mean growth, and shortens unlucky runs.
constexpr double part_of_best_bet = 0.9;

std::string digits(double value) { return formatted("%.17g", value); }

}  // namespace

double drift_to_wait_for(double alpha, double beta) {
  const double z = -boost::math::quantile(boost::math::normal(), alpha / 2);
  const double root = z + std::sqrt(z * z + 2 * std::log(1 / beta));
  return 1.5 * root * root;
}

BadDraw::BadDraw(std::uint64_t draw, double value, const char* problem)
    : std::runtime_error("draw " + std::to_string(draw) + " is " + digits(value) + " (" + problem + ")"),
      draw_(draw) {}

BadDraw::BadDraw(const BadDraw& bad, std::size_t channel)
    : std::runtime_error(formatted("%s, in channel %zu", bad.what(), channel)), draw_(bad.draw_) {}

BettingTest::BettingTest(const MeanHypothesis& hypothesis, double alpha, double beta)
    : hypothesis_(hypothesis), beta_(beta) {
  const auto& h = hypothesis_;
  if (!(alpha > 0 && alpha < 1)) throw std::invalid_argument("the level alpha must be in (0,1)");
  if (!(beta > 0 && beta < 1)) throw std::invalid_argument("the miss rate beta must be in (0,1)");
  drift_ = drift_to_wait_for(alpha * part_for_giving_up, beta);
  refuting_ = (h.sides == Sides::both ? 2 : 1) / (alpha * (1 - part_for_giving_up));
  if (!(h.margin > 0) || !std::isfinite(h.margin)) {
    throw std::invalid_argument("the margin must be positive (no finite sample shows that a bias is exactly zero)");
  }
  if (!(h.lower < h.mean - h.margin && h.mean + h.margin < h.upper)) {
    throw std::invalid_argument("the mean, with its margin, must lie inside the declared range of the draws");
  }
  const double width = std::isinf(h.upper - h.lower) ? reach() : h.upper - h.lower;
  if (!(width > 0 && width < largest_range)) {
    throw std::invalid_argument(
        "the declared range needs a finite end, and must be shorter than 1e100 (rescale the draws: their cubes are "
        "summed)");
  }
  if (!(h.rounding >= 0 && h.rounding <= h.margin / 4)) {
    throw std::invalid_argument("the rounding must be nonnegative and at most a quarter of the margin");
  }
  if (!(h.tail_slack >= 0 && h.tail_slack <= largest_slack * h.margin)) {
    throw std::invalid_argument(
        "the tail slack must be nonnegative and at most 1/20 of the margin (raise the bound)");
  }
}

// The distance from the mean to the far end of the range; an infinite end does not count.
double BettingTest::reach() const {
  const double above = hypothesis_.upper - hypothesis_.mean, below = hypothesis_.mean - hypothesis_.lower;
  return std::max(std::isinf(above) ? 0 : above, std::isinf(below) ? 0 : below);
}

// The l that maximises E[log(1 + l Y)], to third order in l: m - l (s^2 + m^2) - l^2 t = 0, where Y
// has mean m, variance s^2 and third central moment -t. Without t, bets against rare losses lose.
double BettingTest::bet_on(double margin, double variance, double skew) {
  const double square = variance + margin * margin;
  return part_of_best_bet * 2 * margin / (square + std::sqrt(square * square + 4 * margin * skew));
}

// An estimate of the variance of one draw from n draws: the sample's, plus that of an unseen event
// of probability 1/n at the far end of the range; at most what the range and the mean allow (Bhatia
// and Davis 2000). The test is exact for any estimate from earlier draws.
double BettingTest::spread() const {
  const double above = hypothesis_.upper - hypothesis_.mean;
  const double below = hypothesis_.mean - hypothesis_.lower;
  const double unseen = std::pow(reach(), 2);
  const auto n = static_cast<double>(std::max<std::uint64_t>(moments_.count(), 1));
  return std::min(above * below, (moments_.squared_deviations() + unseen) / n);
}

std::uint64_t BettingTest::block_size() const {
  constexpr double largest_block = 65536;
  const double lossless = largest_stake * spread() / (hypothesis_.margin * reach());
  const auto n = static_cast<double>(moments_.count());
  // Lossless for a margin of two standard errors too, which is what the interval shows so far.
  const double reached = largest_stake * std::sqrt(spread() * n) / (2 * reach());
  return static_cast<std::uint64_t>(std::max(1.0, std::min({lossless, reached, n / 8, largest_block})));
}

BettingTest::Outlook BettingTest::outlook(std::uint64_t block) const {
  const auto n = static_cast<double>(moments_.count());
  const auto size = static_cast<double>(block);
  const double skew = n > 0 ? std::abs(moments_.cubed_deviations()) / n : 0;
  return {spread() / size, skew / (size * size)};
}

// Checks the range by the block's extremes; only a bad block is searched for its first bad draw.
BettingTest::Block BettingTest::summarise(std::span<const double> draws) {
  const auto& h = hypothesis_;
  const Moments block = Moments::of(draws);
  const bool in_range = block.minimum() >= h.lower && block.maximum() <= h.upper;
  if (!in_range) check_range(draws);
  double capped = block.mean();
  if (block.maximum() > h.upper) {
    const Eigen::Map<const Eigen::ArrayXd> x(draws.data(), static_cast<Eigen::Index>(draws.size()));
    capped = x.cwiseMin(h.upper).mean();
  }
  const Outlook before = outlook(draws.size());
  moments_.merge(block);
  return {block.mean(), capped, before, bet_on(hypothesis_.margin, before.variance, before.skew)};
}

void BettingTest::check_range(std::span<const double> draws) const {
  std::uint64_t index = moments_.count();
  for (double x : draws) {
    if (!std::isfinite(x)) throw BadDraw(index, x, "not a finite number");
    if (x < hypothesis_.lower) throw BadDraw(index, x, "below its declared lower bound");
    if (x > hypothesis_.upper && hypothesis_.tail_slack == 0) {
      throw BadDraw(index, x, "above its declared upper bound");
    }
    ++index;
  }
}

// The relative gain of a process in one block; `room` is its largest possible loss per unit of bet,
// infinite on a side where the range has no end: there nothing is bet.
double BettingTest::return_of(double bet, double room, double gain) {
  return std::min(bet, largest_stake / room) * gain;
}

// The gains of U0 and D0, which bet against E[X] <= mean and E[X] >= mean.
BettingTest::Gains BettingTest::refute(const Block& block, double bet) const {
  const auto& h = hypothesis_;
  return {return_of(bet, h.mean - h.lower + h.rounding, block.mean - h.mean - h.rounding),
          return_of(bet, h.upper - h.mean + h.tail_slack + h.rounding,
                    h.mean - h.tail_slack - block.capped - h.rounding)};
}

// The gains of U1 and D1, which bet against E[X] <= mean - margin and E[X] >= mean + margin.
BettingTest::Gains BettingTest::certify(const Block& block, double bet, double margin) const {
  const auto& h = hypothesis_;
  return {return_of(bet, h.mean - h.lower - margin, block.mean - h.mean + margin),
          return_of(bet, h.upper - h.mean + h.tail_slack - margin, h.mean - h.tail_slack - block.capped + margin)};
}

void BettingTest::add(std::span<const double> draws) {
  if (draws.empty()) throw std::invalid_argument("a block must hold at least one draw");
  if (verdict_ != Verdict::undecided) {
    // Other channels may still need draws; those of this channel must stay in range.
    check_range(draws);
    return;
  }
  const Block block = summarise(draws);
  blocks_.push_back(block);
  for (std::size_t i = 0; i < mixture_factors.size(); ++i) {
    const Gains refuting = refute(block, mixture_factors[i] * block.bet);
    above_reference_[i].multiply(1 + refuting.up);
    below_reference_[i].multiply(1 + refuting.down);
  }
  const Gains certifying = certify(block, block.bet, hypothesis_.margin);
  above_lower_.multiply(1 + certifying.up);
  below_upper_.multiply(1 + certifying.down);
  decide();
}

double BettingTest::log_mixture(const std::array<LogProduct, 3>& products) {
  const std::array<double, 3> logs{products[0].log(), products[1].log(), products[2].log()};
  const double top = *std::max_element(logs.begin(), logs.end());
  double sum = 0;
  for (std::size_t i = 0; i < logs.size(); ++i) sum += mixture_weights[i] * std::exp(logs[i] - top);
  return top + std::log(sum);
}

double BettingTest::refuting() const { return std::log(refuting_); }

double BettingTest::certifying() const { return std::log(1 / beta_); }

Wealth BettingTest::wealth() const {
  return {log_mixture(above_reference_), log_mixture(below_reference_), below_upper_.log(), above_lower_.log()};
}

// Uses each block's outlook, from before it was drawn.
Wealth BettingTest::wealth_for(double margin) const {
  const auto& h = hypothesis_;
  if (!(margin > 0 && h.lower < h.mean - margin && h.mean + margin < h.upper)) {
    throw std::invalid_argument(
        "the mean, with a margin that is asked for later, must lie inside the declared range");
  }
  LogProduct above_reference, below_reference, below_upper_margin, above_lower_margin;
  for (const Block& block : blocks_) {
    const double bet = bet_on(margin, block.outlook.variance, block.outlook.skew);
    const Gains refuting = refute(block, bet);
    const Gains certifying = certify(block, bet, margin);
    above_reference.multiply(1 + refuting.up);
    below_reference.multiply(1 + refuting.down);
    below_upper_margin.multiply(1 + certifying.down);
    above_lower_margin.multiply(1 + certifying.up);
  }
  return {above_reference.log(), below_reference.log(), below_upper_margin.log(), above_lower_margin.log()};
}

void BettingTest::decide() {
  const bool above = hypothesis_.sides != Sides::not_below;
  const bool below = hypothesis_.sides != Sides::not_above;
  const auto refutes = [this](const std::array<LogProduct, 3>& wealth) {
    // A mixture is at most its largest part, which is faster to test.
    return std::ranges::any_of(wealth, [this](const LogProduct& part) { return part.reaches(refuting_); }) &&
           log_mixture(wealth) >= refuting();
  };
  if ((above && refutes(above_reference_)) || (below && refutes(below_reference_))) {
    verdict_ = Verdict::biased;
  } else if ((!above || below_upper_.reaches(1 / beta_)) && (!below || above_lower_.reaches(1 / beta_))) {
    verdict_ = Verdict::certified;
  }
}

// The first term holds where the variance limits the bets, the second where the range does.
double BettingTest::patience() const {
  const double margin = hypothesis_.margin;
  const double range = hypothesis_.upper - hypothesis_.lower;
  return drift_ * (spread() / (margin * margin) + range / margin);
}

// The first term holds where the variance limits the bets, and was simulated for many laws (see
// `fairlight audit calibration`). The second holds where the range limits them.
double BettingTest::expected_draws() const {
  const double margin = hypothesis_.margin;
  const double range = hypothesis_.upper - hypothesis_.lower;
  return certifying() * (3.7 * moments_.variance() / (margin * margin) + 1.1 * range / margin);
}

}  // namespace fairlight
