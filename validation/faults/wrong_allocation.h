#pragma once

#include <fairlight/estimators/allocation_naive.h>

/// Wrong forms of adaptive sampling, of the class of Kirk and Arvo 1991; naive::PooledStages is the first of them.
namespace fairlight::faults {

/// Each stage's mean weighs as many samples as the pixel got in it, which the earlier samples decided: all samples pooled.
template <AllocationScore Score>
struct StagesWeighedByCounts : naive::PooledStages<Score> {
  StagesWeighedByCounts(AllocationPlan plan, std::uint64_t stages) : naive::PooledStages<Score>(plan, stages, 1) {}
};

/// Two halves, each sized by its own pilot.
template <AllocationScore Score>
class HalvesSizingThemselves {
 public:
  explicit HalvesSizingThemselves(AllocationPlan plan) : half_({plan.grid, plan.budget / 2, plan.pilot}) {}

  template <class Draw>
  std::vector<double> estimate(const Draw& draw) const {
    std::vector<double> image = half_.estimate([&](std::size_t i, std::uint64_t s) { return draw(i, 2 * s); });
    const auto odd = half_.estimate([&](std::size_t i, std::uint64_t s) { return draw(i, 2 * s + 1); });
    for (std::size_t i = 0; i < image.size(); ++i) image[i] = (image[i] + odd[i]) / 2;
    return image;
  }

 private:
  naive::PooledStages<Score> half_;
};

/// Halves that size each other, but put together by their counts, not by one half each: the weight of a half then
/// depends on the pilot of the other.
template <AllocationScore Score>
class HalvesWeighedByCounts {
 public:
  explicit HalvesWeighedByCounts(AllocationPlan plan) : plan_(plan) {}

  template <class Draw>
  std::vector<double> estimate(const Draw& draw) const {
    const auto even = [&](std::size_t i, std::uint64_t s) { return draw(i, 2 * s); };
    const auto odd = [&](std::size_t i, std::uint64_t s) { return draw(i, 2 * s + 1); };
    PixelHistories a = detail::draw_pilot(plan_, even);
    PixelHistories b = detail::draw_pilot(plan_, odd);
    const std::uint64_t rest = plan_.budget / 2 - plan_.pilot * plan_.grid.size();
    const SampleCounts more_a = share_out(rest, Score::of(plan_.grid, b), 0);
    const SampleCounts more_b = share_out(rest, Score::of(plan_.grid, a), 0);
    detail::merge(a, detail::draw_stage(even, a, more_a));
    detail::merge(b, detail::draw_stage(odd, b, more_b));
    detail::merge(a, b);
    return detail::means(a);
  }

 private:
  AllocationPlan plan_;
};

}  // namespace fairlight::faults
