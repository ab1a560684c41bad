#pragma once

#include <limits>
#include <optional>

#include <fairlight/stats/manifest.h>
#include <fairlight/validation/run/law_file.h>
#include <fairlight/validation/run/number_stream.h>

namespace fairlight {

/// Verdicts about numbers that another program draws. Each reads rows until the test of stats/ has
/// its verdict, and takes the draws that this test takes from a function that returns the same
/// numbers. If the input ends first, or `most` rows were read, the finding is undecided and its note
/// says so. A NaN, an infinity or a number out of range is `biased`. Throws BadInput for input that
/// cannot be read, and std::invalid_argument for a test that cannot be made.

/// The numbers to judge, and the most rows to read of them.
struct Numbers {
  NumberStream& stream;
  std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
};

/// Every column has this mean. With a range, by betting (exact, any number of columns); without, by
/// Student's guarded test (asymptotic, one column). The margin is relative to `scale`.
Finding judge_mean(const Trial& trial, Numbers numbers, double mean, double scale, std::optional<Interval> range);

/// Two columns have the same mean, or the first columns of two streams, if `other` is given. With a
/// range that holds both, by betting on the difference of the numbers of a row (exact); without, by
/// Welch's test. The margin is relative to `scale`; without one, to the absolute mean of the second
/// column over 4096 rows, which are discarded.
Finding judge_agreement(const Trial& trial, Numbers numbers, NumberStream* other, std::optional<double> scale,
                        std::optional<Interval> range);

/// One column follows a law over intervals. The margin is a relative L2 distance between laws.
Finding judge_law(const Trial& trial, Numbers numbers, const IntervalLaw& law);

/// Rows are uniform in [0,1)^d, d the number of columns, 1 to 16. Guarantee: asymptotic.
Finding judge_uniform(const Trial& trial, Numbers numbers);

}  // namespace fairlight
