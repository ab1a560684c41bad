#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <fairlight/stats/betting_test.h>
#include <fairlight/stats/manifest.h>

namespace fairlight {

/// What is claimed of one channel of an estimator. All in the estimator's unit.
struct Reference {
  double mean;
  double lower;  ///< no draw is below
  double upper;  ///< no draw is above; or, with a tail slack, E[(X - upper)+] <= tail_slack
  double tail_slack = 0;
  double scale =
      mean;  ///< what margin and bias are relative to; for a difference, where the mean is 0, its terms' mean
  Sides sides = Sides::both;
  double rounding = 0;  ///< of the arithmetic, relative to scale: a bias up to it is not called one
};

/// The finest margin that a test of these can be asked for, as a rounding may be a quarter of it. In double 0: any.
double finest_margin(const std::vector<Reference>& references);

/// Fills channels[c][i] with channel c of draw first + i, for every i. The channels come with their size.
using DrawBlock = std::function<void(std::uint64_t first, std::vector<std::vector<double>>& channels)>;

/// The core test on every channel of an estimator, each with an equal part of alpha. Certified when
/// all channels are, biased when one is; a draw that the reference rules out is `biased` too, named
/// in the note. Undecided when the cap on draws comes first, which on right code is as rare as a
/// false alarm. Guarantee: exact. The finding shows the channel of the largest bias, of a one-sided
/// claim the way that it excludes. Throws std::invalid_argument for no references, or one that
/// cannot be tested.
Finding test_means(const Trial& trial, const std::vector<Reference>& references, const DrawBlock& draw_block);

/// The same, channel by channel. Where a draw is out of its range, which ends the test, all have the finding that says so.
std::vector<Finding> test_each_mean(const Trial& trial, const std::vector<Reference>& references,
                                    const DrawBlock& draw_block);

/// What the channels of a claim say together: the finding of the largest bias, with the worst verdict and the most draws.
Finding worst_of(const std::vector<Finding>& channels);

/// About how many draws test_means takes of right code whose draws are like these, channels[c][i].
double expected_draws(const Trial& trial, const std::vector<Reference>& references,
                      const std::vector<std::vector<double>>& channels);

/// The same for one channel whose draws come from `draw()`, one at a time, from a source that the caller seeds.
template <class Draw>
Finding test_mean(const Trial& trial, const Reference& reference, Draw&& draw) {
  return test_means(trial, {reference}, [&](std::uint64_t, std::vector<std::vector<double>>& channels) {
    for (double& x : channels[0]) x = draw();
  });
}

}  // namespace fairlight
