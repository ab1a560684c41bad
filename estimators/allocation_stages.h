#pragma once

#include <fairlight/estimators/allocation.h>

namespace fairlight {

/// The number of samples of an image, and of its pilot.
struct AllocationPlan {
  PixelGrid grid;
  std::uint64_t budget;  ///< samples of the whole image, pilot included; used up exactly
  std::uint64_t pilot;   ///< samples of every pixel before the first scores
};

namespace detail {

/// Throws std::invalid_argument unless the pilot has at least `needs` samples, and the budget
/// covers the pilot and `after` more samples for every pixel.
inline void check_plan(const AllocationPlan& plan, std::uint64_t budget, std::uint64_t needs, std::uint64_t after) {
  if (plan.pilot < needs) {
    throw std::invalid_argument("a pilot of " + std::to_string(plan.pilot) + " samples a pixel (at least " +
                                std::to_string(needs) + " are needed)");
  }
  const std::uint64_t each = budget / plan.grid.size();
  if (each < plan.pilot || each - plan.pilot < after) {
    throw std::invalid_argument("a budget of " + std::to_string(budget) + " samples is too small (" +
                                std::to_string(plan.grid.size()) + " pixels need a pilot of " +
                                std::to_string(plan.pilot) + " and " + std::to_string(after) + " more each)");
  }
}

/// The same draws, with sample numbers shifted by `start`.
template <class Draw>
auto from_sample(std::uint64_t start, const Draw& draw) {
  return
      [=, &draw](std::size_t pixel, std::uint64_t first, std::uint64_t n) { return draw(pixel, start + first, n); };
}

/// Draws counts[i] samples of each pixel i, numbered after those of its history.
template <class Draw>
PixelHistories draw_stage(const Draw& draw, const PixelHistories& histories, const SampleCounts& counts) {
  PixelHistories stage;
  for (std::size_t pixel = 0; pixel < counts.size(); ++pixel) {
    stage.push_back(Moments::of(draw(pixel, histories[pixel].count(), counts[pixel])));
  }
  return stage;
}

/// Draws the first `plan.pilot` samples of every pixel.
template <class Draw>
PixelHistories draw_pilot(const AllocationPlan& plan, const Draw& draw) {
  return draw_stage(draw, PixelHistories(plan.grid.size()), SampleCounts(plan.grid.size(), plan.pilot));
}

inline void merge(PixelHistories& histories, const PixelHistories& stage) {
  for (std::size_t pixel = 0; pixel < stage.size(); ++pixel) histories[pixel].merge(stage[pixel]);
}

inline std::vector<double> means(const PixelHistories& histories) {
  std::vector<double> image;
  for (const Moments& history : histories) image.push_back(history.mean());
  return image;
}

}  // namespace detail

/// Samples in stages: first the pilot, then the rest of the budget in `stages` - 1 parts, which are
/// as equal as integers allow. The scores of all earlier samples share out each part.
template <AllocationScore Score>
class StagedSampling {
 public:
  /// Each stage after the pilot gives every pixel at least `least` samples. Throws
  /// std::invalid_argument if there are fewer than two stages, if the pilot is empty or smaller
  /// than the score needs, or if the budget is too small.
  StagedSampling(AllocationPlan plan, std::uint64_t stages, std::uint64_t least)
      : plan_(plan), stages_(stages), least_(least) {
    if (stages < 2) throw std::invalid_argument("fewer than two stages (the first is the pilot)");
    detail::check_plan(plan, plan.budget, std::max<std::uint64_t>(Score::needs, 1), 0);
    for (std::uint64_t stage = 1; stage < stages; ++stage) {
      if (budget(stage) / plan.grid.size() < least) {
        throw std::invalid_argument("a budget of " + std::to_string(plan.budget) +
                                    " samples is too small (every pixel needs " + std::to_string(least) +
                                    " in each stage)");
      }
    }
  }

  std::uint64_t stages() const { return stages_; }
  const AllocationPlan& plan() const { return plan_; }

  /// The number of samples of a stage, over all pixels. It is fixed in advance.
  std::uint64_t budget(std::uint64_t stage) const {
    const std::uint64_t pilot = plan_.pilot * plan_.grid.size();
    if (stage == 0) return pilot;
    const std::uint64_t rest = plan_.budget - pilot;
    return rest / (stages_ - 1) + (stage <= rest % (stages_ - 1) ? 1 : 0);
  }

  /// The moments of each stage on its own.
  template <class Draw>
  std::vector<PixelHistories> run(const Draw& draw) const {
    std::vector<PixelHistories> drawn{detail::draw_pilot(plan_, draw)};
    PixelHistories histories = drawn[0];
    for (std::uint64_t stage = 1; stage < stages_; ++stage) {
      const SampleCounts counts = share_out(budget(stage), Score::of(plan_.grid, histories), least_);
      drawn.push_back(detail::draw_stage(draw, histories, counts));
      detail::merge(histories, drawn.back());
    }
    return drawn;
  }

 private:
  AllocationPlan plan_;
  std::uint64_t stages_, least_;
};

}  // namespace fairlight
