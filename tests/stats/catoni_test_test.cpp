#include <cmath>
#include <limits>
#include <stdexcept>

#include <boost/math/distributions/binomial.hpp>
#include <gtest/gtest.h>
#include <support/run_seed.h>

#include <fairlight/stats/catoni_test.h>
#include <fairlight/stats/site.h>

namespace fairlight {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
const Trial trial{"catoni", 1, 1e-6, 0.01, 0.1};

double uniform(Generator& g) { return static_cast<double>(g() >> 11) * 0x1p-53; }

// Laws of mean 1 and the variance that is declared for them.
struct Law {
  const char* name;
  double variance;
  double (*draw)(Generator&);
};
const std::vector<Law> laws{
    {"exponential", 1, [](Generator& g) { return -std::log1p(-uniform(g)); }},
    {"coin", 1, [](Generator& g) { return uniform(g) < 0.5 ? 2.0 : 0.0; }},
    {"rare", 99, [](Generator& g) { return uniform(g) < 0.01 ? 100.0 : 0.0; }},
    {"rare loss", 0.0527, [](Generator& g) { return uniform(g) < 0.05 ? 0 : 1 / 0.95; }},
    {"pareto of index 5/2", 0.8, [](Generator& g) { return 0.6 * std::pow(1 - uniform(g), -0.4); }},
    {"constant", 1, [](Generator&) { return 1.0; }},
};

Verdict verdict(const Law& law, const Trial& of, double bias, std::uint64_t run) {
  Generator generator(testing::run_seed() + run);
  return catoni_test(of, {1, law.variance}, 1,
                     one_channel([&](std::uint64_t) { return law.draw(generator) + bias; }))
      .verdict;
}

// The largest number of 300 runs that a rate of 0.01 exceeds once in 10^6.
int limit() { return static_cast<int>(quantile(complement(boost::math::binomial(300, 0.01), 1e-6))); }

TEST(Catoni, KeepsItsLevelAndItsMissRateOnHardLaws) {
  const Trial often{"catoni", 1, 0.01, 0.01, 0.3};
  for (const Law& law : laws) {
    int alarms = 0, misses = 0;
    for (std::uint64_t run = 0; run < 300; ++run) {
      alarms += verdict(law, often, 0, run) != Verdict::certified;
      misses += verdict(law, often, run % 2 == 0 ? 0.3 : -0.3, 300 + run) == Verdict::certified;
    }
    EXPECT_LE(alarms, limit()) << law.name;
    EXPECT_LE(misses, limit()) << law.name;
  }
}

TEST(Catoni, FindsADeclaredVarianceThatIsTooSmall) {
  Generator generator(testing::run_seed());
  const Finding finding =
      catoni_test(trial, {1, 0.2}, 1, one_channel([&](std::uint64_t) { return laws[0].draw(generator); }));
  EXPECT_EQ(finding.verdict, Verdict::biased);
  EXPECT_NE(finding.note.find("a variance of 0.2 allows"), std::string::npos) << finding.note;
}

TEST(Catoni, IsExactGivenTheVariance) {
  const Finding finding =
      catoni_test(trial, {1, 1}, 1, one_channel([](std::uint64_t i) { return i % 2 == 0 ? 0.9 : 1.1; }));
  EXPECT_EQ(finding.verdict, Verdict::certified);
  EXPECT_EQ(finding.guarantee, Guarantee::exact_given_tail);
  EXPECT_NE(finding.note.find("on trust"), std::string::npos) << finding.note;
  EXPECT_GT(finding.interval.lo, -0.1 - 1e-6);
  EXPECT_LT(finding.interval.hi, 0.1 + 1e-6);
}

TEST(Catoni, RefusesWhatIsNoClaim) {
  const auto any = one_channel([](std::uint64_t) { return 1.0; });
  for (double none : {0.0, -1.0, infinite, std::nan("")}) {
    EXPECT_THROW(catoni_test(trial, {1, none}, 1, any), std::invalid_argument) << none;
    EXPECT_THROW(catoni_test(trial, {1, 1}, none, any), std::invalid_argument) << none;
  }
  EXPECT_THROW(catoni_test(trial, {infinite, 1}, 1, any), std::invalid_argument);
  EXPECT_THROW(catoni_test(trial, {1, 1e30}, 1, any), std::invalid_argument);
}

TEST(Catoni, NamesADrawThatIsNotFinite) {
  const auto broken = one_channel([](std::uint64_t i) { return i == 70 ? infinite : 1.0; });
  const Finding finding = catoni_test(trial, {1, 1}, 1, broken);
  EXPECT_EQ(finding.verdict, Verdict::biased);
  EXPECT_NE(finding.note.find("draw 70 is inf"), std::string::npos) << finding.note;
}

}  // namespace
}  // namespace fairlight
