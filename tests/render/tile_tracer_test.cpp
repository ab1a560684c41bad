#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <fairlight/render/tile_tracer.h>

namespace fairlight {
namespace {

TEST(SetMeans, AreThoseOfConsecutiveSamples) {
  const std::vector<float> samples{1, 2, 3, 4, 5, 9};
  EXPECT_EQ(set_means(std::span<const float>(samples), 2), (std::vector<double>{1.5, 3.5, 7}));
}

// Eight sums and what is left over take every sample once.
TEST(SetMeans, TakeEverySampleOfLongSets) {
  std::vector<double> samples(24);
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i] = std::ldexp(1.0, static_cast<int>(i));
  EXPECT_EQ(set_means(std::span<const double>(samples), 24), (std::vector<double>{(std::ldexp(1.0, 24) - 1) / 24}));
  EXPECT_EQ(set_means(std::span<const double>(samples), 12),
            (std::vector<double>{4095.0 / 12, 4096 * 4095.0 / 12}));
}

// A film refuses a set with a sample that is no radiance, whatever the others make of the mean.
TEST(SetMeans, HideNoSampleThatIsNoRadiance) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  for (const double wrong : {none, -1.0, infinity<double>, -infinity<double>}) {
    for (std::size_t i = 0; i < 12; ++i) {
      std::vector<double> samples(12, 7);
      samples[i] = wrong;
      const std::vector<double> means = set_means(std::span<const double>(samples), 12);
      Film film(1, 1);
      EXPECT_THROW(film.add(0, 0, std::array<std::span<const double>, 3>{means, means, means}), std::domain_error)
          << wrong << " " << i;
    }
  }
}

}  // namespace
}  // namespace fairlight
