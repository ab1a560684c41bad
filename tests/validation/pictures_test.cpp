#include <cmath>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include <fairlight/stats/quadrature.h>
#include <fairlight/validation/claims/edge_pictures.h>
#include <fairlight/validation/claims/filters.h>
#include <fairlight/validation/claims/floor_pictures.h>
#include <fairlight/validation/claims/picture_covariances.h>

namespace fairlight {
namespace {

double mean_of_powers(const FilterRule& rule, int along_x, int along_y) {
  return rule.mean(0, 0, [&](double x, double y) {
    return Rgb<double>(Rgb<double>::Constant(std::pow(x, along_x) * std::pow(y, along_y)));
  })[0];
}

TEST(FilterRule, HasTheMomentsOfItsFilter) {
  const FilterRule box(PixelFilter::box), tent(PixelFilter::tent);
  EXPECT_NEAR(mean_of_powers(box, 0, 0), 1, 1e-14);
  EXPECT_NEAR(mean_of_powers(box, 2, 0), 1.0 / 12, 1e-14);
  EXPECT_NEAR(mean_of_powers(box, 0, 4), 1.0 / 80, 1e-14);
  EXPECT_NEAR(mean_of_powers(box, 2, 2), 1.0 / 144, 1e-14);
  EXPECT_NEAR(mean_of_powers(tent, 2, 0), 1.0 / 6, 1e-14);
  EXPECT_NEAR(mean_of_powers(tent, 0, 4), 1.0 / 15, 1e-14);
  EXPECT_NEAR(mean_of_powers(FilterRule(PixelFilter::gaussian), 2, 0), cut_gaussian_moment(0.5, 1.5), 1e-12);
  EXPECT_NEAR(mean_of_powers(FilterRule(PixelFilter::blackman_harris), 2, 0), blackman_harris_moment(2), 1e-12);
}

TEST(FilterRule, HasSharesAndMeansAlongAnAxis) {
  const FilterRule box(PixelFilter::box), tent(PixelFilter::tent), gaussian(PixelFilter::gaussian);
  EXPECT_NEAR(box.share_below(0.25), 0.75, 1e-14);
  EXPECT_NEAR(tent.share_below(0.5), 0.875, 1e-14);
  EXPECT_NEAR(tent.share_below(-0.5), 0.125, 1e-14);
  EXPECT_EQ(tent.share_below(-1), 0);
  EXPECT_EQ(tent.share_below(3), 1);
  // Of a Gaussian cut off at three deviations: 0.6826895 / 0.9973002 within one.
  EXPECT_NEAR(gaussian.share_below(0.5) - gaussian.share_below(-0.5), 0.6826895 / 0.9973002, 1e-7);
  EXPECT_NEAR(tent.mean_along([](double x) { return std::abs(x); }), 1.0 / 3, 1e-14);
}

TEST(LitFloor, ShowsTheSphereAboveAPoint) {
  const LitFloor floor{true, false};
  const Rgb<double> below = floor.radiance({-1.1, -0.5, 0});
  EXPECT_NEAR(below[1], 0.5 * 1 * (0.3 * 0.3) / (1.9 * 1.9), 1e-15);
  EXPECT_NEAR(below[2] / below[0] / (0.25 * 2e6 / (0.8 * 0.1)), 1, 1e-12);
}

// The form factor of a parallel rectangle is the integral of h^2 / (pi d^4).
TEST(LitFloor, ShowsTheRectangleByQuadrature) {
  const LitFloor floor{false, true};
  const auto form_factor = [](double x, double y) {
    const double h = 1.7, squared = (x - 0.2) * (x - 0.2) + (y + 0.6) * (y + 0.6) + h * h;
    return h * h / (std::numbers::pi * squared * squared);
  };
  const double integral = integrate_rectangle(form_factor, 0.6, 1.35, 0.4, 0.9).value;
  EXPECT_NEAR(floor.radiance({0.2, -0.6, 0})[1] / (0.5 * 2 * integral), 1, 1e-9);
}

TEST(LitFloor, AveragesAPixelOverItsFilter) {
  const LitFloor floor{true, true};
  const double mean =
      integrate_rectangle([&](double x, double y) { return floor.radiance(floor.point(x, y, 37, 22))[1]; }, 3, 4,
                          20, 21)
          .value;
  EXPECT_NEAR(floor.pixel(3, 20, 37, 22, FilterRule(PixelFilter::box))[1] / mean, 1, 1e-8);
  // The widest filter, by the middles of 200 x 200 squares.
  constexpr int n = 200;
  double sum = 0, weights = 0;
  const auto shape = [](double x) {
    const double turn = std::numbers::pi * x / 2;
    return 0.35875 + 0.48829 * std::cos(turn) + 0.14128 * std::cos(2 * turn) + 0.01168 * std::cos(3 * turn);
  };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const double x = 4 * (i + 0.5) / n - 2, y = 4 * (j + 0.5) / n - 2, weight = shape(x) * shape(y);
      weights += weight;
      sum += weight * floor.radiance(floor.point(30.5 + x, 2.5 + y, 35, 18))[2];
    }
  }
  EXPECT_NEAR(floor.pixel(30, 2, 35, 18, FilterRule(PixelFilter::blackman_harris))[2] / (sum / weights), 1, 1e-6);
}

