#include <stdexcept>

#include <gtest/gtest.h>

#include <fairlight/stats/manifest.h>

namespace fairlight {
namespace {

const Manifest::Terms terms{.seed = 7, .budget = 1e-4, .beta = 0.02, .margin = 0.01};

TEST(Manifest, GivesAClaimItsShareItsSeedAndItsMargin) {
  const Manifest manifest({{"a", 1, 1}, {"b", 3, 5}}, terms);
  const Trial trial = manifest.trial("b");
  EXPECT_EQ(trial.claim, "b");
  EXPECT_EQ(trial.seed, 7u);
  EXPECT_DOUBLE_EQ(trial.alpha, 0.75e-4);
  EXPECT_EQ(trial.beta, 0.02);
  EXPECT_DOUBLE_EQ(trial.margin, 0.05);
}

TEST(Manifest, KeepsAPartOfTheBudgetForWhatClaimsShowTogether) {
  Manifest::Terms joint = terms;
  joint.joint_part = 0.1;
  const Manifest manifest({{"a"}, {"b"}}, joint);
  EXPECT_DOUBLE_EQ(manifest.trial("a").alpha, 0.45e-4);
  EXPECT_DOUBLE_EQ(manifest.joint_level(5), 0.02e-4);
  for (double wrong : {-0.1, 1.0}) {
    joint.joint_part = wrong;
    EXPECT_THROW(Manifest({{"a"}}, joint), std::invalid_argument) << wrong;
  }
}

TEST(Manifest, AsksNoClaimForMoreThanItCanShow) {
  const Manifest manifest({{"a", 1, 1, 0.02}, {"b", 1, 5, 0.02}}, terms);  // of a run that asks for 0.01
  EXPECT_EQ(manifest.trial("a").margin, 0.02);
  EXPECT_DOUBLE_EQ(manifest.trial("b").margin, 0.05);
  for (double wrong : {-1.0, 1.0}) {
    EXPECT_THROW(Manifest({{"a", 1, 1, wrong}}, terms), std::invalid_argument) << wrong;
  }
}

TEST(Manifest, RunsNoClaimThatIsNotListed) {
  EXPECT_THROW(Manifest({{"a"}}, terms).trial("b"), std::invalid_argument);
}

TEST(Manifest, RefusesTwoClaimsOfOneNameAndNone) {
  EXPECT_THROW(Manifest({{"a"}, {"a"}}, terms), std::invalid_argument);
  EXPECT_THROW(Manifest({}, terms), std::invalid_argument);
}

TEST(Manifest, RefusesTermsThatAreNoProbabilities) {
  const auto with = [](double budget, double beta, double margin) {
    return Manifest({{"a"}}, {.seed = 0, .budget = budget, .beta = beta, .margin = margin});
  };
  EXPECT_NO_THROW(with(0.5, 0.5, 0.5));
  for (double wrong : {0.0, 1.0, -1.0, 2.0}) {
    EXPECT_THROW(with(wrong, 0.5, 0.5), std::invalid_argument) << wrong;
    EXPECT_THROW(with(0.5, wrong, 0.5), std::invalid_argument) << wrong;
    EXPECT_THROW(with(0.5, 0.5, wrong), std::invalid_argument) << wrong;
  }
  EXPECT_THROW(Manifest({{"a", 1, 200}}, terms).trial("a"), std::invalid_argument);
}

}  // namespace
}  // namespace fairlight
