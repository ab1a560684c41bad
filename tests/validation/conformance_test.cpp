#include <stdexcept>

#include <gtest/gtest.h>

#include <fairlight/validation/conformance.h>
#include <fairlight/validation/registry.h>

namespace fairlight {
namespace {

const Conformance quick{{.seed = 3, .margin = 0.01}, 1};

TEST(ManifestOf, GivesAClaimItsShareWhateverElseRuns) {
  double sum = 0;
  const Manifest manifest = manifest_of(quick);
  for (const Claim& claim : registry()) sum += manifest.trial(claim.name).alpha;
  EXPECT_NEAR(sum, 1e-6, 1e-18);
}

TEST(ManifestOf, RefusesAClaimOutsideTheRegistry) {
  EXPECT_THROW(manifest_of(quick).trial("nobody.claims.this"), std::invalid_argument);
}

TEST(ManifestOf, RefusesMarginsAndBudgetsThatAreNoProbability) {
  for (double margin : {0.0, -1.0, 1.0, 5.0}) {
    Conformance wrong = quick;
    wrong.terms.margin = margin;
    EXPECT_THROW(manifest_of(wrong).trial(registry()[0].name), std::invalid_argument) << margin;
  }
  for (double budget : {0.0, 1.0, -1.0}) {
    Conformance wrong = quick;
    wrong.terms.budget = budget;
    EXPECT_THROW(manifest_of(wrong).trial(registry()[0].name), std::invalid_argument) << budget;
  }
}

TEST(RunClaims, FindTheSameAloneOrTogetherOnAnyThreads) {
  const auto together = select_claims({"pick.*.dice", "importance.cosine"});
  Conformance two = quick;
  two.threads = 2;
  const auto outcomes = run_claims(together, two);
  for (std::size_t i = 0; i < together.size(); ++i) {
    const Finding alone = run_claims({together[i]}, quick).front().finding;
    EXPECT_EQ(alone.draws, outcomes[i].finding.draws) << together[i]->name;
    EXPECT_EQ(alone.bias, outcomes[i].finding.bias) << together[i]->name;
  }
}

TEST(Overall, IsTheWorst) {
  Outcome good{&registry()[0], {}, 0};
  good.finding.verdict = Verdict::certified;
  Outcome bad = good;
  bad.finding.verdict = Verdict::biased;
  EXPECT_EQ(overall({good, good}), Verdict::certified);
  EXPECT_EQ(overall({good, bad}), Verdict::biased);
}

}  // namespace
}  // namespace fairlight