// The corners of the landscape and of the portrait are the darkest places, those below lamps the brightest.
TEST(LitFloor, ShowsNineDecadesOfRadiance) {
  const LitFloor by_sphere{true, false}, by_rectangle{false, true};
  const FilterRule box(PixelFilter::box);
  double least = 1, most = 1;
  for (const auto& [x, y] : {std::pair{0, 0}, {0, 21}, {36, 0}, {36, 21}, {27, 0}}) {
    for (const LitFloor& floor : {by_sphere, by_rectangle}) {
      least = std::min(least, floor.pixel(x, y, 37, 22, box).minCoeff());
      most = std::max(most, floor.pixel(x, y, 37, 22, box).maxCoeff());
    }
  }
  EXPECT_LT(least, 1.3e-4);
  EXPECT_GT(most, 0.9e5);
}

TEST(LitFloor, IsSeenUprightAndInTheMirrorExchanged) {
  const LitFloor floor{true, true}, mirrored{true, true, true};
  EXPECT_TRUE(floor.point(18.5, 11, 37, 22).isApprox(Vec3<double>(0.25, -0.125, 0), 1e-12));
  EXPECT_GT(floor.point(37, 11, 37, 22).x(), 0.25);
  EXPECT_GT(floor.point(18.5, 0, 37, 22).y(), -0.125);
  EXPECT_LT(mirrored.point(37, 11, 37, 22).x(), 0.25);
  EXPECT_GT(mirrored.point(18.5, 0, 37, 22).y(), -0.125);
  EXPECT_NEAR(mirrored.pixel_size(18), 1.75 * 1.1 / 18, 1e-15);
}

// A sample by cone at the nearest point of the floor, straight below the lamp, and one by area.
TEST(LitFloor, BoundsItsSamples) {
  const double alpha = std::asin(0.3 / 1.9);
  const Vec3<double> below(-1.1, -0.5, 0);
  const LitFloor floor{true, false};
  EXPECT_NEAR(floor.largest_terms(below, 0.1, true)[1], 0.5 * 2 * (1 - std::cos(alpha)), 1e-14);
  EXPECT_NEAR(floor.largest_terms(below, 0.1, false)[1], 0.5 * 4 * 0.09 / (1.6 * 1.6), 1e-14);
  EXPECT_GE(floor.largest_terms(below + Vec3<double>(0.1, 0, 0), 0.1, true)[1],
            floor.largest_terms(below, 0, true)[1]);
  EXPECT_LT(floor.largest_terms(below + Vec3<double>(2, 0, 0), 0.1, true)[1],
            floor.largest_terms(below, 0, true)[1]);
}

TEST(BlurredEdges, HaveTheSharesOfTheirAperture) {
  const BlurredEdges triangle{1.5, 2, 3, 0}, square{1.5, 2, 4, std::numbers::pi / 4}, circle{1.5, 2, 0, 0};
  // Corners (2, 0) and (-1, +-sqrt 3). To the right of 0 is a triangle of 2/3 the size.
  EXPECT_NEAR(triangle.share_below(0, 0), 5.0 / 9, 1e-14);
  EXPECT_NEAR(triangle.share_below(-1, 0), 0, 1e-14);
  EXPECT_NEAR(triangle.share_below(2, 0), 1, 1e-14);
  EXPECT_NEAR(triangle.share_below(0, 1), 0.5, 1e-14);
  // The half with y < 0 is a triangle, of which the half further from 0 has a quarter.
  EXPECT_NEAR(triangle.share_below(-std::numbers::sqrt3 / 2, 1), 1.0 / 8, 1e-14);
  EXPECT_NEAR(square.share_below(std::numbers::sqrt2 / 2, 0), 0.75, 1e-14);
  EXPECT_NEAR(circle.share_below(1, 1), 0.5 + (std::sqrt(0.75) / 2 + std::numbers::pi / 6) / std::numbers::pi,
              1e-14);
}

