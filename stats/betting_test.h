#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

#include <Eigen/Core>

#include <fairlight/stats/log_product.h>
#include <fairlight/stats/moments.h>
#include <fairlight/stats/verdict.h>

namespace fairlight {

/// Which sides of the reference a claim excludes.
enum class Sides {
  both,       ///< the mean is the reference
  not_above,  ///< the mean is at most the reference
  not_below,  ///< the mean is at least the reference
};

/// A claim about a random variable X: its mean, and the range of its draws. Without the range, a
/// mean below the reference cannot be told from mass in a tail that no draw has met.
struct MeanHypothesis {
  double mean;    ///< the reference, E[X]
  double margin;  ///< the bias to exclude, in X's unit; positive
  /// X >= lower, always. One end may be infinite; then nothing is shown that needs it: without an
  /// upper end the test cannot say that the mean is too low, nor certify it from above.
  double lower;
  /// X <= upper always if tail_slack is 0; otherwise E[(X - upper)+] <= tail_slack.
  double upper;
  double tail_slack = 0;  ///< in X's unit
  Sides sides = Sides::both;
  /// The rounding error of the arithmetic, in X's unit. A bias up to it does not count as bias.
  double rounding = 0;
};

/// A draw that the hypothesis excludes: NaN, infinite, or outside its declared range.
class BadDraw : public std::runtime_error {
 public:
  BadDraw(std::uint64_t draw, double value, const char* problem);
  BadDraw(const BadDraw& bad, std::size_t channel);  ///< the same, which names its channel
  std::uint64_t draw() const { return draw_; }

 private:
  std::uint64_t draw_;
};

/// Thrown when the random numbers of a key run out. The draws so far stay valid; the test is
/// undecided.
struct NoMoreDraws : std::length_error {
  using std::length_error::length_error;
};

/// The K at which to give up. On right code, after n = K variance/margin^2 draws at the best bets, log
/// U1 and log D1 are about normal with mean K/2 and variance K. So each is below log(1/beta) with
/// half of the probability alpha when K/2 - z sqrt(K) = log(1/beta). A factor of 1.5 pays for bets
/// placed before the variance is known. Both arguments are in (0,1).
double drift_to_wait_for(double alpha, double beta);

/// The logarithms of the four wealth processes, each of which starts with wealth 1.
struct Wealth {
  double above_reference;     ///< U0, bets that the mean is above the reference
  double below_reference;     ///< D0, bets that the mean is below the reference
  double below_upper_margin;  ///< D1, bets that the mean is below reference + margin
  double above_lower_margin;  ///< U1, bets that the mean is above reference - margin
};

/// A sequential test of a mean by betting. It can certify the mean as well as reject it.
/// Formula  U0 = prod 1 + l (X - mean),  D0 = prod 1 + l (mean - tail_slack - min(X, upper)),
///          U1 = U0 against mean - margin,  D1 = D0 against mean + margin
/// `biased` when U0 or D0 reaches 2/alpha, `certified` when U1 and D1 both reach 1/beta. A
/// one-sided claim uses one pair: not_above uses U0, at 1/alpha, and D1; not_below uses D0 and U1.
/// Guarantee: the error rates hold at any number of draws and any stopping time, by Ville's
/// inequality, and need no normality. See docs/statistics.md, "The betting test".
/// Source   Waudby-Smith and Ramdas 2024; Ville 1939
class BettingTest {
 public:
  /// alpha in (0,1): the probability that a right estimator fails. 98 % of it is for `biased`, 2 %
  /// for giving up. beta in (0,1): the miss rate of `certified`.
  /// Throws std::invalid_argument unless lower < mean - margin, mean + margin < upper and margin >
  /// 0, unless the range has a finite end and is shorter than 1e100, and for a rounding above margin /
  /// 4 or a tail slack above margin / 20.
  BettingTest(const MeanHypothesis& hypothesis, double alpha, double beta);

