#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

#include <fairlight/validation/studies/closed_forms.h>

namespace fairlight::closed_forms {
namespace {

// The mean of f over [0,1], by the midpoint rule.
double mean_over_unit(const std::function<double(double)>& f) {
  constexpr int n = 200000;
  double sum = 0;
  for (int i = 0; i < n; ++i) sum += f((i + 0.5) / n);
  return sum / n;
}

// The variance of a draw that is `value` in half of the draws and else 0, and `value` that of a
// number uniform in [0,1].
double halved_variance(const std::function<double(double)>& value) {
  const double mean = mean_over_unit(value) / 2;
  return mean_over_unit([&](double u) { return value(u) * value(u); }) / 2 - mean * mean;
}

TEST(ClosedForms, OfADiffuseSurfaceUnderHalfASky) {
  EXPECT_NEAR(diffuse_uniform_variance(), halved_variance([](double z) { return 2 * z; }), 1e-9);
  EXPECT_NEAR(diffuse_cosine_variance(), halved_variance([](double) { return 1.0; }), 1e-9);
  EXPECT_NEAR(diffuse_uniform_variance() / diffuse_cosine_variance(), 5.0 / 3, 1e-12);
}

TEST(ClosedForms, OfAGlossySurfaceUnderHalfASky) {
  for (const double n : {1.0, 5.0, 50.0}) {
    const auto uniform = [=](double z) { return (n + 2) * std::pow(z, n + 1); };
    const auto lobe = [=](double u) { return (n + 2) / (n + 1) * std::pow(u, 1 / (n + 1)); };
    EXPECT_NEAR(glossy_uniform_variance(n), halved_variance(uniform), 1e-6 * n);
    EXPECT_NEAR(glossy_lobe_variance(n), halved_variance(lobe), 1e-6);
  }
}

// Two coins that show 1 or 6: every outcome is written out.
TEST(ClosedForms, OfTwoDice) {
  const Die fair = die_of({0.5, 0, 0, 0, 0, 0.5}), six = die_of({0, 0, 0, 0, 0, 1});
  EXPECT_EQ(fair.mean, 3.5);
  EXPECT_EQ(fair.mean_square, 18.5);
  EXPECT_EQ(two_dice_variance(fair, six), 6.25);
  // Twice the one: 2 with probability 1/4, and 12 else; the mean is 9.5.
  EXPECT_EQ(one_die_variance(fair, six), 0.25 * 7.5 * 7.5 + 0.75 * 2.5 * 2.5);
}

// Within a closed sphere T multiplies by rho, so L = Le / (1 - rho), and counted twice
// L' = Le (1 + rho) / (1 - rho).
TEST(ClosedForms, OfADoubleCountInTheFurnace) {
  constexpr double emitted = 3, rho = 0.25;
  EXPECT_EQ(double_counted(emitted / (1 - rho), emitted), emitted * (1 + rho) / (1 - rho));
}

// On the axis a circle of radius tan a. Off the axis, a point in direction (x, y, 1) is in the cone
// about (tan b, 0, 1) where its cosine with that is at least cos a: counted on a fine grid.
TEST(ClosedForms, OfThePictureOfASphere) {
  EXPECT_NEAR(sphere_picture_area(0.3, 0), std::numbers::pi * std::pow(std::tan(0.3), 2), 1e-12);
  const double a = 0.25, b = 0.5;
  constexpr double step = 1e-3;
  double area = 0;
  for (double x = -0.5; x < 2; x += step) {
    for (double y = -1; y < 1; y += step) {
      const double cosine = (x * std::sin(b) + std::cos(b)) / std::sqrt(x * x + y * y + 1);
      if (cosine >= std::cos(a)) area += step * step;
    }
  }
  EXPECT_NEAR(sphere_picture_area(a, b), area, 1e-3 * area);
}

}  // namespace
}  // namespace fairlight::closed_forms
