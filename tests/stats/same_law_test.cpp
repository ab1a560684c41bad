#include <cmath>
#include <optional>
#include <random>

#include <gtest/gtest.h>

#include <fairlight/stats/googletest.h>

namespace fairlight {
namespace {

constexpr double pi = 3.14159265358979323846;

double u(Generator& g) { return static_cast<double>(g() >> 11) * 0x1p-53; }

double box_muller(Generator& g) { return std::sqrt(-2 * std::log(1 - u(g))) * std::cos(2 * pi * u(g)); }

// The message of an expectation that must not be met.
template <class A, class B, class Domain>
std::string refused(const A& a, const B& b, const Domain& domain) {
  const Expectation found = expect_same_law(googletest_site(), a, b, domain, 0.1);
  EXPECT_FALSE(found.met);
  return found.message;
}
#define EXPECT_BIASED(...) EXPECT_EQ(refused(__VA_ARGS__).substr(0, 6), "biased")

TEST(SameLaw, OfTwoRecipesForTheNormalLaw) {
  const auto library = [](Generator& g) { return std::normal_distribution<>()(g); };
  EXPECT_SAME_LAW(box_muller, library, LineDomain{}, 0.1);
  EXPECT_BIASED(
      box_muller, [&](Generator& g) { return 1.1 * library(g); }, LineDomain{});
  EXPECT_BIASED(
      box_muller, [&](Generator& g) { return 0.1 + library(g); }, LineDomain{});
}

// A uniform number with the mean and the variance of the normal law.
TEST(SameLaw, SeesMoreThanTwoMoments) {
  const auto flat = [](Generator& g) { return std::sqrt(3) * (2 * u(g) - 1); };
  EXPECT_BIASED(box_muller, flat, LineDomain{});
}

// Two samplers of a disk, and one that crowds the centre.
TEST(SameLaw, OfPointsInTwoDimensions) {
  const auto at = [](double r, double turn) {
    return Eigen::Vector2d(r * std::cos(2 * pi * turn), r * std::sin(2 * pi * turn));
  };
  const auto polar = [&](Generator& g) {
    const double r = std::sqrt(u(g));
    return at(r, u(g));
  };
  const auto rejection = [](Generator& g) {
    for (;;) {
      const double x = 2 * u(g) - 1, y = 2 * u(g) - 1;
      if (x * x + y * y < 1) return Eigen::Vector2d(x, y);
    }
  };
  const auto crowded = [&](Generator& g) {
    const double r = u(g);
    return at(r, u(g));
  };
  EXPECT_SAME_LAW(polar, rejection, DiskDomain{1}, 0.1);
  EXPECT_BIASED(polar, crowded, DiskDomain{1});
}

// Each coordinate alone is uniform.
TEST(SameLaw, SeesADependenceBetweenCoordinates) {
  const auto apart = [](Generator& g) {
    const double x = u(g);
    return Eigen::Vector2d(x, u(g));
  };
  const auto together = [](Generator& g) {
    const double x = u(g), y = u(g);
    return Eigen::Vector2d(x, u(g) < 0.3 ? x : y);
  };
  EXPECT_BIASED(apart, together, (SquareDomain{0, 1}));
}

TEST(SameLaw, OfOutcomesAndOfConstants) {
  const auto die = [](Generator& g) { return static_cast<std::int64_t>(6 * u(g)); };
  const auto sum = [&](Generator& g) { return (die(g) + die(g)) % 6; };
  const auto loaded = [&](Generator& g) { return u(g) < 0.1 ? std::int64_t{5} : die(g); };
  EXPECT_SAME_LAW(die, sum, DiscreteDomain{6}, 0.1);
  EXPECT_BIASED(die, loaded, DiscreteDomain{6});
  const auto half = [](Generator&) { return 0.5; };
  EXPECT_SAME_LAW(half, half, (IntervalDomain{0, 1}), 0.1);
  EXPECT_BIASED(
      half, [](Generator&) { return 0.5000001; }, (IntervalDomain{0, 1}));
}

// Of a parameter among draws of its posterior law, all ranks are equally likely. The posterior of a
// coin's bias after one throw, from a uniform prior, is that of the larger or smaller of two numbers.
TEST(SameLaw, OfTheRanksOfSimulationBasedCalibration) {
  const auto rank = [](auto posterior) {
    return [posterior](Generator& g) {
      const double bias = u(g);
      const bool heads = u(g) < bias;
      std::int64_t below = 0;
      for (int i = 0; i < 7; ++i) below += posterior(g, heads) < bias;
      return below;
    };
  };
  const auto right = rank([](Generator& g, bool heads) {
    const double a = u(g), b = u(g);
    return heads ? std::max(a, b) : std::min(a, b);
  });
  const auto prior = rank([](Generator& g, bool) { return u(g); });
  const auto narrow = rank([](Generator& g, bool heads) {
    const double a = u(g), b = u(g), c = u(g);
    return heads ? std::max({a, b, c}) : std::min({a, b, c});
  });
  const auto any = [](Generator& g) { return static_cast<std::int64_t>(8 * u(g)); };
  EXPECT_SAME_LAW(right, any, DiscreteDomain{8}, 0.1);
  EXPECT_SAME_LAW(prior, any, DiscreteDomain{8}, 0.1);  // ranks alone do not show that data are ignored
  EXPECT_BIASED(narrow, any, DiscreteDomain{8});
}

TEST(SameLaw, CountsWhatIsLost) {
  const auto keeps = [](double share) {
    return [share](Generator& g) { return u(g) < share ? std::optional(u(g)) : std::nullopt; };
  };
  EXPECT_SAME_LAW(keeps(0.7), keeps(0.7), losing(0.3, IntervalDomain{0, 1}), 0.1);
  EXPECT_BIASED(keeps(0.7), keeps(0.8), losing(0.3, IntervalDomain{0, 1}));
}

TEST(SameLaw, RefusesWhatIsNotInTheDomain) {
  EXPECT_NE(refused(
                u, [](Generator& g) { return 2 * u(g); }, IntervalDomain{0, 1})
                .find("outside the domain"),
            std::string::npos);
  EXPECT_NE(refused([](Generator&) { return std::nan(""); }, u, IntervalDomain{0, 1}).find("draw 0"),
            std::string::npos);
}

}  // namespace
}  // namespace fairlight
