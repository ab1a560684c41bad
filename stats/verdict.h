#pragma once

#include <cstdint>
#include <string>

namespace fairlight {

/// The three outcomes of a statistical test. There is no fourth: "no difference seen" is not an outcome.
enum class Verdict {
  certified,  ///< evidence, at the stated miss rate, that the bias is smaller than the margin
  biased,     ///< evidence, at the stated level, that the bias is not zero
  undecided,  ///< the cap on draws came first; it counts as a failure
};

/// What a verdict rests on.
enum class Guarantee {
  deterministic,  ///< no randomness: an identity, checked
  exact,          ///< holds at any number of draws, by Ville's inequality
  asymptotic,     ///< holds in the limit of many draws, under the conditions that the test states
};

/// A closed interval [lo, hi], whose ends may be infinite.
struct Interval {
  double lo;
  double hi;
};

/// What one check found. Bias and interval are relative to the reference (dimensionless). An end of
/// the interval is infinite where nothing is known yet, and on the side of a one-sided claim ("at
/// most", "at least") that it allows, unless the interval has none of that side.
struct Finding {
  Verdict verdict = Verdict::undecided;
  Guarantee guarantee = Guarantee::deterministic;
  double margin = 0;        ///< the bias that `certified` excludes, relative
  double bias = 0;          ///< the estimate of the bias, relative
  Interval interval{0, 0};  ///< each end is wrong with at most the miss rate
  std::uint64_t draws = 0;  ///< how many draws the verdict took
  double rounding = 0;      ///< of the arithmetic, relative: a bias up to it is not called one
  std::string token{};      ///< with the claim's name, replays it: the seed, as 16 hexadecimal digits
  std::string note{};       ///< one sentence where there is more to say, such as why it is not exact; or empty
};

const char* name(Verdict verdict);
const char* name(Guarantee guarantee);

/// The worse of two verdicts: biased before undecided before certified.
Verdict worse(Verdict a, Verdict b);

}  // namespace fairlight
