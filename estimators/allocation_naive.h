#pragma once

#include <fairlight/estimators/allocation_stages.h>

/// What the literature does and the kit does not: here to be measured.
namespace fairlight::naive {

/// *Biased by construction.* Adaptive sampling as the paper has it: the samples that decided are kept, and a pixel
/// is the mean of all its samples. A pixel whose first samples missed its spikes looks quiet, gets no more, and
/// stays dark; one whose first samples met them gets many more, and their weight falls. On four spiky pixels (p =
/// 0.1) the image is 34 % too dark by history and 9 % by neighbours, in closed form
/// (validation/claims/pooled_stages.h); exponential draws in their place show 11 % and 2 %. Use
/// allocation_unbiased.h.
/// Formula  I_i = the mean of all samples of pixel i, their number a function of the earlier of them
/// Domain   two stages or more; the pilot is the first, and not empty
/// Random   pixel i's samples by draw(i, first, n), stage after stage
/// Source   the paper, 3.2.2; its bias: Kirk and Arvo 1991, "Unbiased sampling techniques for image synthesis"
template <AllocationScore Score>
class PooledStages {
 public:
  /// `least` samples of every pixel in each stage after the pilot. Throws std::invalid_argument outside the domain.
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
