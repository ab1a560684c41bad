#include <bit>
#include <cstdint>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include <fairlight/stats/exact_moments.h>
#include <fairlight/stats/googletest.h>
#include <fairlight/stats/rosenblatt.h>

#if !defined(__FAST_MATH__)
#error "this file must be compiled with -ffast-math, as the code of many users is"
#endif

// What a user compiles with -ffast-math: a wrong draw is a finding with a message there too, and never a crash.

namespace fairlight {
namespace {

// Numbers that the compiler does not know: it takes for granted that there are none like them.
double from_bits(std::uint64_t bits) {
  volatile std::uint64_t hidden = bits;
  return std::bit_cast<double>(std::uint64_t{hidden});
}
double nan() { return from_bits(0x7FF8000000000000u); }
double inf() { return from_bits(0x7FF0000000000000u); }
std::vector<double> wrong_numbers() { return {nan(), inf(), -inf(), 1e308, -1e308, 1e19, -1e19, -0.001, 1.001}; }

double uniform(Generator& generator) { return std::uniform_real_distribution<>()(generator); }

void expect_found(const Expectation& found, const std::string& part) {
  EXPECT_FALSE(found.met);
  EXPECT_NE(found.message.find(part), std::string::npos) << part << " is not in\n" << found.message;
}

// A hundred points of the domain, and then the wrong one.
template <class Domain, class Point>
void expect_outside(const Domain& domain, const Point& wrong) {
  int drawn = 0;
  const auto sampler = [&](Generator& generator) {
    return ++drawn > 100 ? wrong : Point(domain.at(uniform(generator), uniform(generator)));
  };
  const auto flat = [&](const Point&) { return 1 / domain.size(); };
  expect_found(expect_follows(googletest_site(), sampler, flat, domain, 0.1), "draw 100 is ");
}

TEST(FollowsWithFastMath, FindsPointsOutsideOfEveryDomain) {
  for (const double x : wrong_numbers()) {
    SCOPED_TRACE(x);
    expect_outside(IntervalDomain{0, 1}, x);
    expect_outside(SquareDomain{0, 1}, Eigen::Vector2d(0.5, x));
    expect_outside(SquareDomain{0, 1}, Eigen::Vector2d(x, 0.5));
    expect_outside(DiskDomain{1}, Eigen::Vector2d(x, 1));
    expect_outside(PolygonDomain{1, 6, 0.3}, Eigen::Vector2d(1, x));
    if (x != 1e308 && x != -1e308) {
      expect_outside(HemisphereDomain(), Eigen::Vector3d(0, 0, x));
      expect_outside(SphereDomain{2}, Eigen::Vector3d(0, 0, 2 * x - 1));
    }
  }
}

TEST(FollowsWithFastMath, FindsNaNInAnyCoordinate) {
  for (int i = 0; i < 3; ++i) {
    SCOPED_TRACE(i);
    Eigen::Vector3d w(0, 0, 1);
    w[i] = nan();
    expect_outside(HemisphereDomain(), w);
    expect_outside(CapDomain(0.5), w);
    expect_outside(LuneDomain({0, 0, 1}, {1, 0, 0}), w);
    expect_outside(SphereDomain{1}, w);
    if (i < 2) expect_outside(DiskDomain{1}, Eigen::Vector2d(w.head<2>()));
  }
}

TEST(FollowsWithFastMath, FindsOutcomesThatDoNotExist) {
  constexpr auto most = std::numeric_limits<std::int64_t>::max();
  for (const std::int64_t i : {std::int64_t{-1}, std::int64_t{10}, most, -most}) {
    SCOPED_TRACE(i);
    expect_outside(DiscreteDomain{10}, i);
  }
}

TEST(FollowsWithFastMath, FindsADensityThatIsNone) {
  for (const double wrong : {nan(), inf(), -inf(), -1.0, 0.0}) {
    SCOPED_TRACE(wrong);
    int asked = 0;
    const auto later = [&](double) { return ++asked > 100'000 ? wrong : 1.0; };  // after the quadrature
    expect_found(expect_follows(googletest_site(), uniform, later, IntervalDomain{0, 1}, 0.01), "the density");
    if (wrong == 0) continue;
    const auto always = [&](double) { return wrong; };
    expect_found(expect_follows(googletest_site(), uniform, always, IntervalDomain{0, 1}, 0.1), "the density is");
  }
}

TEST(UnbiasedWithFastMath, FindsDrawsThatAreNone) {
  for (const double wrong : {nan(), inf(), -inf()}) {
    SCOPED_TRACE(wrong);
    const auto draw = [&](Generator& generator) {
      const double u = uniform(generator);
      return u > 0.9 ? wrong : u;
    };
    expect_found(expect_unbiased(googletest_site(), draw, bounded(0.5, 0, 1), 0.1), "draw ");
    expect_found(expect_unbiased(googletest_site(), draw, 0.5, 0.1), "draw ");
  }
}

TEST(AgreeWithFastMath, FindsDrawsThatAreNone) {
  for (const double wrong : {nan(), inf(), -inf()}) {
    SCOPED_TRACE(wrong);
    const auto draw = [&](Generator& generator) {
      const double u = uniform(generator);
      return u > 0.9 ? wrong : u;
    };
    expect_found(expect_agree(googletest_site(), draw, uniform, 0.1), "draw ");
    expect_found(expect_agree(googletest_site(), uniform, draw, 0.1), "draw ");
  }
}

TEST(WithFastMath, RightDrawsAreCertified) {
  EXPECT_UNBIASED(uniform, bounded(0.5, 0, 1), 0.05);
  EXPECT_FOLLOWS(
      uniform, [](double) { return 1.0; }, (IntervalDomain{0, 1}), 0.1);
}

TEST(RosenblattWithFastMath, RefusesAPlaceOutsideTheSquare) {
  const Rosenblatt transform([](double, double) { return 1.0; });
  for (const double x : wrong_numbers()) {
    EXPECT_THROW(transform(x, 0.5), std::out_of_range) << x;
    EXPECT_THROW(transform(0.5, x), std::out_of_range) << x;
  }
}

// Floats are summed in the caller's code, where -ffast-math may not take digits away.
TEST(ExactMomentsWithFastMath, AddFloatsAsIfOneByOne) {
  std::mt19937_64 generator;
  std::vector<float> draws(64);
  for (float& x : draws) x = static_cast<float>(uniform(generator));
  ExactMoments at_once, alone;
  at_once.add(std::span<const float>(draws));
  for (float x : draws) alone.add(static_cast<double>(x));
  EXPECT_EQ(at_once, alone);
  draws[7] = static_cast<float>(nan());
  EXPECT_THROW(at_once.add(std::span<const float>(draws)), std::domain_error);
}

}  // namespace
}  // namespace fairlight
