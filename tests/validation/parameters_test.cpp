#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fairlight/validation/checks/parameters.h>
#include <fairlight/validation/run/registry.h>

namespace fairlight {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

using Law = ParameterRange::Law;

// The mean of value + u - 1/2 is the value.
auto shifted(const std::vector<double>& values) {
  const double value = values[0];
  const auto draw = [value]<class Real>(std::type_identity<Real>, auto& source) {
    return Real(rounded<Real>(value - 0.5) + source.next());
  };
  return estimand("shifted", {"Shifted"}, "a mean", "elementary", {{value, value - 0.5, value + 0.5}}, draw);
}

const std::vector<ParameterRange> reflectance{{"SchlickReflectance", "reflectance", 0.5, 1}};

Trial trial(std::uint64_t seed) {
  return Manifest({{.name = "shifted"}}, {.seed = seed, .margin = 0.01}).trial("shifted");
}

TEST(Parameters, AreDrawnFromTheirRangesAnewForEachSeed) {
  const std::vector<ParameterRange> ranges{
      {"A", "width", 2, 3}, {"A", "length", 1e-3, 1e3, Law::logarithmic}, {"A", "corner", 7, 7}};
  double below_one = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const std::vector<double> values = drawn(ranges, trial(seed));
    EXPECT_TRUE(values[0] >= 2 && values[0] <= 3) << values[0];
    EXPECT_TRUE(values[1] >= 1e-3 && values[1] <= 1e3) << values[1];
    EXPECT_EQ(values[2], 7);
    below_one += values[1] < 1 ? 1 : 0;
  }
  // Half of a logarithmic range is below its geometric middle: 200 of 400 give or take 6 deviations of 10.
  EXPECT_TRUE(below_one > 140 && below_one < 260) << below_one;
  EXPECT_NE(drawn(ranges, trial(1)), drawn(ranges, trial(2)));
  EXPECT_EQ(drawn(ranges, trial(1)), drawn(ranges, trial(1)));
  EXPECT_DOUBLE_EQ(middles(ranges)[1], 1);
}

TEST(Parameters, OutsideTheDomainOfTheComponentAreAFaultOfTheClaim) {
  EXPECT_NO_THROW(mean_claim_over<double>(reflectance, shifted));
  const auto refusal = [](double low, double high, Law law = Law::uniform) {
    return [=] { mean_claim_over<double>({{"SchlickReflectance", "reflectance", low, high, law}}, shifted); };
  };
  EXPECT_THAT(refusal(0.5, 1.1), ThrowsMessage<std::logic_error>(HasSubstr("not within its domain [0, 1]")));
  EXPECT_THAT(refusal(-0.1, 1), ThrowsMessage<std::logic_error>(HasSubstr("not within its domain")));
  EXPECT_THAT(refusal(0, 1, Law::logarithmic), ThrowsMessage<std::logic_error>(HasSubstr("not positive")));
  EXPECT_THAT(
      [] {
        mean_claim_over<double>({{"SchlickReflectance", "sheen", 0, 1}}, shifted);
      },
      ThrowsMessage<std::logic_error>(HasSubstr("sheen of SchlickReflectance, which has no domain")));
}

TEST(Parameters, ReachTheDrawsAndTheReferencesOfAClaim) {
  const Claim claim = mean_claim_over<double>(reflectance, shifted);
  EXPECT_EQ(claim.check(trial(3)).verdict, Verdict::certified);
  EXPECT_EQ(claim.covers.size(), 1u);
  const auto wrong = [](const std::vector<double>& values) {
    auto estimand = shifted(values);
    estimand.references = shifted({0.75}).references;
    estimand.references[0].lower = 0;
    estimand.references[0].upper = 2;
    return estimand;
  };
  const Finding finding = mean_claim_over<double>(reflectance, wrong).check(trial(3));
  EXPECT_EQ(finding.verdict, Verdict::biased);
  EXPECT_THAT(finding.note, HasSubstr("at reflectance = 0."));
}

}  // namespace
}  // namespace fairlight
