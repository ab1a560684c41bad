// Expectations that fail in some runs: repeats_test runs this program, and replays what it prints.
#include <limits>
#include <random>

#include <fairlight/stats/googletest.h>

namespace {

// Three quarters of runs meet none of these draws.
double rarely_nan(fairlight::Generator& generator) {
  const double x = std::uniform_real_distribution<>()(generator);
  return x < 1.5e-4 ? std::numeric_limits<double>::quiet_NaN() : x;
}

double uniform(fairlight::Generator& generator) { return std::uniform_real_distribution<>()(generator); }

void expect_half() { EXPECT_UNBIASED(rarely_nan, fairlight::bounded(0.5, 0, 1), 0.05); }

TEST(Repeated, Alone) { expect_half(); }

TEST(Repeated, AfterOthers) {
  EXPECT_UNBIASED(uniform, fairlight::bounded(0.5, 0, 1), 0.2);
  EXPECT_AGREE(uniform, uniform, 0.2);
  for (int i = 0; i < 2; ++i) expect_half();
}

TEST(Repeated, DISABLED_Alone) { expect_half(); }

class OfAValue : public ::testing::TestWithParam<double> {};
TEST_P(OfAValue, Is) {
  const auto scaled = [](auto& generator) { return GetParam() * rarely_nan(generator); };
  EXPECT_UNBIASED(scaled, fairlight::bounded(GetParam() / 2, 0, GetParam()), 0.05);
}
INSTANTIATE_TEST_SUITE_P(Two, OfAValue, ::testing::Values(1, 2));

template <class T>
class OfAType : public ::testing::Test {};
using Types = ::testing::Types<float, double>;
TYPED_TEST_SUITE(OfAType, Types);
TYPED_TEST(OfAType, Is) {
  const auto converted = [](auto& generator) { return static_cast<TypeParam>(rarely_nan(generator)); };
  EXPECT_UNBIASED(converted, 0.5, 0.05);
}

}  // namespace
