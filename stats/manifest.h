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

/// The inputs of the test of one claim: its random numbers, its share of the false alarms and its
/// margin. The last two members are for progress and reports; no verdict depends on them, except
/// that a test that `watch` ends is undecided.
struct Trial {
  std::string claim;   ///< the purpose of its random numbers: no two claims share any
  std::uint64_t seed;  ///< with the claim's name, replays the test; see seed_text
  double alpha;        ///< level: the probability of a false alarm on right code
  double beta;         ///< miss rate: the probability that a bias of the margin is certified
  double margin;       ///< the bias to exclude, relative to the reference
  /// Called now and then with the fraction done, in [0,1). Returns false to end the test.
  std::function<bool(double done)> watch{};
  Evidence* evidence = nullptr;  ///< where the test records what it observed; may be null
};

/// Reports the fraction done; returns whether the test shall go on.
inline bool goes_on(const Trial& trial, double done) { return !trial.watch || trial.watch(done); }

/// The note of a test that Trial::watch ended.
inline constexpr const char* told_to_end = "told to end before its verdict";

/// Throws std::invalid_argument unless level, miss rate and margin are all in (0,1). Every test
/// calls it first.
void check_trial(const Trial& trial);

/// The finding with its trial's replay token filled in.
Finding with_token(const Trial& trial, Finding finding);

/// The list of all claims of a run, and the terms that they share. Only a claim on the list has a
/// share of the budget and can run.
class Manifest {
 public:
  struct Row {
    std::string name;
    double weight = 1;         ///< its part of the budget, relative to the other weights
    double margin_factor = 1;  ///< its margin divided by the run's margin
    double finest_margin = 0;  ///< least margin that its rounding allows
  };
  struct Terms {
    std::uint64_t seed;
    double budget = 1e-6;   ///< probability of a false alarm in a run of everything
    double beta = 0.01;     ///< miss rate of each claim at its margin
    double margin = 1e-3;   ///< relative
    double joint_part = 0;  ///< part of the budget for what claims show together; the rest is for each alone
  };

  /// Throws std::invalid_argument for two rows of one name, for no rows, for a budget, miss rate or
  /// margin outside (0,1), for a joint part outside [0,1), for a weight that is not positive, or for
  /// a finest margin outside [0,1).
  Manifest(std::vector<Row> rows, const Terms& terms);

  /// The trial of a claim. It does not depend on which other claims run. Throws
  /// std::invalid_argument for a claim that is not listed, or whose own margin is 1 or more.
  Trial trial(const std::string& claim) const;

  /// The level of each of `groups` > 0 groups of claims that are tested together: an equal share of
  /// the joint part.
  double joint_level(std::size_t groups) const {
    return terms_.budget * terms_.joint_part / static_cast<double>(groups);
  }

 private:
  std::vector<Row> rows_;
  Terms terms_;
  Budget budget_;
  std::map<std::string, std::size_t> index_;
};

}  // namespace fairlight
