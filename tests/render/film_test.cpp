#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fairlight/render/film.h>

namespace fairlight {
namespace {

TEST(Film, HoldsMeanVarianceAndCountOfAPixel) {
  Film film(2, 3);
  film.add(1, 2, {1, 0, 4});
  film.add(1, 2, {3, 0, 4});
  EXPECT_TRUE((film.mean(1, 2) == Rgb<double>(2, 0, 4)).all());
  EXPECT_EQ(film.at(1, 2)[0].variance(), 2);
  EXPECT_EQ(film.at(1, 2)[2].variance(), 0);
  EXPECT_EQ(film.at(1, 2)[0].count(), 2u);
  EXPECT_EQ(film.at(0, 0)[0].count(), 0u);
}

RC_GTEST_PROP(Film, IsTheSameForEverySplitOfItsSamples, (std::vector<std::uint8_t> owners)) {
  Film whole(2, 2);
  std::vector<Film> parts(4, Film(2, 2));
  for (std::size_t i = 0; i < owners.size(); ++i) {
    const double x = 1.0 / static_cast<double>(3 * i + 1);
    const Rgb<double> sample(x, 1e9 * x, 1e-9 * x);
    const int pixel = static_cast<int>(i % 4);
    whole.add(pixel % 2, pixel / 2, sample);
    parts[owners[i] % 4].add(pixel % 2, pixel / 2, sample);
  }
  Film merged(2, 2);
  for (std::size_t i = parts.size(); i-- > 0;) merged.merge(parts[i]);
  RC_ASSERT(merged == whole);
}

TEST(Film, NamesThePixelOfASampleThatIsNoRadiance) {
  Film film(4, 4);
  for (double wrong : {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    try {
      film.add(3, 1, {wrong, 0, 0});
      FAIL();
    } catch (const std::domain_error& error) {
      EXPECT_NE(std::string(error.what()).find("(3, 1)"), std::string::npos) << error.what();
    }
  }
}

TEST(Film, RefusesImpossibleSizes) {
  EXPECT_THROW(Film(0, 1), std::invalid_argument);
  EXPECT_THROW(Film(1, -1), std::invalid_argument);
  EXPECT_THROW(Film(1, 65537), std::invalid_argument);
  Film film(2, 2);
  EXPECT_THROW(film.merge(Film(2, 3)), std::invalid_argument);
}

}  // namespace
}  // namespace fairlight
