#include <limits>

#include <gtest/gtest.h>

#include <fairlight/render/render_image.h>
#include <fairlight/stats/text.h>

namespace fairlight {
namespace {

RenderSettings small(RandomNumbers random, std::uint32_t points) {
  RenderSettings settings;
  settings.width = 7;
  settings.height = 5;
  settings.random = random;
  settings.points = points;
  return settings;
}

Film render(const RenderSettings& settings, SampleRange range, int threads) {
  Film film(settings.width, settings.height);
  render_image(view_of(settings), settings, 11, range, threads, film, {});
  return film;
}

// Sample 2^32 + i is not sample i again, in any arithmetic or kind of numbers, and a range across 2^32 is the sum of its parts.
TEST(RenderImage, HasOtherSamplesBeyondTwoToThe32) {
  constexpr std::uint64_t wrap = std::uint64_t{1} << 32;
  for (const auto& numbers : StrategyTable<RandomNumbers>::rows) {
    for (const auto& real : StrategyTable<Arithmetic>::rows) {
      RenderSettings settings = small(numbers.value, numbers.value == RandomNumbers::independent ? 1 : 4);
      settings.real = real.value;
      const std::string name = formatted("%s %s", numbers.name, real.name);
      const Film beyond = render(settings, {wrap, wrap + 8}, 2);
      EXPECT_NE(beyond, render(settings, {0, 8}, 2)) << name;
      EXPECT_NE(beyond, render(settings, {2 * wrap, 2 * wrap + 8}, 2)) << name;
      Film parts = render(settings, {wrap - 8, wrap}, 2);
      parts.merge(beyond);
      EXPECT_EQ(parts, render(settings, {wrap - 8, wrap + 8}, 2)) << name;
    }
  }
}

TEST(RenderImage, EndsAtTheLastSampleThatHasANumber) {
  constexpr std::uint64_t end = std::numeric_limits<std::uint64_t>::max();
  EXPECT_EQ(render(small(RandomNumbers::independent, 1), {end - 3, end}, 1).at(0, 0)[0].count(), 3u);
}

}  // namespace
}  // namespace fairlight
