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

/// Which biases a claim excludes.
enum class Sides {
  both,       ///< the mean is the reference
  not_above,  ///< the mean is at most the reference
  not_below,  ///< the mean is at least the reference
};

/// What is claimed of a random variable X: its mean, and the range that makes "too dark" testable.
struct MeanHypothesis {
  double mean;            ///< the reference, E[X]
  double margin;          ///< the bias to exclude, in X's unit, > 0
  double lower;           ///< X >= lower, always
  double upper;           ///< X <= upper: always if tail_slack is 0, else but for E[(X - upper)+] <= tail_slack
  double tail_slack = 0;  ///< in X's unit
  Sides sides = Sides::both;
  double rounding = 0;  ///< what the arithmetic may add or take, in X's unit: only a bias beyond it is called one
};

/// A draw that the hypothesis rules out: not a number, infinite, or out of its declared range.
class BadDraw : public std::runtime_error {
 public:
  BadDraw(std::uint64_t draw, double value, const char* problem);
  std::uint64_t draw() const { return draw_; }

 private:
  std::uint64_t draw_;
};

/// That there are no more draws, as the random numbers of a key have run out: what a test has seen until then holds, and is undecided.
struct NoMoreDraws : std::length_error {
  using std::length_error::length_error;
};

/// The logarithms of what four processes have made of 1.
struct Wealth {
  double above_reference;  ///< U0, which bets that the mean is above the reference
  double below_reference;  ///< D0, that it is below
  double not_brighter;     ///< D1, that it is below the reference and its margin
  double not_darker;       ///< U1, that it is above the reference less its margin
};

/// Sequential test of a mean by betting, with an accept side.
///
/// Four wealth processes start at 1, and every bet uses earlier draws only:
///   U0 = prod 1 + l (X - mean)                      grows when X is too bright
///   D0 = prod 1 + l (mean - slack - min(X, upper))  grows when X is too dark
///   D1 = D0 against mean + margin,  U1 = U0 against mean - margin
/// (with a declared rounding, U0 bets against mean + rounding and D0 against mean - rounding.)
/// `biased` when U0 or D0 reaches 2/alpha; `certified` when D1 and U1 both reach 1/beta. A one-sided claim
/// (not_above) is biased when U0 reaches 1/alpha and certified when D1 reaches 1/beta, and likewise on the other
/// side. Each process is a nonnegative supermartingale under the hypothesis that it tests, so by Ville's inequality
/// the error rates hold at any stopping time and any number of draws, with no appeal to normality. Draws come in
/// blocks, whose means are bet on; the size of a block depends on earlier draws only. Source: Waudby-Smith and
/// Ramdas 2024, "Estimating means of bounded random variables by betting"; Ville 1939.
class BettingTest {
 public:
  /// alpha: level of all that goes wrong on right code, 98 % of it for `biased` and the rest for giving up; beta: miss rate of `certified`; both in (0,1).
  /// Throws std::invalid_argument when the hypothesis is not lower < mean < upper with a positive margin, or its range is not
  /// shorter than 1e100.
  BettingTest(const MeanHypothesis& hypothesis, double alpha, double beta);

  /// How many draws the next block should hold.
  std::uint64_t block_size() const;

  /// Adds one block of draws (any size from 1). Throws BadDraw, and is then unusable.
  void add(std::span<const double> draws);

  /// undecided until a threshold is reached; then it stands.
  Verdict verdict() const { return verdict_; }

  /// The number of draws after which right code is still undecided with probability at most alpha/50: where to give
  /// up.
  double patience() const;

  /// The number of draws after which right code has its verdict, more or less, if the draws' variance is what it has been.
  double expected_draws() const;

  const Moments& moments() const { return moments_; }

  /// Where the processes stand, and the levels that decide: U0 or D0 at the first, D1 and U1 at the second.
  Wealth wealth() const;
  double refuting() const;
  double certifying() const;
  Sides sides() const { return hypothesis_.sides; }

  /// Where processes would stand that had bet on a bias of another margin, in X's unit, not mixed: on the same blocks, and by the past
  /// alone, as these have. Throws std::invalid_argument for a margin that is not positive or leads out of the range.
  Wealth wealth_for(double margin) const;

  /// Where the mean lies, in X's unit: each end is wrong with probability at most 1.25 beta, at any stopping time.
  /// (The processes that certify bet as the first of the mixture's three, whose weight is 0.8, so what they show,
  /// it shows.)
  Interval interval() const;

 private:
  // What the mean of a block was thought to be like before it was drawn: its variance, and the size of its third central moment.
  struct Outlook {
    double variance, skew;
  };

  struct Block {
    double mean;    // of X
    double capped;  // of min(X, upper)
    Outlook outlook;
    double bet;  // l, before the cap that keeps a process positive
  };

  struct Stakes {  // of one side: what was bet, on what, and the most that may be
    Eigen::ArrayXd bets, on;
    double largest;
  };

  struct Gains {  // of two processes, one that bets on bright draws and one that bets on dark ones
    double up, down;
  };

  Block summarise(std::span<const double> draws);
  void check_range(std::span<const double> draws) const;
  Outlook outlook(std::uint64_t block) const;
  double spread() const;
  Gains refute(const Block& block, double bet) const;
  Gains certify(const Block& block, double bet, double margin) const;
  Stakes stakes(bool above) const;
  double evidence(const Stakes& stakes, double candidate) const;
  double end_of_interval(bool above) const;
  void decide();

  MeanHypothesis hypothesis_;
  double beta_;
  double drift_;
  double refuting_;
  Verdict verdict_ = Verdict::undecided;
  Moments moments_;
  std::vector<Block> blocks_;
  std::array<LogProduct, 3> too_bright_{};  // U0, one per rung of the mixture
  std::array<LogProduct, 3> too_dark_{};    // D0
  LogProduct not_darker_;                   // U1
  LogProduct not_brighter_;                 // D1
};

}  // namespace fairlight
