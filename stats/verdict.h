#pragma once

#include <cstdint>
#include <string>

namespace fairlight {

/// The three outcomes of a statistical test. "No difference seen" is none of them.
enum class Verdict {
  certified,  ///< the bias is smaller than the margin, at the stated miss rate
  biased,     ///< the bias is not zero, at the stated level
  undecided,  ///< the cap on draws was reached first; counts as a failure
};

/// How strong a verdict is.
enum class Guarantee {
  deterministic,  ///< no randomness: an identity that was checked
  exact,          ///< holds at any number of draws, by Ville's inequality
  /// The same, if a declared tail or variance is right, which no draw can show: it is taken on trust.
  exact_given_tail,
  asymptotic,  ///< holds in the limit of many draws, under the conditions that the test states
};

/// A closed interval [lo, hi], whose ends may be infinite.
struct Interval {
  double lo;
  double hi;
};

/// The result of one check. Bias and interval are relative to the reference (dimensionless). An end
/// of the interval is infinite where nothing is known yet. For a one-sided claim the end on the
/// allowed side is infinite too, unless the interval lies wholly on the excluded side.
struct Finding {
  Verdict verdict = Verdict::undecided;
  Guarantee guarantee = Guarantee::deterministic;
  double margin = 0;        ///< the bias that `certified` excludes, relative
  double bias = 0;          ///< the estimate of the bias, relative
  Interval interval{0, 0};  ///< each end is wrong with at most the miss rate
  std::uint64_t draws = 0;  ///< the number of draws that the verdict took
  /// The rounding error of the arithmetic, relative. A bias up to it does not count as bias.
  double rounding = 0;
  std::string token{};  ///< replays it, with the claim's name: the seed, 16 hexadecimal digits
  std::string note{};   ///< one more sentence, such as why the test is not exact; or empty
};

const char* name(Verdict verdict);
const char* name(Guarantee guarantee);

/// The worse of two verdicts: biased before undecided before certified.
Verdict worse(Verdict a, Verdict b);

}  // namespace fairlight
