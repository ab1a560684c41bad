#include <cmath>
#include <stdexcept>

#include <boost/math/distributions/binomial.hpp>
#include <gtest/gtest.h>
#include <support/noisy_pictures.h>
#include <support/run_seed.h>

namespace fairlight {
namespace {

using testing::NoisyPictures;
using testing::unchanged;

// The most that chance allows in so many runs at a rate, but once in 10^7.
double limit(int runs, double rate) { return quantile(complement(boost::math::binomial(runs, rate), 1e-7)); }

// How many of `runs` comparisons have this verdict.
template <class Compare>
int count(Likeness verdict, int runs, const Compare& compare) {
  int found = 0;
  for (int i = 0; i < runs; ++i) found += compare().verdict == verdict;
  return found;
}

struct Pictures {
  NoisyPictures noisy;
  PictureCells cells{noisy.region(), 6};
  std::mt19937_64 generator{testing::run_seed()};
  std::vector<int> samples_a = std::vector<int>(8, 64), samples_b = samples_a;
  ErrorLayer layer = ErrorLayer::none;
  CompareOptions options;

  template <class Factor>
  Comparison compare(const Factor& factor) {
    const SideOfCells a = noisy.side(cells, generator, samples_a, factor, layer);
    const SideOfCells b = noisy.side(cells, generator, samples_b, unchanged, layer);
    return compare_cells(cells, a, b, options);
  }
};

TEST(CompareCells, RaisesFewFalseAlarmsOnEqualImages) {
  Pictures pictures;
  pictures.options.alpha = 0.1;
  EXPECT_LE(count(Likeness::different, 1000, [&] { return pictures.compare(unchanged); }), limit(1000, 0.1));
}

TEST(CompareCells, RaisesFewFalseAlarmsUnderAWideFilterAndUnequalCounts) {
  Pictures pictures;
  pictures.noisy.wide_filter = true;
  pictures.samples_a = {4, 64, 16, 256};
  pictures.samples_b = std::vector<int>(9, 16);
  pictures.options.alpha = 0.1;
  EXPECT_LE(count(Likeness::different, 1000, [&] { return pictures.compare(unchanged); }), limit(1000, 0.1));
}

TEST(CompareCells, RaisesFewFalseAlarmsOnSinglePictures) {
  Pictures pictures;
  pictures.samples_a = {64};
  pictures.samples_b = {256};
  pictures.layer = ErrorLayer::standard_error;
  pictures.options.alpha = 0.1;
  EXPECT_LE(count(Likeness::different, 1000, [&] { return pictures.compare(unchanged); }), limit(1000, 0.1));
}

TEST(CompareCells, RaisesFewFalseAlarmsWithAFittedScale) {
  Pictures pictures;
  pictures.options.alpha = 0.1;
  pictures.options.fit_scale = true;
  EXPECT_LE(count(Likeness::different, 1000, [&] { return pictures.compare([](int, int) { return 2.5; }); }),
            limit(1000, 0.1));
}

// The brightness of pictures varies by the noise of one half, which shows in the other half, that
// has none, when the scale is fitted.
TEST(CompareCells, PaysForAFittedScale) {
  Pictures pictures;
  pictures.noisy.noisy_columns = 12;
  pictures.options.fit_scale = true;
  pictures.options.alpha = 0.1;
  EXPECT_LE(count(Likeness::different, 100, [&] { return pictures.compare(unchanged); }), limit(100, 0.1));
}

// The whole is at its margin, and tiles and border are far inside theirs. Channels are equal: else
// all three would have to be missed at once.
TEST(CompareCells, SeldomMissesADifferenceOfTheMargin) {
  Pictures pictures;
  pictures.noisy.luminaire = 1;
  pictures.noisy.grey = true;
  pictures.options = {.margin = 0.05, .tile_margin = 0.4, .alpha = 1e-12};  // else it is called different
  EXPECT_EQ(count(Likeness::same, 50, [&] { return pictures.compare(unchanged); }), 50) << "it can be shown";
  EXPECT_LE(count(Likeness::same, 200, [&] { return pictures.compare([](int, int) { return 1.05; }); }),
            limit(200, 0.01));
}

TEST(CompareCells, FindsAWallThatIsTooDark) {
  Pictures pictures;
  pictures.samples_a = pictures.samples_b = std::vector<int>(8, 1024);
  const auto dark_wall = [](int x, int) { return x < 6 ? 0.9 : 1; };
  EXPECT_EQ(count(Likeness::different, 20, [&] { return pictures.compare(dark_wall); }), 20);
}

TEST(CompareCells, FindsTwiceTheBrightnessInNoise) {
  Pictures pictures;
  pictures.samples_a = pictures.samples_b = std::vector<int>(8, 16);
  EXPECT_EQ(count(Likeness::different, 20, [&] { return pictures.compare([](int, int) { return 2; }); }), 20);
}

TEST(CompareCells, NamesTheTileThatDiffersMost) {
  Pictures pictures;
  pictures.samples_a = pictures.samples_b = std::vector<int>(8, 256);
  const Comparison comparison =
      pictures.compare([](int x, int y) { return x >= 6 && x < 12 && y >= 18 && y < 24 ? 1.5 : 1; });
  EXPECT_EQ(comparison.verdict, Likeness::different);
  EXPECT_EQ(pictures.cells.tile_window(comparison.worst / 3), (PixelWindow{6, 18, 12, 24}));
  EXPECT_GT(comparison.tiles[comparison.worst].interval.lo, 0);
}

TEST(CompareCells, ComparesWithAKnownScale) {
  Pictures pictures;
  pictures.samples_a = pictures.samples_b = std::vector<int>(8, 1024);
  const auto brighter = [](int, int) { return 2.5; };
  EXPECT_EQ(pictures.compare(brighter).verdict, Likeness::different);
  pictures.options.scale = 2.5;
  EXPECT_NE(pictures.compare(brighter).verdict, Likeness::different);
  pictures.options.scale = 1;
  pictures.options.fit_scale = true;
  const Comparison fitted = pictures.compare(brighter);
  EXPECT_LT(std::abs(fitted.scale - 2.5), 10 * fitted.scale_error);
  EXPECT_NE(pictures.compare([](int x, int) { return x < 6 ? 2 : 2.5; }).verdict, Likeness::same);
}

// Two sides without noise, whose whole differs by `part`.
Likeness of_constants(double part, bool half) {
  const NoisyPictures noisy;
  const PictureCells cells(noisy.region(), 6);
  const auto side = [&](double value) {
    PixelBlock block;
    for (auto& plane : block.colour) plane.assign(24 * 24, static_cast<float>(value));
    SideSums sums(cells, 2, {.half = half});
    sums.add(noisy.region(), {block, block});
    return std::move(sums).finish();
  };
  return compare_cells(cells, side(1 + part), side(1), {.margin = 0.01}).verdict;
}

TEST(CompareCells, AllowsForTheRoundingOfFilesWhereNothingVaries) {
  EXPECT_EQ(of_constants(0, false), Likeness::same);
  EXPECT_EQ(of_constants(1e-6, false), Likeness::same);
  EXPECT_EQ(of_constants(1e-4, false), Likeness::different);
  EXPECT_EQ(of_constants(5e-4, true), Likeness::same);
  EXPECT_EQ(of_constants(5e-3, true), Likeness::different);
  EXPECT_EQ(of_constants(-1, false), Likeness::different) << "black against white";
}

TEST(CompareCells, SaysHowManyRendersTheMarginTakes) {
  Pictures pictures;
  pictures.options.margin = 0.1;
  pictures.options.tile_margin = 0.45;
  pictures.samples_a = pictures.samples_b = std::vector<int>(6, 16);
  const Comparison few = pictures.compare(unchanged);
  EXPECT_EQ(few.verdict, Likeness::undecided);
  EXPECT_GT(few.shown_margin, 0.1);
  const double renders = 6 * few.renders_for_margin;
  ASSERT_LT(renders, 1e4);
  pictures.samples_a = pictures.samples_b = std::vector<int>(static_cast<std::size_t>(2 * renders) + 2, 16);
  EXPECT_EQ(pictures.compare(unchanged).verdict, Likeness::same);
}

TEST(CompareCells, RefusesWhatCannotBeTested) {
  Pictures pictures;
  pictures.options.margin = 0;
  EXPECT_THROW(pictures.compare(unchanged), std::invalid_argument);
  pictures.options.margin = 0.01;
  pictures.options.scale = -1;
  EXPECT_THROW(pictures.compare(unchanged), std::invalid_argument);
  pictures.options.scale = 1;
  pictures.options.fit_scale = true;
  pictures.layer = ErrorLayer::standard_error;
  EXPECT_THROW(pictures.compare(unchanged), std::invalid_argument);
}

}  // namespace
}  // namespace fairlight