  /// The number of draws that the next block should hold. It depends on earlier draws only.
  std::uint64_t block_size() const;

  /// Adds one block of one or more draws, and bets on its mean. Throws BadDraw; the test is
  /// unusable afterwards.
  void add(std::span<const double> draws);

  /// `undecided` until a threshold is reached. Later draws do not change the verdict.
  Verdict verdict() const { return verdict_; }

  /// The number of draws at which to give up: a right estimator is still undecided after it with
  /// probability at most alpha/50.
  double patience() const;

  /// About how many draws a right estimator needs for its verdict, if the variance stays as it is.
  double expected_draws() const;

  const Moments& moments() const { return moments_; }
  /// The number of blocks so far, which the interval keeps, at 40 bytes each.
  std::size_t blocks() const { return blocks_.size(); }

  /// The log wealths. U0 and D0 are compared with refuting(), U1 and D1 with certifying().
  Wealth wealth() const;
  double refuting() const;
  double certifying() const;
  Sides sides() const { return hypothesis_.sides; }

  /// The log wealths for another margin, in X's unit, on the same blocks; the bets are recomputed
  /// from earlier draws only, and each process is single, not a mixture. Throws
  /// std::invalid_argument unless the margin is positive and mean +- margin lies inside the range.
  Wealth wealth_for(double margin) const;

  /// A confidence interval of the mean, in X's unit: each end is wrong with probability at most
  /// 1.25 beta (1.4 beta where the test may end undecided), at any stopping time. It inverts the
  /// mixture, whose first part, of weight 0.8 = 1/1.25, bets like the certifying processes: so it
  /// shows whatever they show.
  Interval interval() const;

 private:
  // The prediction for a block's mean, made before the block is drawn: its variance, and the
  // absolute value of its third central moment.
  struct Outlook {
    double variance, skew;
  };

  struct Block {
    double mean;    // of X
    double capped;  // of min(X, upper)
    Outlook outlook;
    double bet;  // l, before the cap that keeps the wealth positive
  };

  // The bets against one side: their sizes, the block means that they are on, and the largest size
  // allowed.
  struct Stakes {
    Eigen::ArrayXd bets, on;
    double largest;
  };

  // The relative gains of a process that bets on large draws and of one that bets on small draws.
  struct Gains {
    double up, down;
  };

  // The largest part of its possible loss that a process bets, so that no block can ruin it.
  static constexpr double largest_stake = 0.9;
  // Larger bets find large biases sooner. A mixture of wealth processes is a wealth process.
  static constexpr std::array<double, 3> mixture_weights{0.8, 0.1, 0.1};
  static constexpr std::array<double, 3> mixture_factors{1.0, 2.5, 8.0};

  static constexpr std::size_t most_blocks_for_grid = 1u << 16;  // it takes a second or so

  static double bet_on(double margin, double variance, double skew);
  static double log_mixture(const std::array<LogProduct, 3>& products);
  static double return_of(double bet, double room, double gain);
  double reach() const;
  Block summarise(std::span<const double> draws);
  void check_range(std::span<const double> draws) const;
  Outlook outlook(std::uint64_t block) const;
  double spread() const;
  Gains refute(const Block& block, double bet) const;
  Gains certify(const Block& block, double bet, double margin) const;
  Stakes stakes(bool above, double margin) const;
  static double evidence(const Stakes& stakes, double candidate, double threshold);
  double end_of_interval(bool above, double margin, double threshold) const;
  Interval interval_of_grid() const;
  void decide();

  MeanHypothesis hypothesis_;
  double beta_;
  double drift_;
  double refuting_;
  Verdict verdict_ = Verdict::undecided;
  Moments moments_;
  std::vector<Block> blocks_;
  std::array<LogProduct, 3> above_reference_{};  // U0, one per part of the mixture
  std::array<LogProduct, 3> below_reference_{};  // D0
  LogProduct above_lower_;                       // U1
  LogProduct below_upper_;                       // D1
};

}  // namespace fairlight
