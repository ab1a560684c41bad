#pragma once

#include <vector>

#include <fairlight/stats/betting_test.h>

namespace fairlight {

/// The margins at which the evidence of runs is added up, whatever their own margins were: 1, 0.71, 0.5, 0.35, ..., relative.
inline constexpr int rungs = 64;
double margin_of_rung(int rung);

/// What one run says of a claim: for each channel, the wealth of processes that bet for the margins of a few rungs, from the run's
/// own margin down to a thirty-second of it. What is not claimed counts as shown, and is never refuted: its logarithms are
/// infinite and 0.
struct MarginGrid {
  int first = 0;                              ///< rung
  std::vector<std::vector<Wealth>> channels;  ///< [channel][rung - first]
};

/// The rungs of a run of this relative margin, in (0,1): the first is the finest that is no finer than it.
int first_level(double margin);
std::vector<int> rungs_of_run(double margin);

/// What a test says at those rungs; `scale` makes a margin absolute.
std::vector<Wealth> wealth_at_rungs(const BettingTest& test, double margin, double scale);

/// A draw that the claim rules out: evidence without end that it is false.
MarginGrid refuted_ladder(double margin, std::size_t channels);

/// What independent runs say together. A product of independent e-values is one, so a run multiplies the wealth that those
/// before it left; logarithms add up.
///
/// Guarantee, over all the runs that an account will ever hold, at any time that one looks (Ville's inequality, on the
/// sequence of runs): it says `biased` of a right claim with probability at most alpha; and the margin that it certifies is
/// at most the bias of a wrong one with probability at most beta. For the latter the rungs are taken from the coarsest to the
/// finest, each only after those before it, so that they share one beta; and as what is shown stays shown, the greatest wealth
/// counts that the runs so far have left. What is held against a bias as large as one rung's holds against a larger one, so a run
/// says of the rungs above its first what it says of the first. Sources: Shafer 2021, "Testing by betting"; Ville 1939.
class EvidenceSum {
 public:
  /// Of one channel at one rung: logarithms of products over runs, and the greatest that the two which certify have been.
  struct Sum {
    Wealth total{};
    double not_brighter = 0;
    double not_darker = 0;
  };

  EvidenceSum() = default;
  explicit EvidenceSum(const MarginGrid& run);
  EvidenceSum(int first, std::vector<std::vector<Sum>> channels) : first_(first), channels_(std::move(channels)) {}

  /// Adds runs that came after. Throws std::invalid_argument when they have other channels.
  void append(EvidenceSum later);

  bool empty() const { return channels_.empty(); }
  int first() const { return first_; }
  const std::vector<std::vector<Sum>>& channels() const { return channels_; }

  /// By the mixture of all channels, rungs and sides, each with the same weight.
  bool biased(double alpha) const;

  /// The finest margin that is certified in all channels, relative; infinite where none is.
  double certified_margin(double beta) const;

 private:
  void reach(int first, std::size_t end);

  int first_ = 0;
  std::vector<std::vector<Sum>> channels_;  // [channel][rung - first_]
};

}  // namespace fairlight
