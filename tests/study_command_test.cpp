#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <support/program.h>

namespace fairlight {
namespace {

using nlohmann::json;
using testing::expect_bad_input;
using testing::fairlight;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::read_file;
using testing::Result;
using testing::TemporaryFolder;

TEST(StudyCommand, RefusesBadInputInOneSentence) {
  expect_bad_input("study fgi2 --out s", "did you mean fig2?");
  expect_bad_input("study --out s", "studies");
  expect_bad_input("study fig1", "--out");
  expect_bad_input("study fig1 --out ''", "--out");
  expect_bad_input("study fig1 --out s --seed x", "seed");
  expect_bad_input("study fig1 --out s --threads 0", "threads");
  expect_bad_input("study fig1 --out /proc/studies", "/proc/studies");
  expect_bad_input("study fig1 --out /dev/null", "/dev/null");
}

TEST(StudyCommand, HelpListsEveryStudy) {
  const TemporaryFolder folder;
  EXPECT_THAT(fairlight("study --help", folder).out, HasSubstr("montelight: "));
}

// All of its numbers come from the seed.
TEST(StudyCommand, TheSameSeedGivesTheSameStudy) {
  const TemporaryFolder folder;
  const Result first = fairlight("study fig1 --quick --seed 5 --out a", folder);
  ASSERT_EQ(first.status, 0) << first.error;
  ASSERT_EQ(fairlight("study fig1 --quick --seed 5 --out b", folder).status, 0);
  for (const char* file : {"fig1-variances.csv", "fig1.md", "fig1.gp", "fig1.png"})
    EXPECT_EQ(read_file(folder / (std::string("a/") + file)), read_file(folder / (std::string("b/") + file)))
        << file;
  EXPECT_THAT(first.out, HasSubstr("glossy, exponent 50"));
  EXPECT_THAT(read_file(folder / "a/fig1.md"), HasSubstr("![120 directions"));
  EXPECT_FALSE(std::filesystem::exists(folder / "a/unfinished.json"));
}

// The second study fails, as a folder is in the place of its picture. What was done stays, and is not
// done again.
TEST(StudyCommand, GoesOnWhereItWas) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "s/fig6-sheet.png");
  const std::string run = "study fig1 fig6 --quick --out s ";
  const Result broken = fairlight(run + "--seed 5", folder);
  EXPECT_EQ(broken.status, 2) << broken.error;
  EXPECT_THAT(broken.error, HasSubstr("fig6-sheet.png"));
  EXPECT_TRUE(std::filesystem::exists(folder / "s/fig1.json"));
  EXPECT_TRUE(std::filesystem::exists(folder / "s/unfinished.json"));

  std::filesystem::remove(folder / "s/fig6-sheet.png");
  const Result rest = fairlight(run, folder);
  EXPECT_EQ(rest.status, 0) << rest.error;
  EXPECT_THAT(rest.out, HasSubstr("fig1.md (done by an earlier run)"));
  EXPECT_THAT(rest.out, HasSubstr("seed 0000000000000005: s/fig6.md\n"));
  EXPECT_THAT(read_file(folder / "s/README.md"), HasSubstr("[fig6](fig6.md)"));
  EXPECT_FALSE(std::filesystem::exists(folder / "s/unfinished.json"));

  // A finished run is begun anew.
  const Result again = fairlight("study fig1 --quick --seed 6 --out s", folder);
  EXPECT_THAT(again.out, Not(HasSubstr("earlier run")));
}

}  // namespace
}  // namespace fairlight
