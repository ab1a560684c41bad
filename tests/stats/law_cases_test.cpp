#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include <fairlight/stats/googletest.h>

// Laws that are hard to see: narrow ones, with steps and poles, with rare outcomes, as tables, on unbounded domains and
// with lost draws.
namespace fairlight {
namespace {

using V = Eigen::Vector3d;
constexpr double pi = 3.14159265358979323846;

double u(Generator& g) { return static_cast<double>(g() >> 11) * 0x1p-53; }

auto phong(double exponent) {
  return [exponent](Generator& g) {
    const double c = std::pow(1 - u(g), 1 / (exponent + 1)), s = std::sqrt(1 - c * c), p = 2 * pi * u(g);
    return V(s * std::cos(p), s * std::sin(p), c);
  };
}
auto phong_density(double exponent) {
  return [exponent](const V& w) { return (exponent + 1) / (2 * pi) * std::pow(std::max(0.0, w.z()), exponent); };
}
auto normal(double deviation) {
  return [deviation](Generator& g) { return deviation * std::normal_distribution<>()(g); };
}
auto normal_density(double deviation) {
  return [deviation](double x) {
    return std::exp(-x * x / (2 * deviation * deviation)) / (deviation * std::sqrt(2 * pi));
  };
}

// The message of an expectation that must not be met.
template <class Sampler, class Law, class Domain>
std::string refused(const Sampler& sampler, const Law& law, const Domain& domain) {
  const Expectation found = expect_follows(googletest_site(), sampler, law, domain);
  EXPECT_FALSE(found.met);
  return found.message;
}
#define EXPECT_BIASED(...) EXPECT_EQ(refused(__VA_ARGS__).substr(0, 6), "biased")

TEST(NarrowLaw, OfTheWrongWidthIsFound) {
  EXPECT_FOLLOWS(phong(1000), phong_density(1000), HemisphereDomain{});
  EXPECT_BIASED(phong(300), phong_density(1000), HemisphereDomain{});
  EXPECT_BIASED(phong(950), phong_density(1000), HemisphereDomain{});
  EXPECT_FOLLOWS(normal(1e-3), normal_density(1e-3), (IntervalDomain{-6, 6}));
  EXPECT_BIASED(normal(5e-3), normal_density(1e-3), (IntervalDomain{-6, 6}));
  EXPECT_FOLLOWS(normal(1e-7), normal_density(1e-7), (IntervalDomain{-6, 5.1}));
}

// A lobe about an axis at 45 degrees, narrow in both coordinates.
TEST(NarrowLaw, OfAnyAxisIsFound) {
  const auto tilted = [](double exponent) {
    return [exponent](Generator& g) {
      const V w = phong(exponent)(g);
      return V((w.x() + w.z()) / std::sqrt(2), w.y(), (w.z() - w.x()) / std::sqrt(2));
    };
  };
  const auto density = [](const V& w) { return phong_density(5000)(V(0, 0, (w.x() + w.z()) / std::sqrt(2))); };
  EXPECT_FOLLOWS(tilted(5000), density, SphereDomain{1});
  EXPECT_BIASED(tilted(2500), density, SphereDomain{1});
}

const std::vector<double> texels{1, 3, 0, 2, 4, 1.5, 2};  // of a row of an environment map; sum 13.5

double row_of_texels(double x) { return texels[static_cast<std::size_t>(std::min(6.0, x * 7))] * 7 / 13.5; }
double texel_place(Generator& g) {
  std::discrete_distribution<int> texel(texels.begin(), texels.end());
  return (texel(g) + u(g)) / 7;
}

TEST(Steps, AreIntegratedWithAndWithoutCuts) {
  EXPECT_FOLLOWS(texel_place, row_of_texels, (IntervalDomain{0, 1}));
  EXPECT_FOLLOWS(texel_place, row_of_texels,
                 (IntervalDomain{0, 1}.cut_at({1 / 7., 2 / 7., 3 / 7., 4 / 7., 5 / 7., 6 / 7.})));
  EXPECT_BIASED([](Generator& g) { return std::pow(texel_place(g), 1.01); }, row_of_texels, (IntervalDomain{0, 1}));
}

TEST(Steps, InTwoDimensionsAreIntegrated) {
  const auto map = [](const Eigen::Vector2d& x) { return row_of_texels(x.x()) * row_of_texels(x.y()); };
  const std::vector<double> sevenths{1 / 7., 2 / 7., 3 / 7., 4 / 7., 5 / 7., 6 / 7.};
  EXPECT_FOLLOWS([](Generator& g) { return Eigen::Vector2d(texel_place(g), texel_place(g)); }, map,
                 (SquareDomain{0, 1}.cut_at(sevenths, sevenths)));
}

TEST(Poles, AreIntegrated) {
  const auto square = [](Generator& g) { return std::pow(u(g), 2); };
  EXPECT_FOLLOWS(
      square, [](double x) { return 0.5 / std::sqrt(x); }, (IntervalDomain{0, 1}));
  const auto arcsine = [](Generator& g) { return 2 * std::pow(std::sin(pi / 2 * u(g)), 2); };
  EXPECT_FOLLOWS(
      arcsine, [](double x) { return 1 / (pi * std::sqrt(x * (2 - x))); }, (IntervalDomain{0, 2}));
  EXPECT_BIASED([&](Generator& g) { return std::pow(u(g), 2.05); }, [](double x) { return 0.5 / std::sqrt(x); },
                (IntervalDomain{0, 1}));
}

TEST(Density, IsAskedInItsDomainOnly) {
  const std::vector<double> table(8, 0.125);
  const auto strays = [](Generator& g) {
    const double x = u(g);
    return x < 1e-3 ? std::int64_t{1} << 40 : static_cast<std::int64_t>(8 * x);
  };
  const auto density = [&](std::int64_t i) { return table.at(static_cast<std::size_t>(i)); };
  EXPECT_NE(refused(strays, density, DiscreteDomain{8}).find("outside the domain"), std::string::npos);
  const auto on_line = [&](double x) { return table.at(static_cast<std::size_t>(8 * x)) * 8; };
  const auto beyond = [](Generator& g) { return 1.001 * u(g); };
  EXPECT_NE(refused(beyond, on_line, IntervalDomain{0, 1}).find("outside the domain"), std::string::npos);
}

auto outcome(double p) {
  return [p](Generator& g) { return std::int64_t{u(g) < p}; };
}
auto chance(double p) {
  return [p](std::int64_t i) { return i == 1 ? p : 1 - p; };
}

TEST(RareOutcomes, HaveBinomialLaws) {
  EXPECT_FOLLOWS(outcome(1e-6), chance(1e-6), DiscreteDomain{2});
  EXPECT_FOLLOWS(outcome(1), chance(1), DiscreteDomain{2});
  EXPECT_BIASED(outcome(1e-5), chance(1e-6), DiscreteDomain{2});
  EXPECT_BIASED(outcome(1e-6), chance(0), DiscreteDomain{2});
  const std::vector<double> dice{0.3, 0.3, 0.4 - 1e-6, 1e-6, 0};
  const auto thrown = [&](Generator& g) {
    const double x = u(g);
    return std::int64_t{(x > 0.3) + (x > 0.6) + (x > 1 - 1e-6)};
  };
  EXPECT_FOLLOWS(thrown, dice, DiscreteDomain{5});
}

TEST(Tables, AreLaws) {
  const std::vector<double> quarters{0.1, 0.2, 0.3, 0.4};
  const auto ramp = [&](Generator& g) {
    std::discrete_distribution<int> quarter(quarters.begin(), quarters.end());
    return (quarter(g) + std::pow(u(g), 3)) / 4;  // a table says nothing of the law in a cell
  };
  EXPECT_FOLLOWS(ramp, quarters, (IntervalDomain{0, 1}));
  EXPECT_BIASED(u, quarters, (IntervalDomain{0, 1}));
  const auto half = [&](Generator& g) { return Eigen::Vector2d(ramp(g), u(g)); };
  EXPECT_FOLLOWS(half, (LawTable{4, 2, {.05, .05, .1, .1, .15, .15, .2, .2}}), (SquareDomain{0, 1}));
}

TEST(UnboundedDomains, HoldTheirLaws) {
  EXPECT_FOLLOWS(normal(2), normal_density(2), LineDomain{});
  EXPECT_BIASED(normal(2.02), normal_density(2), LineDomain{});
  EXPECT_FOLLOWS([](Generator& g) { return std::cauchy_distribution<>()(g); },
                 [](double x) { return 1 / (pi * (1 + x * x)); }, LineDomain{});
  const auto exponential = [](double x) { return 3 * std::exp(-3 * x); };
  EXPECT_FOLLOWS([](Generator& g) { return std::exponential_distribution<>(3)(g); }, exponential, HalfLineDomain{});
  EXPECT_BIASED([](Generator& g) { return std::exponential_distribution<>(3.06)(g); }, exponential,
                HalfLineDomain{});
  EXPECT_NE(refused([](Generator&) { return HUGE_VAL; }, exponential, HalfLineDomain{}).find("draw 0"),
            std::string::npos);
}

// Of a lobe about the horizon, half of the draws lie below it.
TEST(LostDraws, AreAStatedShare) {
  const auto about_x = [](Generator& g) {
    const V w = phong(20)(g);
    return V(w.z(), w.x(), w.y());
  };
  const auto density = [](const V& w) { return phong_density(20)(V(0, 0, w.x())); };
  EXPECT_FOLLOWS(about_x, density, losing(0.5, HemisphereDomain{}));
  const auto without = [&](Generator& g) {
    const V w = about_x(g);
    return w.z() > 0 ? std::optional(w) : std::nullopt;
  };
  EXPECT_FOLLOWS(without, density, losing(0.5, HemisphereDomain{}));
  EXPECT_NE(refused(about_x, density, losing(0.4, HemisphereDomain{})).find("not to 0.6"), std::string::npos);
  EXPECT_BIASED([&](Generator& g) { return u(g) < 0.02 ? V(V(0, 0, -1)) : about_x(g); }, density,
                losing(0.5, HemisphereDomain{}));
}

TEST(BadInput, IsAFindingInOneSentence) {
  const auto flat = [](double) { return 1.0; };
  EXPECT_NE(refused(u, flat, IntervalDomain{1, 1}).find("size 0"), std::string::npos);
  EXPECT_NE(refused(u, flat, IntervalDomain{0, HUGE_VAL}).find("size inf"), std::string::npos);
  EXPECT_NE(refused(
                u, [](double) { return std::nan(""); }, IntervalDomain{0, 1})
                .find("the density"),
            std::string::npos);
  EXPECT_NE(refused([](Generator&) { return std::nan(""); }, flat, IntervalDomain{0, 1}).find("draw 0"),
            std::string::npos);
  EXPECT_BIASED([](Generator&) { return 0.5; }, flat, (IntervalDomain{0, 1}));
  EXPECT_BIASED([](Generator& g) { return 5 + u(g); }, flat, (IntervalDomain{0, 1}));
}

}  // namespace
}  // namespace fairlight
