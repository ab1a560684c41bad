#include <algorithm>
#include <filesystem>
#include <limits>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/temporary_folder.h>

#include <fairlight/validation/studies/study_page.h>

namespace fairlight {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using testing::read_file;
using testing::TemporaryFolder;

constexpr double infinite = std::numeric_limits<double>::infinity();

const Study study{"fig9", "A title", "the paper, 9", 1, nullptr};

json example() {
  StudyResult result;
  result.text = "What it shows.";
  StudyTable table{"gains", "What the columns are.", {{"strategy"}, {"gain", true}, {"closed form"}}, {}};
  table.rows = {{"implicit", Measured{24.5, {22.25, 26.75}}, 25.0},
                {"explicit", Measured{1, {-infinite, infinite}}, 2e5}};
  result.tables.push_back(table);
  result.pictures.push_back({"fig9.png", "A caption"});
  return study_json(study, {.folder = "", .seed = 0xAB}, result);
}

TEST(StudyPage, JsonHasEveryRatioWithItsInterval) {
  const json cell = example()["tables"][0]["rows"][0][1];
  EXPECT_EQ(cell, (json{{"value", 24.5}, {"interval", {22.25, 26.75}}}));
  EXPECT_EQ(example()["seed"], "00000000000000ab");
}

TEST(StudyPage, AnOpenEndIsNull) {
  EXPECT_TRUE(example()["tables"][0]["rows"][1][1]["interval"][0].is_null());
  EXPECT_THAT(study_markdown(example()), HasSubstr("1 [open, open]"));
}

TEST(StudyPage, MarksWhatDependsOnTheClock) {
  EXPECT_EQ(example()["tables"][0]["columns"][1], (json{{"name", "gain"}, {"clock", true}}));
  EXPECT_THAT(study_markdown(example()), HasSubstr("| strategy | gain * | closed form |"));
}

TEST(StudyPage, MarkdownHasTablesPicturesAndTheCommand) {
  const std::string page = study_markdown(example());
  EXPECT_THAT(page, HasSubstr("| implicit | 24.5 [22.25, 26.75] | 25 |"));
  EXPECT_THAT(page, HasSubstr("![A caption](fig9.png)"));
  EXPECT_THAT(page, HasSubstr("fairlight study fig9 --seed 00000000000000ab --out DIR"));
}

TEST(StudyPage, CsvHasColumnsForTheEnds) {
  EXPECT_EQ(table_csv(example()["tables"][0]),
            "\"strategy\",\"gain\",\"gain_lo\",\"gain_hi\",\"closed form\"\n"
            "\"implicit\",24.5,22.25,26.75,25.0\n"
            "\"explicit\",1.0,,,200000.0\n");
}

TEST(StudyPage, WritesTheJsonAfterAllElse) {
  const TemporaryFolder folder;
  write_study(folder.path().string(), example());
  EXPECT_EQ(json::parse(read_file(folder / "fig9.json")), example());
  EXPECT_EQ(read_file(folder / "fig9.md"), study_markdown(example()));
  EXPECT_EQ(read_file(folder / "fig9-gains.csv"), table_csv(example()["tables"][0]));
}

TEST(Studies, HaveNamesOfTheirOwn) {
  std::set<std::string> names{"all"};
  for (const Study& each : studies()) EXPECT_TRUE(names.insert(each.name).second) << each.name;
}

TEST(Studies, AnUnknownNameIsAnsweredWithTheNearest) {
  try {
    static_cast<void>(study_named("fgi2"));
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("did you mean fig2"));
  }
}

// Whoever edits a page by hand, or commits half of a run, is found out.
TEST(Studies, CommittedPagesAreThoseOfTheirJson) {
  const std::filesystem::path folder = std::filesystem::path(FAIRLIGHT_SOURCE_DIR) / "docs/studies";
  for (const Study& each : studies()) {
    const json page = json::parse(read_file((folder / (std::string(each.name) + ".json")).string()));
    EXPECT_EQ(read_file((folder / (std::string(each.name) + ".md")).string()), study_markdown(page)) << each.name;
    for (const json& table : page.at("tables")) {
      const std::string file = std::string(each.name) + "-" + table.at("name").get<std::string>() + ".csv";
      EXPECT_EQ(read_file((folder / file).string()), table_csv(table)) << file;
    }
    for (const json& picture : page.at("pictures"))
      EXPECT_TRUE(std::filesystem::exists(folder / picture.at("file").get<std::string>()));
  }
}

}  // namespace
}  // namespace fairlight
