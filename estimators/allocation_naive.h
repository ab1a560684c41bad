#pragma once

#include <fairlight/estimators/allocation_stages.h>

/// Methods from the literature that the kit does not use. They are here so that their bias can be
/// measured.
namespace fairlight::naive {

/// *Biased by construction.* Adaptive sampling as in the paper: each pixel is the mean of all its
///   samples, including those that decided the counts. Use allocation_unbiased.h instead.
/// Formula  I_i = the mean of all samples of pixel i; their number is a function of the earlier
///          ones
/// Domain   two stages or more; the first is the pilot, and is not empty
/// Random   pixel i's samples by draw(i, first, n), stage after stage
/// Source   the paper, 3.2.2; its bias: Kirk and Arvo 1991, "Unbiased sampling techniques for image
///          synthesis"
template <AllocationScore Score>
class PooledStages {
  // Why it is biased: a pixel whose first samples missed its spikes looks quiet, gets no more
  // samples and stays dark. A pixel whose first samples met a spike gets many more, and the weight
  // of the spike falls. On four spiky pixels (p = 0.1) the image is 34 % too dark with scores from
  // the history, and 9 % with scores from the neighbours, both in closed form
  // (validation/analytic/pooled_stages.h). Exponential draws instead give 11 % and 2 %.
 public:
  /// Each stage after the pilot gives every pixel at least `least` samples. Throws
  /// std::invalid_argument outside the domain.
  explicit PooledStages(AllocationPlan plan, std::uint64_t stages = 2, std::uint64_t least = 0)
      : sampling_(plan, stages, least) {}

  template <class Draw>
  std::vector<double> estimate(const Draw& draw) const {
    PixelHistories all(sampling_.plan().grid.size());
    for (const PixelHistories& stage : sampling_.run(draw)) detail::merge(all, stage);
    return detail::means(all);
  }

 private:
  StagedSampling<Score> sampling_;
};

}  // namespace fairlight::naive
