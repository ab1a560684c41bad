#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <support/program.h>

namespace fairlight {
namespace {

using testing::expect_bad_input;
using testing::fairlight;
using ::testing::HasSubstr;
using testing::read_file;
using testing::Result;
using testing::shell;
using testing::TemporaryFolder;
using testing::write_file;

// Pipes the output of a command into judge.
Result judge(const std::string& producer, const std::string& options, const TemporaryFolder& folder) {
  return shell(producer + " | " FAIRLIGHT_PROGRAM " judge " + options, folder);
}

// The source of the first program that docs/judge.md shows in this language.
std::string recipe(const std::string& language) {
  const std::string page = read_file(FAIRLIGHT_SOURCE_DIR "/docs/judge.md");
  const std::size_t fence = page.find("```" + language + "\n");
  EXPECT_NE(fence, std::string::npos) << language;
  const std::size_t begin = page.find('\n', fence) + 1;
  return page.substr(begin, page.find("```", begin) - begin);
}

TEST(JudgeCommand, StopsAProducerThatNeverEnds) {
  const TemporaryFolder folder;
  EXPECT_EQ(judge("yes 0.25", "--mean 0.5 --range 0,1 --margin 0.01", folder).status, 1);
  EXPECT_EQ(judge("yes '0\n1'", "--mean 0.5 --range 0,1 --margin 0.05", folder).status, 0);
}

TEST(JudgeCommand, TheRecipeForPythonIsCertified) {
  const TemporaryFolder folder;
  write_file(folder / "draws.py", recipe("python"));
  const Result run = judge("python3 draws.py 2>/dev/null", "--mean 0.5 --range 0,1 --margin 0.02", folder);
  EXPECT_EQ(run.status, 0) << run.out << run.error;
}

TEST(JudgeCommand, TheRecipeForCIsCertified) {
  const TemporaryFolder folder;
  write_file(folder / "draws.c", recipe("c"));
  ASSERT_EQ(shell("cc draws.c -o draws", folder).status, 0);
  const Result run = judge("./draws", "--mean 0.5 --range 0,1 --margin 0.005 --format f64", folder);
  EXPECT_EQ(run.status, 0) << run.out << run.error;
}

TEST(JudgeCommand, ABadDrawIsBiasedAndAWordIsBadInput) {
  const TemporaryFolder folder;
  const Result bad = judge("printf '0.5\\nnan\\n'", "--mean 0.5 --range 0,1", folder);
  EXPECT_EQ(bad.status, 1);
  EXPECT_THAT(bad.out, HasSubstr("draw 1 is nan"));
  const Result word = judge("printf '0.5\\nabc\\n'", "--mean 0.5 --range 0,1", folder);
  EXPECT_EQ(word.status, 2);
  EXPECT_THAT(word.error, HasSubstr("line 2 of standard input holds \"abc\""));
  EXPECT_EQ(judge("printf '0.5\\n'", "--mean 0.5 --range 0,1", folder).status, 3);
}

TEST(JudgeCommand, WritesJson) {
  const TemporaryFolder folder;
  EXPECT_EQ(judge("yes 0.25", "--mean 0.5 --range 0,1 --json f.json", folder).status, 1);
  const auto json = nlohmann::json::parse(read_file(folder / "f.json"));
  EXPECT_EQ(json["verdict"], "biased");
  EXPECT_EQ(json["bias"], -0.5);
}

TEST(JudgeCommand, RefusesBadOptions) {
  expect_bad_input("judge < /dev/null", "exactly one");
  expect_bad_input("judge --mean 0.5 --uniform < /dev/null", "exactly one");
  expect_bad_input("judge --mean 0.5 < /dev/null", "no numbers");
  expect_bad_input("judge --mean 0 --range -1,1 < /dev/null", "--scale");
  expect_bad_input("judge --mean 0.5 --range 1,0 < /dev/null", "ascend");
  expect_bad_input("judge --mean 0.5 --rnage 0,1 < /dev/null", "did you mean --range?");
  expect_bad_input("judge --mean nan < /dev/null", "--mean");
  expect_bad_input("judge --uniform --format f46 < /dev/null", "f64");
  expect_bad_input("judge --law absent.csv < /dev/null", "absent.csv");
  expect_bad_input("judge --mean 0.5 --columns 2 < /dev/null", "--columns");
}

TEST(PlanCommand, AnswersBothQuestions) {
  const TemporaryFolder folder;
  const std::string draws = "plan --mean 0.5 --range 0,1 --deviation 0.3 ";
  EXPECT_EQ(fairlight(draws + "--margin 1e-3 --json p.json", folder).status, 0);
  const auto json = nlohmann::json::parse(read_file(folder / "p.json"));
  EXPECT_LT(json["draws"]["expected"], json["draws"]["with_99_percent"]);
  EXPECT_THAT(fairlight(draws + "--draws 1e6", folder).out, HasSubstr("certify a margin of"));
  expect_bad_input(draws, "one of --margin and --draws");
  expect_bad_input("plan --mean 0.5 --range 0,1 --deviation 2 --margin 1e-3", "deviation");
}

}  // namespace
}  // namespace fairlight
