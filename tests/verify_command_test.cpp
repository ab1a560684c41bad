#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <support/program.h>

namespace fairlight {
namespace {

using testing::fairlight;
using testing::read_file;
using testing::Result;
using testing::shell;
using testing::TemporaryFolder;
using testing::write_file;

TEST(Verify, VerifiesAndReplays) {
  const TemporaryFolder folder;
  EXPECT_NE(fairlight("verify --list", folder).out.find("hemisphere.cosine.law"), std::string::npos);
  ASSERT_EQ(fairlight("verify pick.all.dice importance.cosine --margin 0.05 --json a.json", folder).status, 0);
  const auto first = nlohmann::json::parse(read_file(folder / "a.json"));
  for (const auto& claim : first["claims"]) {
    const std::string replay = claim["replay"].get<std::string>().substr(std::string("fairlight ").size());
    ASSERT_EQ(fairlight(replay + " --json b.json --threads 3", folder).status, 0);
    auto again = nlohmann::json::parse(read_file(folder / "b.json"))["claims"][0];
    again["seconds"] = claim["seconds"];
    EXPECT_EQ(again, claim);
  }
}

TEST(Verify, CertifiesEveryInstructionSetThatTheMachineHas) {
  const TemporaryFolder folder;
  const Result run = fairlight("verify pick.one.dice --margin 0.05 --instructions all --json a.json", folder);
  ASSERT_EQ(run.status, 0) << run.error;
  const auto claims = nlohmann::json::parse(read_file(folder / "a.json"))["claims"];
  std::set<std::string> sets;
  for (const auto& claim : claims) sets.insert(claim["instructions"].get<std::string>());
  EXPECT_GE(sets.size(), 1u);
  EXPECT_EQ(claims.size() % sets.size(), 0u);
  const std::string replay = claims[0]["replay"].get<std::string>().substr(std::string("fairlight ").size());
  ASSERT_EQ(fairlight(replay + " --json b.json", folder).status, 0) << replay;
  auto again = nlohmann::json::parse(read_file(folder / "b.json"))["claims"][0];
  again["seconds"] = claims[0]["seconds"];
  EXPECT_EQ(again, claims[0]) << "a claim of a run by all is replayed alone";
  EXPECT_EQ(fairlight("verify pick.one.dice --instructions mmx", folder).status, 2);
}

const std::string a_run = "verify pick.all.dice.latin --margin 0.05 ";

TEST(Verify, AddsRunsUpInALedger) {
  const TemporaryFolder folder;
  for (int i = 0; i < 3; ++i) {
    const Result run = fairlight(a_run + "--ledger l --json a.json", folder);
    ASSERT_EQ(run.status, 0) << run.error;
    EXPECT_NE(run.out.find("ledger: l, "), std::string::npos) << run.out;
  }
  const auto claim = nlohmann::json::parse(read_file(folder / "a.json"))["claims"][0];
  EXPECT_EQ(claim["ledger"]["runs"], 3);
  EXPECT_LT(claim["ledger"]["margin"], claim["margin"]);
  const Result show = fairlight("ledger show l", folder);
  EXPECT_EQ(show.status, 0) << show.error;
  EXPECT_NE(show.out.find("pick.all.dice"), std::string::npos) << show.out;
  EXPECT_EQ(fairlight("ledger merge l -o ./l", folder).status, 2);
  write_file(folder / "m", read_file(folder / "l"));
  fairlight(a_run + "--ledger m", folder);
  const Result merged = fairlight("ledger merge l m -o both", folder);
  EXPECT_EQ(merged.status, 0) << merged.error;
  EXPECT_NE(merged.out.find("3 entries left out"), std::string::npos) << merged.out;
  EXPECT_NE(fairlight("ledger show both", folder).out.find("     4 "), std::string::npos);
}

// Numbers that were chosen, or seen before, are no new evidence.
TEST(Verify, RefusesASeedWithALedger) {
  const TemporaryFolder folder;
  const Result run = fairlight(a_run + "--ledger l --seed 1", folder);
  EXPECT_EQ(run.status, 2);
  EXPECT_NE(run.error.find("--seed and --ledger exclude each other"), std::string::npos) << run.error;
  EXPECT_EQ(folder.files(), 0);
}

TEST(Verify, SaysWhatTheClaimsOfAComponentShowTogether) {
  const TemporaryFolder folder;
  const Result run = fairlight("verify importance --margin 0.05 --json a.json", folder);
  ASSERT_EQ(run.status, 0) << run.error;
  EXPECT_NE(run.out.find("relative bias common to its claims"), std::string::npos) << run.out;
  const auto components = nlohmann::json::parse(read_file(folder / "a.json"))["components"];
  ASSERT_FALSE(components.empty());
  for (const auto& component : components) EXPECT_LT(component["margin"], 0.05) << component;
}

TEST(Verify, RefusesADamagedLedgerBeforeItRuns) {
  const TemporaryFolder folder;
  ASSERT_EQ(fairlight(a_run + "--ledger l", folder).status, 0);
  const std::string good = read_file(folder / "l");
  for (const std::string& bad : {good.substr(0, 10), "fairlight ledger 2" + good.substr(18), "claims\n" + good,
                                 good.substr(0, 40) + "x" + good.substr(41)}) {
    write_file(folder / "l", bad);
    for (const std::string& arguments :
         {a_run + "--ledger l", std::string("ledger show l"), std::string("ledger merge l -o m")}) {
      const Result run = fairlight(arguments, folder);
      EXPECT_EQ(run.status, 2) << arguments;
      EXPECT_EQ(std::count(run.error.begin(), run.error.end(), '\n'), 1) << run.error;
      EXPECT_EQ(read_file(folder / "l"), bad) << arguments;
      EXPECT_EQ(folder.files(), 1) << arguments;
    }
  }
  write_file(folder / "l", good.substr(0, good.size() - 5));
  const Result run = fairlight(a_run + "--ledger l", folder);
  EXPECT_EQ(run.status, 0) << run.error;
  EXPECT_NE(run.out.find("cut off"), std::string::npos) << run.out;
}

TEST(Verify, VerifiesWhatAChangeTouches) {
  const TemporaryFolder folder;
  const Result run = fairlight("verify pick --since HEAD --list", folder);
  if (run.status == 2) GTEST_SKIP() << run.error;  // sources without their repository
  EXPECT_EQ(run.status, 0);
  EXPECT_NE(run.out.find(" claims rest on sources that differ from HEAD"), std::string::npos) << run.out;
}

TEST(Verify, LeavesUndecidedWhatItHasNoTimeFor) {
  const TemporaryFolder folder;
  const Result run = fairlight("verify pick importance --margin 3e-5 --seconds 0.5 --json a.json", folder);
  EXPECT_EQ(run.status, 3) << run.out;
  EXPECT_EQ(run.error, "") << "no progress bar in a pipe";
  EXPECT_NE(run.out.find("time was up"), std::string::npos) << run.out;
  const auto json = nlohmann::json::parse(read_file(folder / "a.json"));
  EXPECT_EQ(json["verdict"], "undecided");
  EXPECT_LT(json["seconds"], 60);
}

TEST(Verify, KeepsWhatItSawAndWritesAPageWithItsPictures) {
  const TemporaryFolder folder;
  const std::string arguments = "verify hemisphere.cosine.law pick.one.dice --margin 0.05 --report page.md";
  ASSERT_EQ(fairlight(arguments, folder).status, 0);
  for (const char* file : {"hemisphere.cosine.law/cells.csv", "hemisphere.cosine.law/cells.exr",
                           "hemisphere.cosine.law/p_map.png", "hemisphere.cosine.law/histogram.png",
                           "pick.one.dice/wealth.csv", "pick.one.dice/finding.json", "intervals.png"}) {
    EXPECT_FALSE(read_file(folder / (std::string("page_artifacts/") + file)).empty()) << file;
  }
  const std::string page = read_file(folder / "page.md");
  EXPECT_NE(page.find("(page_artifacts/hemisphere.cosine.law/p_map.png)"), std::string::npos) << page;
  EXPECT_EQ(folder.files(), 2);
  ASSERT_EQ(fairlight("verify pick.one --margin 0.05 --artifacts kept", folder).status, 0);
  EXPECT_TRUE(std::filesystem::exists(folder / "kept/intervals.png"));
  EXPECT_FALSE(std::filesystem::exists(folder / "kept/pick.one.dice"))
      << "it did not fail, and was not named in full";
}

TEST(Verify, NeedsGnuplotForPicturesAndForNothingElse) {
  const TemporaryFolder folder;
  const std::string bare = "PATH=/none " FAIRLIGHT_PROGRAM " verify pick.one.dice --margin 0.05 ";
  for (const char* option : {"--artifacts kept", "--report page.md"}) {
    const Result run = shell(bare + option, folder);
    EXPECT_EQ(run.status, 2) << option;
    EXPECT_EQ(run.out, "") << "it is refused before a claim runs";
    EXPECT_EQ(run.error,
              "fairlight: charts need gnuplot with pngcairo, which is not on the PATH (install the Debian "
              "package gnuplot-nox)\n");
    EXPECT_EQ(folder.files(), 0) << option;
  }
  EXPECT_EQ(shell(bare + "--json a.json", folder).status, 0);
}

}  // namespace
}  // namespace fairlight
