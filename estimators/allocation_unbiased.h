#pragma once

#include <fairlight/estimators/allocation_stages.h>

namespace fairlight {

/// Adaptive images that are unbiased by construction, whatever the scores: no sample counts in a mean whose number
/// of samples it helped to choose. (Where it does, dark pilots are frozen and bright ones are washed out by many
/// more samples, which darkens: allocation_naive.h.) `estimate(draw)` gives the mean of every pixel.
///
/// Bound: a pixel lies within the range of its draws.

/// The pilot's samples decide, and are thrown away.
/// Formula  I_i = the mean of n_i samples, n_i a function of the pilot, which is independent of them; n_i >= 1
/// Domain   budget >= pixels (pilot + 1); pilot at least what the score needs, and 0 makes plain uniform sampling
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

/// Each stage's means count with a weight that was fixed before anything was drawn: its part of the budget. Given
/// the stages before it, a stage's mean is unbiased, so the weighted sum is.
/// Formula  I_i = sum_k (b_k / b) m_ik, b_k the samples of stage k in the whole image, m_ik the mean of pixel i's
///          in it
/// Domain   two stages or more, each with a sample of every pixel; the pilot is the first
/// Random   pixel i's samples by draw(i, first, n), stage after stage
/// Source   Owen and Zhou 2020, "The square root rule for adaptive importance sampling" (weights fixed in advance)
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

/// Two independent halves, each with a pilot that sizes the other half and counts in its own: nothing is thrown
/// away. There are no further stages: a half's later samples were sized by the other's pilot, so what they show
/// depends on it, and to size that other half by them would choose its counts by its own pilot again.
/// Formula  I_i = (A_i + B_i) / 2, A_i the mean of the first half's samples, their number a function of B's pilot
///          alone
/// Domain   half the budget >= pixels times pilot, a pilot being that of one half, and not empty
/// Random   pixel i's samples by draw(i, first, n) in the first half, and by draw(i, budget + first, n) in the second
/// Source   cross-fitting, after Cox 1975, "A note on data-splitting"; two buffers that steer each other:
///          Rousselle, Knaus, Zwicker 2012
template <AllocationScore Score>
class CrossedHalves {
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
  /// The means of a half that has drawn `own`, continued as the other's pilot says.
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
