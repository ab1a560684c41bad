#pragma once

#include <fairlight/estimators/allocation_naive.h>
#include <fairlight/validation/claims/image_numbers.h>

/// Wrong forms of adaptive sampling, of the class of Kirk and Arvo 1991. naive::PooledStages is the
/// first of them.
namespace fairlight::faults {

/// Weights the mean of each stage by the number of samples of the pixel, which earlier samples
/// determine. This pools all samples.
template <AllocationScore Score>
struct StagesWeighedByCounts : naive::PooledStages<Score> {
  StagesWeighedByCounts(AllocationPlan plan, std::uint64_t stages) : naive::PooledStages<Score>(plan, stages, 1) {}
};

/// Takes all samples of a pixel from one point set, stage after stage, so that the samples of the
/// pilot are strata of the later ones.
struct FromOneSet {
  using Real = double;
  std::string suffix = ".sobol";
  std::vector<std::string> subjects;
  double margin_factor = 2;

  template <class Pixels>
  static auto draws(const StreamKey& key, const Pixels& pixels, std::uint64_t r) {
    const ImagePlace place(key, r, pixels.grid.size());
    return [=](std::size_t pixel, std::uint64_t first, std::uint64_t n) {
      const OwenSobol<double> set(place.key, place.first + static_cast<std::uint32_t>(pixel), 128);
      std::vector<double> samples;
      for (std::uint64_t i = first; i < first + n; ++i) {
        auto source = set.source(static_cast<std::uint32_t>(i));
        samples.push_back(pixels(pixel, source));
      }
      return samples;
    };
  }
};

/// Two halves, each with a number of samples from its own pilot.
template <AllocationScore Score>
class HalvesSizingThemselves {
 public:
  explicit HalvesSizingThemselves(AllocationPlan plan)
      : plan_(plan), half_({plan.grid, plan.budget / 2, plan.pilot}) {}

  template <class Draw>
  std::vector<double> estimate(const Draw& draw) const {
    std::vector<double> image = half_.estimate(draw);
    const auto other = half_.estimate(detail::from_sample(plan_.budget, draw));
    for (std::size_t i = 0; i < image.size(); ++i) image[i] = (image[i] + other[i]) / 2;
    return image;
  }

 private:
  AllocationPlan plan_;
  naive::PooledStages<Score> half_;
};

/// Halves that set the size of each other, but weighted by their counts instead of by one half
/// each. The weight of a half then depends on the pilot of the other.
template <AllocationScore Score>
class HalvesWeighedByCounts {
 public:
  explicit HalvesWeighedByCounts(AllocationPlan plan) : plan_(plan) {}

  template <class Draw>
  std::vector<double> estimate(const Draw& draw) const {
    const auto other = detail::from_sample(plan_.budget, draw);
    PixelHistories a = detail::draw_pilot(plan_, draw);
    PixelHistories b = detail::draw_pilot(plan_, other);
    const std::uint64_t rest = plan_.budget / 2 - plan_.pilot * plan_.grid.size();
    const SampleCounts more_a = share_out(rest, Score::of(plan_.grid, b), 0);
    const SampleCounts more_b = share_out(rest, Score::of(plan_.grid, a), 0);
    detail::merge(a, detail::draw_stage(draw, a, more_a));
    detail::merge(b, detail::draw_stage(other, b, more_b));
    detail::merge(a, b);
    return detail::means(a);
  }

 private:
  AllocationPlan plan_;
};

}  // namespace fairlight::faults