// Pixels of 0.2 m: the edge is 0.3125 pixels to the right of the middle of the picture.
TEST(BlurredEdges, AreSharpThroughAPinhole) {
  const BlurredEdges edges{1, 0, 0, 0};
  const FilterRule box(PixelFilter::box);
  EXPECT_NEAR(edges.left_share(1, 5, 3, box), 1, 1e-14);
  EXPECT_NEAR(edges.left_share(2, 5, 3, box), 0.8125, 1e-14);
  EXPECT_NEAR(edges.left_share(3, 5, 3, box), 0, 1e-14);
  EXPECT_NEAR(edges.upper_share(1, 3, box), 0.1875, 1e-14);
}

// In the middle of a fine picture the filter does not matter. With 1 - D/f = -2 the lens is seen
// upside down, and half as large; with 1 - D/f = 1/2 upright, and twice as large.
TEST(BlurredEdges, AreBlurredByTheApertureBeforeAndBehindTheFocus) {
  const FilterRule tent(PixelFilter::tent);
  const BlurredEdges before{1, 0.25, 3, 0}, behind{6, 0.25, 3, 0};
  EXPECT_NEAR(before.left_share(5000, 10001, 10001, tent), 1 - before.share_below(-0.0625 / 2, 0), 1e-7);
  EXPECT_NEAR(behind.left_share(5000, 10001, 10001, tent), behind.share_below(0.0625 * 2, 0), 1e-7);
  EXPECT_NEAR(behind.upper_share(5000, 10001, tent), behind.share_below(-0.0625 * 2, 1), 1e-7);
}

// E[(X - 36)+] for a mean of 64 tosses, term by term.
TEST(SquaredDeviation, HasItsTail) {
  double tail = 0, mean = 0;
  for (int ones = 0; ones <= 64; ++ones) {
    const double p = std::exp(std::lgamma(65) - std::lgamma(ones + 1) - std::lgamma(65 - ones) - 64 * std::log(2));
    const double x = in_variances(ones / 64.0, 64);
    mean += p * x;
    tail += p * std::max(x - 36, 0.0);
  }
  EXPECT_NEAR(mean, 1, 1e-12);
  EXPECT_GT(tail, 0);
  EXPECT_LE(tail, squared_deviation(64).tail_slack);
  EXPECT_EQ(squared_deviation(16).tail_slack, 0);
  EXPECT_LE(in_variances(1, 16), squared_deviation(16).upper);
}

TEST(Quarter, HoldsEveryPixelOnce) {
  const PicturePlan plan{5, 4};
  std::set<std::pair<int, int>> seen;
  for (std::size_t q = 0; q < 4; ++q) {
    const Quarter quarter = Quarter::of(plan, q);
    EXPECT_EQ(quarter.pixels(), 6u);
    std::set<std::pair<int, int>> of_quarter;
    for (std::uint64_t draw = 0; draw < 6; ++draw) of_quarter.insert({quarter.x(draw), quarter.y(draw)});
    EXPECT_EQ(of_quarter.size(), 6u);
    EXPECT_EQ(quarter.x(6), quarter.x(0));
    seen.insert(of_quarter.begin(), of_quarter.end());
  }
  EXPECT_EQ(seen.size(), 20u);
}

Film picture_of(Rendering rendering, std::uint64_t r) {
  const StreamKey key(1, "a picture");
  ReplicatePictures<> pictures(grey_ball().view, grey_ball_settings(Arithmetic::packets), {9, 5, 12, rendering},
                               key);
  return pictures.at(r);
}

TEST(ReplicatePictures, AreTheSameInPartsOfOneSeedAndElseDiffer) {
  const Film whole = picture_of(Rendering::at_once, 3);
  EXPECT_EQ(whole.at(8, 4)[0].count(), 12u);
  EXPECT_EQ(picture_of(Rendering::resumed, 3), whole);
  EXPECT_EQ(picture_of(Rendering::ranges, 3), whole);
  EXPECT_EQ(picture_of(Rendering::seeds, 3).at(8, 4)[0].count(), 12u);
  EXPECT_NE(picture_of(Rendering::seeds, 3), whole);
  EXPECT_NE(picture_of(Rendering::at_once, 4), whole);
}

}  // namespace
}  // namespace fairlight
