#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <fairlight/stats/budget.h>
#include <fairlight/stats/verdict.h>

namespace fairlight {

struct Evidence;

/// What a test of one claim is given: its own random numbers, its share of the false alarms, and what it must show. The last two
/// are for those who look on; no verdict depends on them, except that a test which is told to end is undecided.
struct Trial {
  std::string claim;                         ///< the purpose of its random numbers, so that no two claims share any
  std::uint64_t seed;                        ///< replays it, with the same claim name; see seed_text
  double alpha;                              ///< level: the probability of a false alarm on right code
  double beta;                               ///< miss rate: the probability that a bias of the margin is certified
  double margin;                             ///< the bias to exclude, relative to the reference
  std::function<bool(double done)> watch{};  ///< told now and then how much is done, in [0,1); false ends the test
  Evidence* evidence = nullptr;              ///< where the test leaves what it saw; or nowhere
};

/// Tells those who look on how much is done; whether to go on.
inline bool goes_on(const Trial& trial, double done) { return !trial.watch || trial.watch(done); }

/// The note of a test that was told to end.
inline constexpr const char* told_to_end = "told to end before its verdict";

/// Throws std::invalid_argument unless level, miss rate and margin are all in (0,1). Every test asks this first.
void check_trial(const Trial& trial);

/// The finding with the token of its trial.
Finding with_token(const Trial& trial, Finding finding);

/// The list of all claims of a run, with what they share. A claim that is not on the list has no share, so cannot
/// run.
class Manifest {
 public:
  struct Row {
    std::string name;
    double weight = 1;         ///< its part of the budget
    double margin_factor = 1;  ///< its margin, in units of the run's
    double finest_margin = 0;  ///< its margin where the run's is finer than its roundings allow
  };
  struct Terms {
    std::uint64_t seed;
    double budget = 1e-6;  ///< probability of a false alarm in a run of everything
    double beta = 0.01;    ///< miss rate of each claim at its margin
    double margin = 1e-3;  ///< relative
  };

  /// Throws std::invalid_argument for two rows of one name, no rows, a budget, miss rate or margin outside (0,1),
  /// a weight that is not positive or a finest margin outside [0,1).
  Manifest(std::vector<Row> rows, const Terms& terms);

  /// The trial of a claim: the same whatever else runs. Throws std::invalid_argument for a claim that is not
  /// listed, or whose own margin is 1 or more.
  Trial trial(const std::string& claim) const;

 private:
  std::vector<Row> rows_;
  Terms terms_;
  Budget budget_;
  std::map<std::string, std::size_t> index_;
};

}  // namespace fairlight
