#pragma once

#include <vector>

#include <fairlight/stats/betting_test.h>

namespace fairlight {

/// The margin grid: evidence is summed at the relative margins 2^(-level/2) = 1, 0.71, 0.5, 0.35,
/// ..., whatever the margins of the runs are.
inline constexpr int margin_levels = 64;
double margin_of_level(int level);

/// The evidence of one run for a claim: for each channel, the log wealths at a range of grid
/// levels, from about the run's own margin down to 1/32 of it or less. For a one-sided claim the
/// side that is allowed counts as certified (log wealth infinite) and never as refuted (log wealth
/// 0).
struct MarginGrid {
  int first = 0;                              ///< level of the first entry of each channel
  std::vector<std::vector<Wealth>> channels;  ///< [channel][level - first]
};

/// The grid levels of a run with this relative margin, in (0,1). The first is the finest grid
/// margin that is at least the run's margin.
int first_level(double margin);
std::vector<int> levels_of_run(double margin);

/// The log wealths of a test at those levels. `scale` times a relative margin is the absolute one.
std::vector<Wealth> wealth_at_levels(const BettingTest& test, double margin, double scale);

/// The evidence of a draw that the claim excludes: infinite wealth against the claim.
MarginGrid refuted_grid(double margin, std::size_t channels);

/// The evidence of independent runs. A product of independent e-values is an e-value, so the log
/// wealths of the runs add up.
/// Guarantee, over all runs that are ever added and at any time (Ville's inequality on the sequence
/// of runs): a right claim is called `biased` with probability at most alpha; the certified margin
/// is at most the true bias with probability at most beta. Levels are certified from the coarsest
/// to the finest, each only after all coarser ones, so they share one beta. The largest certifying
/// wealth so far counts. A run's first level stands for all coarser levels.
/// Source   Shafer 2021, "Testing by betting"; Ville 1939
class EvidenceSum {
 public:
  /// One channel at one level: the sums of log wealths over the runs, and the largest values so far
  /// of the two sums that certify.
  struct Sum {
    Wealth total{};
    double below_upper_margin = 0;
    double above_lower_margin = 0;
  };

  EvidenceSum() = default;
  explicit EvidenceSum(const MarginGrid& run);
  EvidenceSum(int first, std::vector<std::vector<Sum>> channels) : first_(first), channels_(std::move(channels)) {}

  /// Adds runs that are later. Throws std::invalid_argument when the number of channels differs.
  void append(EvidenceSum later);

  bool empty() const { return channels_.empty(); }
  int first() const { return first_; }
  const std::vector<std::vector<Sum>>& channels() const { return channels_; }

  /// Whether the mixture of all channels, levels and sides, with equal weights, reaches 1/alpha.
  bool biased(double alpha) const;

  /// The finest relative margin that is certified in all channels; infinite if there is none.
  double certified_margin(double beta) const;

 private:
  void reach(int first, std::size_t end);

  int first_ = 0;
  std::vector<std::vector<Sum>> channels_;  // [channel][level - first_]
};

}  // namespace fairlight
