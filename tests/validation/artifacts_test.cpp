#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <support/temporary_folder.h>

#include <fairlight/validation/report/artifacts.h>
#include <fairlight/validation/report/markdown.h>
#include <fairlight/validation/run/registry.h>

namespace fairlight {
namespace {

using testing::read_file;
using testing::TemporaryFolder;
using testing::write_file;

const RunOptions seen{.terms = {.seed = 3, .margin = 0.02}, .threads = 1, .evidence = true};

Outcome run(const std::string& claim) { return run_claims(select_claims({claim}), seen).front(); }

TEST(Artifacts, OfALawAreItsCellsAndTheirPictures) {
  const TemporaryFolder folder;
  const auto pictures = write_artifacts(folder / "new", run("hemisphere.cosine.law"), seen);
  EXPECT_EQ(pictures.size(), 2u);
  for (const std::string& picture : pictures) EXPECT_TRUE(read_file(picture).starts_with("\x89PNG")) << picture;
  const std::string csv = read_file(folder / "new/hemisphere.cosine.law/cells.csv");
  EXPECT_EQ(std::ranges::count(csv, '\n'), 1 + 20 * 8);  // of 16 rows, the four with most mass are halved
  EXPECT_TRUE(read_file(folder / "new/hemisphere.cosine.law/cells.exr").starts_with("\x76\x2f\x31\x01"));
  const auto json = nlohmann::json::parse(read_file(folder / "new/hemisphere.cosine.law/finding.json"));
  EXPECT_EQ(json["name"], "hemisphere.cosine.law");
  EXPECT_EQ(json["verdict"], "certified");
  EXPECT_TRUE(json.contains("statement") && json.contains("replay"));
}

TEST(Artifacts, OfAMeanAreTheCourseOfItsTest) {
  const TemporaryFolder folder;
  const Outcome outcome = run("pick.one.dice");
  const auto pictures = write_artifacts(folder.path().string(), outcome, seen);
  EXPECT_FALSE(pictures.empty());
  EXPECT_LE(pictures.size(), 3u);
  const std::string csv = read_file(folder / "pick.one.dice/wealth.csv");
  EXPECT_TRUE(csv.starts_with("channel,draws,mean,log_above_reference,"));
  EXPECT_NE(csv.find("0," + std::to_string(outcome.evidence.means[0].steps().back().draws) + ","),
            std::string::npos);
}

TEST(Artifacts, OfTilesAreAMapOfTheirBiases) {
  const TemporaryFolder folder;
  const Outcome outcome = run("cornell-original.paired.mis.quarters.packet");
  ASSERT_EQ(outcome.evidence.tiles.columns, 2);
  ASSERT_EQ(outcome.evidence.tiles.biases.size(), 4u);
  for (const double bias : outcome.evidence.tiles.biases) EXPECT_LT(std::abs(bias), 1);
  const auto pictures = write_artifacts(folder.path().string(), outcome, seen);
  EXPECT_EQ(pictures.front(), folder / "cornell-original.paired.mis.quarters.packet/tiles.png");
  EXPECT_TRUE(
      read_file(folder / "cornell-original.paired.mis.quarters.packet/tiles.exr").starts_with("\x76\x2f\x31\x01"));
}

TEST(Intervals, OfAllClaimsAreAPictureAndItsScript) {
  const TemporaryFolder folder;
  const Outcome outcome{
      &registry()[0], {Verdict::certified, Guarantee::exact, 0.02, 0, {-infinity<double>, 0.01}}, 1};
  EXPECT_EQ(write_intervals(folder / "new", {outcome}), folder / "new/intervals.png");
  EXPECT_TRUE(read_file(folder / "new/intervals.png").starts_with("\x89PNG"));
  EXPECT_NE(read_file(folder / "new/intervals.gp").find(registry()[0].name + " certified -2 0.5\n"),
            std::string::npos);
}

TEST(Artifacts, AreRefusedAFolderThatCannotHoldThem) {
  const TemporaryFolder folder;
  write_file(folder / "file", "");
  EXPECT_THROW(check_folder(folder / "file"), std::runtime_error);
  EXPECT_THROW(check_folder(folder / "none/new"), std::runtime_error);
  EXPECT_NO_THROW(check_folder(folder / "new"));
  EXPECT_NO_THROW(check_folder(folder.path().string()));
  EXPECT_EQ(folder.files(), 1) << "nothing is left behind";
}

TEST(Markdown, ShowsAFailureWithItsPictureByARelativeLink) {
  const TemporaryFolder folder;
  Outcome wrong = run("pick.one.dice");
  wrong.finding.verdict = Verdict::biased;
  wrong.finding.note = "why so";
  const std::vector<Outcome> outcomes{run("importance.cosine"), wrong};
  const auto pictures = write_artifacts(folder / "seen", wrong, seen);
  const std::vector<ComponentOutcome> components{{"Mirror", "sse2", 3, Verdict::certified, false, 2e-4}};
  const std::string page = markdown({outcomes,
                                     components,
                                     seen,
                                     2,
                                     "again and again",
                                     write_intervals(folder / "seen", outcomes),
                                     {{"pick.one.dice", pictures}}},
                                    folder / "report.md");
  EXPECT_TRUE(page.starts_with("# fairlight verify: biased\n")) << page;
  for (const char* text : {"## pick.one.dice: biased", "why so", "(seen/pick.one.dice/wealth",
                           "(seen/intervals.png)", "fairlight verify pick.one.dice --seed 0000000000000003-",
                           "again and again", "| importance.cosine.cosine_squared | certified |",
                           "| Mirror | sse2 | 3 | certified | below 2.0e-04 |", "`0000000000000003`"}) {
    EXPECT_NE(page.find(text), std::string::npos) << text << "\n" << page;
  }
  EXPECT_NE(page.find("is between "), std::string::npos) << page;
  EXPECT_EQ(page.find("## importance.cosine"), std::string::npos);
  const std::string plain = markdown({outcomes, {}, seen, 2, "again", "", {}}, folder / "report.md");
  EXPECT_NE(plain.find("## pick.one.dice: biased"), std::string::npos) << "a failure is shown without pictures too";
  EXPECT_EQ(plain.find("]("), std::string::npos) << plain;
}

TEST(Markdown, SaysOnWhichSideAnIntervalIsOpen) {
  const auto page_of = [](Interval interval) {
    const std::vector<Outcome> outcomes{
        {&registry()[0], {Verdict::biased, Guarantee::exact, 0.02, 0, interval}, 1}};
    return markdown({outcomes, {}, seen, 2, "again", "", {}}, "report.md");
  };
  const auto holds = [](const std::string& page, const std::string& part) {
    EXPECT_NE(page.find(part), std::string::npos) << page;
  };
  holds(page_of({-infinity<double>, 0.01}), "is at most +1.00e-02, the margin");
  holds(page_of({-infinity<double>, 0.01}), "| open | +1.00e-02 |");
  holds(page_of({-0.01, infinity<double>}), "is at least -1.00e-02, the margin");
  holds(page_of({-0.01, 0.02}), "is between -1.00e-02 and +2.00e-02, the margin");
  holds(page_of({-infinity<double>, infinity<double>}), "is not known yet, the margin");
}

}  // namespace
}  // namespace fairlight
