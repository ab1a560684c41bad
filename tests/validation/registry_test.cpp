#include <algorithm>
#include <filesystem>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

#include <fairlight/validation/run/registry.h>
#include <fairlight/validation/run/run_claims.h>

namespace fairlight {
namespace {

TEST(Registry, HasNoTwoClaimsOfOneName) {
  std::set<std::string> names;
  for (const Claim& claim : registry()) EXPECT_TRUE(names.insert(claim.name).second) << claim.name;
}

TEST(Registry, HasTheSameRowsForEveryInstructionSet) {
  const std::vector<std::string> sets = claimed_instructions();
  EXPECT_EQ(registry().front().instructions, sets.back()) << "the widest";
  for (const std::string& set : sets) {
    const std::vector<Claim>& rows = registry(set);
    ASSERT_EQ(rows.size(), registry().size()) << set;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      EXPECT_EQ(rows[i].name, registry()[i].name) << set;
      EXPECT_EQ(rows[i].margin_factor, registry()[i].margin_factor) << set << rows[i].name;
      EXPECT_EQ(rows[i].weight, registry()[i].weight) << set << rows[i].name;
      EXPECT_EQ(rows[i].instructions, set) << rows[i].name;
    }
  }
  EXPECT_THROW(registry("mmx"), std::invalid_argument);
}

TEST(Manifest, PartsTheBudgetBetweenInstructionSets) {
  RunOptions one{{.seed = 0}, 1}, two = one;
  two.instructions = {"", ""};
  const std::string& name = registry().front().name;
  EXPECT_DOUBLE_EQ(manifest_of(two).trial(name).alpha, manifest_of(one).trial(name).alpha / 2);
}

TEST(Registry, SaysOfEveryClaimWhatItIsAndWhereItComesFrom) {
  for (const Claim& claim : registry()) {
    EXPECT_FALSE(claim.statement.empty()) << claim.name;
    EXPECT_FALSE(claim.source.empty()) << claim.name;
    EXPECT_FALSE(claim.subjects.empty()) << claim.name;
    EXPECT_GE(claim.margin_factor, 1) << claim.name;
  }
}

// A test refuses terms that it cannot be held to, such as a margin that roundings fill, and a run of all claims ends there.
TEST(Registry, HasNoClaimThatAFineMarginStops) {
  const Manifest manifest = manifest_of({{.seed = 0, .margin = 1e-4}, 1});
  for (const Claim& claim : registry()) {
    Trial trial = manifest.trial(claim.name);
    trial.watch = [](double) { return false; };
    EXPECT_NO_THROW(claim.check(trial)) << claim.name;
  }
}

TEST(Registry, KnowsTheFileOfEveryClaim) {
  for (const Claim& claim : registry()) {
    EXPECT_TRUE(std::filesystem::exists(FAIRLIGHT_SOURCE_DIR "/validation/claims/" + claim.file)) << claim.name;
    EXPECT_EQ(claim.name.find_first_of(" \t\n"), std::string::npos)
        << claim.name << ": a name is a word of a ledger's line";
  }
}

TEST(SelectClaims, TakesAllByDefault) { EXPECT_EQ(select_claims({}).size(), registry().size()); }

TEST(SelectClaims, TakesNamesFirstPartsAndPatterns) {
  const auto count = [](const auto& wanted) { return std::ranges::count_if(registry(), wanted); };
  EXPECT_EQ(select_claims({"hemisphere.cosine.law"}).size(), 1u);
  const auto hemispheres = count([](const Claim& claim) { return claim.name.starts_with("hemisphere."); });
  EXPECT_EQ(std::ssize(select_claims({"hemisphere"})), hemispheres);
  EXPECT_EQ(std::ssize(select_claims({"hemisphere", "hemisphere.cosine.law"})), hemispheres);
  EXPECT_EQ(std::ssize(select_claims({"*.law"})),
            count([](const Claim& claim) { return claim.name.ends_with(".law"); }));
}

TEST(SelectClaims, NameTheNearestFewWhereNoneMatches) {
  const auto refusal = [](const std::string& pattern) -> std::string {
    try {
      select_claims({pattern});
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "it is none";
  };
  EXPECT_NE(refusal("hemisphere.cosine.lw").find("mean hemisphere.cosine.law"), std::string::npos);
  EXPECT_NE(refusal("hemisphre").find("mean hemisphere, "), std::string::npos) << refusal("hemisphre");
  for (const char* pattern : {"hemisphere.cosine.lw", "h", "zzz.*.zzz", "e"}) {
    EXPECT_NE(refusal(pattern).find("fairlight verify --list"), std::string::npos) << pattern;
    EXPECT_LT(refusal(pattern).size(), 500u) << refusal(pattern);
  }
}

TEST(Registry, HoldsEverySamplerInBothArithmetics) {
  std::set<std::string> in_double;
  std::set<std::string> in_packets;
  for (const Claim& claim : registry()) {
    if (claim.kind == "law" && claim.real == "double")
      in_double.insert(claim.subjects.begin(), claim.subjects.end());
    if (claim.real == "packet") in_packets.insert(claim.subjects.begin(), claim.subjects.end());
  }
  EXPECT_GE(in_double.size(), 15u);
  for (const std::string& sampler : in_double) EXPECT_TRUE(in_packets.contains(sampler)) << sampler;
}

}  // namespace
}  // namespace fairlight
