#include <gtest/gtest.h>

#include <fairlight/validation/registry.h>
#include <fairlight/validation/report.h>

namespace fairlight {
namespace {

const Conformance conformance{{.seed = 0xAB}};

Outcome outcome(Verdict verdict) {
  Outcome made{&registry()[0], {}, 1.5};
  made.finding = {verdict, Guarantee::exact, 1e-3, 2e-4, {-5e-4, 9e-4}, 1000};
  return made;
}

TEST(Report, SaysHowToReplayAClaim) {
  EXPECT_EQ(replay("a.b", conformance), "fairlight verify a.b --seed 00000000000000ab");
  Conformance unusual = conformance;
  unusual.terms.margin = 0.125;
  EXPECT_EQ(replay("a.b", unusual), "fairlight verify a.b --seed 00000000000000ab --margin 0.125");
}

TEST(Report, HasTheFieldsOfTheContractAsJson) {
  const auto json = outcomes_json({outcome(Verdict::biased)}, conformance, 2);
  for (const char* key : {"version", "seed", "budget", "seconds", "verdict", "claims"})
    EXPECT_TRUE(json.contains(key)) << key;
  EXPECT_EQ(json["verdict"], "biased");
  const auto& claim = json["claims"][0];
  EXPECT_EQ(claim["name"], registry()[0].name);
  EXPECT_EQ(claim["verdict"], "biased");
  EXPECT_EQ(claim["guarantee"], "exact");
  EXPECT_EQ(claim["margin"], 1e-3);
  EXPECT_EQ(claim["bias"], 2e-4);
  EXPECT_EQ(claim["interval"].dump(), "[-0.0005,0.0009]");
  EXPECT_EQ(claim["samples"], 1000);
  EXPECT_EQ(claim["real"], "double");
  EXPECT_TRUE(claim.contains("kind") && claim.contains("seconds") && claim.contains("replay"));
}

}  // namespace
}  // namespace fairlight
