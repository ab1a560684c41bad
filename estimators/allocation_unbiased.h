#pragma once

#include <fairlight/estimators/allocation_stages.h>

namespace fairlight {

/// Adaptive images that are unbiased by construction, for any scores: a sample never counts in a
/// mean whose number of samples it helped to choose. If it did, dark pixels would stay dark and
/// bright ones would be diluted by many more samples, so the image would be too dark
/// (allocation_naive.h). `estimate(draw)` gives the mean of every pixel.
/// Bound    a pixel lies within the range of its draws

/// The pilot decides the sample counts, and is then thrown away.
/// Formula  I_i = the mean of n_i samples; n_i >= 1 is a function of the pilot, which is
///          independent of them
/// Domain   budget >= pixels (pilot + 1); the pilot has at least what the score needs; a pilot of 0
///          is plain uniform sampling
/// Random   pixel i's samples by draw(i, first, n), the pilot's first
/// Source   Kirk and Arvo 1991, "Unbiased sampling techniques for image synthesis"
template <AllocationScore Score>
class DiscardedPilot {
 public:
  /// Throws std::invalid_argument outside the domain.
  explicit DiscardedPilot(AllocationPlan plan) : plan_(plan) {
    detail::check_plan(plan, plan.budget, Score::needs, 1);
  }

  template <class Draw>
  std::vector<double> estimate(const Draw& draw) const {
    const PixelHistories pilot = detail::draw_pilot(plan_, draw);
    const std::uint64_t rest = plan_.budget - plan_.pilot * plan_.grid.size();
    return detail::means(detail::draw_stage(draw, pilot, share_out(rest, Score::of(plan_.grid, pilot), 1)));
  }

 private:
  AllocationPlan plan_;
};

/// Weights the mean of each stage by its part of the budget, which is fixed in advance. Given the
/// earlier stages, the mean of a stage is unbiased; so the weighted sum is unbiased.
/// Formula  I_i = sum_k (b_k / b) m_ik; b_k is the number of samples of stage k in the whole image,
///          m_ik the mean of pixel i in stage k
/// Domain   two stages or more, each with a sample of every pixel; the first is the pilot
/// Random   pixel i's samples by draw(i, first, n), stage after stage
/// Source   Owen and Zhou 2020, "The square root rule for adaptive importance sampling"
template <AllocationScore Score>
class FixedStageWeights {
 public:
  /// Throws std::invalid_argument outside the domain.
  explicit FixedStageWeights(AllocationPlan plan, std::uint64_t stages = 2) : sampling_(plan, stages, 1) {}

  template <class Draw>
  std::vector<double> estimate(const Draw& draw) const {
    const std::vector<PixelHistories> drawn = sampling_.run(draw);
    std::vector<double> image(sampling_.plan().grid.size(), 0.0);
    for (std::uint64_t stage = 0; stage < drawn.size(); ++stage) {
      const double weight =
          static_cast<double>(sampling_.budget(stage)) / static_cast<double>(sampling_.plan().budget);
      for (std::size_t i = 0; i < image.size(); ++i) image[i] += weight * drawn[stage][i].mean();
    }
    return image;
  }

 private:
  StagedSampling<Score> sampling_;
};

/// Two independent halves. The pilot of each half chooses the sample counts of the other half, and
/// counts in the mean of its own half. So no sample is thrown away.
/// Formula  I_i = (A_i + B_i) / 2; A_i is the mean of the first half's samples, and their number
///          depends on B's pilot alone; B_i likewise
/// Domain   half the budget >= pixels times pilot; `pilot` is that of one half, and is not 0
/// Random   pixel i's samples: draw(i, first, n) in half A, draw(i, budget + first, n) in half B
/// Source   cross-fitting, after Cox 1975, "A note on data-splitting"; dual buffers: Rousselle,
///          Knaus, Zwicker 2012
template <AllocationScore Score>
class CrossedHalves {
  // There is no third stage. The later samples of a half depend on the other half's pilot through
  // their number. If they chose the counts of that other half, its own pilot would again choose its
  // counts.
 public:
  /// Throws std::invalid_argument outside the domain.
  explicit CrossedHalves(AllocationPlan plan) : plan_(plan) {
    detail::check_plan(plan, plan.budget / 2, std::max<std::uint64_t>(Score::needs, 1), 0);
  }

  template <class Draw>
  std::vector<double> estimate(const Draw& draw) const {
    const auto other = detail::from_sample(plan_.budget, draw);
    const PixelHistories pilot_a = detail::draw_pilot(plan_, draw);
    const PixelHistories pilot_b = detail::draw_pilot(plan_, other);
    const std::vector<double> a = half(draw, pilot_a, pilot_b, plan_.budget - plan_.budget / 2);
    const std::vector<double> b = half(other, pilot_b, pilot_a, plan_.budget / 2);
    std::vector<double> image;
    for (std::size_t i = 0; i < a.size(); ++i) image.push_back((a[i] + b[i]) / 2);
    return image;
  }

 private:
  /// The means of one half. `own` is its pilot, `other` the pilot that chooses its further counts.
  template <class Draw>
  std::vector<double> half(const Draw& draw, PixelHistories own, const PixelHistories& other,
                           std::uint64_t budget) const {
    const std::uint64_t rest = budget - plan_.pilot * plan_.grid.size();
    detail::merge(own, detail::draw_stage(draw, own, share_out(rest, Score::of(plan_.grid, other), 0)));
    return detail::means(own);
  }

  AllocationPlan plan_;
};

}  // namespace fairlight
