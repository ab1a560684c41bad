#include <regex>
#include <set>
#include <sstream>

#include <gtest/gtest.h>
#include <support/shell.h>

// Every failure under --gtest_repeat prints a line that replays it, whatever kind of test it stands in.
namespace fairlight::testing {
namespace {

struct Failure {
  std::string draw;  // "draw 17 is nan"
  std::string seed, flags;
};

std::vector<Failure> failures(const std::string& environment, const std::string& flags,
                              const TemporaryFolder& folder) {
  static const std::regex draw(R"(draw \d+ is -?nan)"), again(R"(again: (FAIRLIGHT_SEED=\w+) (.*))");
  const Result run = shell(environment + " " FAILING_EXPECTATIONS " " + flags, folder);
  std::istringstream lines(run.out);
  std::vector<Failure> all;
  std::smatch match;
  std::string last;
  for (std::string line; std::getline(lines, line);) {
    if (std::regex_search(line, match, draw)) last = match.str();
    if (std::regex_search(line, match, again)) all.push_back({last, match[1], match[2]});
  }
  return all;
}

bool replays(const Failure& failure, const TemporaryFolder& folder) {
  for (const Failure& found : failures(failure.seed, failure.flags, folder)) {
    if (found.draw == failure.draw && found.seed == failure.seed && found.flags == failure.flags) return true;
  }
  return false;
}

TEST(ARepetition, IsReplayedByTheLineThatItPrints) {
  const TemporaryFolder folder;
  const auto all = failures("", "--gtest_repeat=20 --gtest_shuffle", folder);
  std::set<std::string> seeds, tests;
  for (const Failure& failure : all) {
    seeds.insert(failure.seed);
    const bool first_of_its_test = tests.insert(failure.flags).second;
    if (first_of_its_test || seeds.size() > 12) {
      EXPECT_TRUE(replays(failure, folder)) << failure.draw << " " << failure.seed << " " << failure.flags;
    }
  }
  EXPECT_GE(seeds.size(), 5u) << "repetitions have draws of their own";
  EXPECT_GE(tests.size(), 4u);
}

TEST(ARepetition, OfOneTestAloneIsReplayedToo) {
  const TemporaryFolder folder;
  const auto all = failures("", "--gtest_repeat=40 --gtest_filter=Repeated.AfterOthers", folder);
  ASSERT_FALSE(all.empty());
  for (const Failure& failure : all) EXPECT_TRUE(replays(failure, folder)) << failure.draw << " " << failure.seed;
}

TEST(ARepetition, OfADisabledTestPrintsTheFlagThatRunsIt) {
  const TemporaryFolder folder;
  const auto all =
      failures("", "--gtest_repeat=40 --gtest_also_run_disabled_tests --gtest_filter=*DISABLED_Alone", folder);
  ASSERT_FALSE(all.empty());
  EXPECT_NE(all[0].flags.find("--gtest_also_run_disabled_tests"), std::string::npos) << all[0].flags;
}

TEST(ASeed, GivesTheSameRepetitionsAgain) {
  const TemporaryFolder folder;
  const auto seeds = [&] {
    std::vector<std::string> all;
    for (const Failure& failure : failures("FAIRLIGHT_SEED=5", "--gtest_repeat=20", folder))
      all.push_back(failure.seed + failure.draw + failure.flags);
    return all;
  };
  EXPECT_EQ(seeds(), seeds());
}

}  // namespace
}  // namespace fairlight::testing
