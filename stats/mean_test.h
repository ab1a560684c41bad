#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <fairlight/stats/betting_test.h>
#include <fairlight/stats/manifest.h>

namespace fairlight {

/// The claim about one channel of an estimator, in the estimator's unit.
struct Reference {
  double mean;
  double lower;  ///< no draw is below it
  double upper;  ///< no draw is above it; with a tail slack, E[(X - upper)+] <= tail_slack
  double tail_slack = 0;
  /// What margin and bias are divided by. For a difference, whose mean is 0, the mean of its terms.
  double scale = mean;
  Sides sides = Sides::both;
  /// The rounding error of the arithmetic, divided by scale. A bias up to it does not count as
  /// bias.
  double rounding = 0;
};

/// The finest margin that a test of these references admits: four times the largest rounding. 0 in
/// double, where any margin is admitted.
double finest_margin(const std::vector<Reference>& references);

/// Fills channels[c][i] with channel c of draw first + i, for every i. The caller sets the sizes.
using DrawBlock = std::function<void(std::uint64_t first, std::vector<std::vector<double>>& channels)>;

/// The draws of one channel: `draw(i)` gives draw i.
template <class Draw>
DrawBlock one_channel(const Draw& draw) {
  return [draw](std::uint64_t first, std::vector<std::vector<double>>& channels) mutable {
    for (std::size_t i = 0; i < channels[0].size(); ++i) channels[0][i] = draw(first + i);
  };
}

/// The core test on every channel of an estimator; each channel has an equal part of alpha.
/// Certified when all channels are, biased when one is, undecided when the cap on draws comes first
/// (on right code as rare as a false alarm). A draw outside its range is `biased`, with a note that
/// names it.
/// Guarantee: exact; with a tail slack, exact given its tail. The finding shows the channel that
/// failed, and names it; of channels with one verdict, one whose interval excludes 0, then the
/// largest bias in an excluded direction. Throws
/// std::invalid_argument for no references, or for one that cannot be tested.
Finding test_means(const Trial& trial, const std::vector<Reference>& references, const DrawBlock& draw_block);

/// The same, one finding per channel. A draw outside its range ends the test; every channel then
/// gets the finding that names it.
std::vector<Finding> test_each_mean(const Trial& trial, const std::vector<Reference>& references,
                                    const DrawBlock& draw_block);

/// One finding for all channels: that of the worst verdict, as test_means shows it, with the largest
/// number of draws.
Finding worst_of(const std::vector<Finding>& channels);

/// About how many draws test_means needs on right code whose draws resemble channels[c][i].
double expected_draws(const Trial& trial, const std::vector<Reference>& references,
                      const std::vector<std::vector<double>>& channels);

/// test_means for one channel whose draws come from `draw()`, one at a time, with random numbers
/// that the caller seeds.
template <class Draw>
Finding test_mean(const Trial& trial, const Reference& reference, Draw&& draw) {
  return test_means(trial, {reference}, [&](std::uint64_t, std::vector<std::vector<double>>& channels) {
    for (double& x : channels[0]) x = draw();
  });
}

}  // namespace fairlight
