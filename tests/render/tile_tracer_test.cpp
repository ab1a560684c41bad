#include <limits>

#include <gtest/gtest.h>

#include <fairlight/render/tile_tracer.h>

namespace fairlight {
namespace {

TEST(SetMeans, AreThoseOfConsecutiveSamples) {
  const std::vector<float> samples{1, 2, 3, 4, 5, 9};
  EXPECT_EQ(set_means(std::span<const float>(samples), 2), (std::vector<double>{1.5, 3.5, 7}));
}

// A film refuses a set with a sample that is no radiance, whatever the others make of the mean.
TEST(SetMeans, HideNoSampleThatIsNoRadiance) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  for (const double wrong : {none, -1.0, infinity<double>, -infinity<double>}) {
    const std::vector<double> samples{7, wrong, 7, 7};
    const std::vector<double> means = set_means(std::span<const double>(samples), 4);
    Film film(1, 1);
    EXPECT_THROW(film.add(0, 0, std::array<std::span<const double>, 3>{means, means, means}), std::domain_error)
        << wrong;
  }
}

}  // namespace
}  // namespace fairlight
