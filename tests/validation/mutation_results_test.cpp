#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/temporary_folder.h>

#include <fairlight/validation/audit/mutation_results.h>

namespace fairlight {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using testing::TemporaryFolder;
using testing::write_file;

// Five mutants of one line, and a fate of each kind.
struct FiveMutants {
  explicit FiveMutants(const std::string& path = "") : results(path) {
    using Kind = Fate::Kind;
    for (const Kind kind :
         {Kind::killed, Kind::killed_by_tests, Kind::survived, Kind::equivalent, Kind::no_program}) {
      Mutant mutant;
      mutant.file = "stats/x.h";
      mutant.kind = "clamp";
      mutant.line = static_cast<int>(mutants.size()) + 1;
      mutant.before = "line " + std::to_string(mutants.size());
      mutants.push_back(mutant);
      results.add(mutant, {kind, "why"});
    }
  }

  MutationResults results;
  std::vector<Mutant> mutants;
};

TEST(MutationResults, AreCountedByFate) {
  const FiveMutants run;
  const MutationCounts counts = counts_of(run.mutants, run.results);
  EXPECT_EQ(counts.killed(), 2);
  EXPECT_EQ(counts.killed_by_claims, 1);
  EXPECT_DOUBLE_EQ(counts.percent_killed(), 200.0 / 3);
  EXPECT_DOUBLE_EQ(counts.percent_killed_by_claims(), 100.0 / 3);
  EXPECT_THAT(summary(counts), HasSubstr("2 of 3 mutants killed (66.7 %): 1 by claims (33.3 %), 1 by tests only"));
}

TEST(MutationResults, AreWrittenAsJson) {
  const FiveMutants run;
  const nlohmann::json json = mutation_json(run.mutants, run.results, "5eed");
  EXPECT_EQ(json["mutants"], 5);
  EXPECT_EQ(json["killed"], 2);
  EXPECT_EQ(json["killed_by_claims"], 1);
  EXPECT_EQ(json["killed_by_tests_only"], 1);
  EXPECT_EQ(json["survived"], 1);
  EXPECT_EQ(json["equivalent"], 1);
  EXPECT_EQ(json["kinds"]["clamp"]["no_program"], 1);
  ASSERT_EQ(json["survivors"].size(), 1);
  EXPECT_EQ(json["survivors"][0]["line"], 3);
  ASSERT_EQ(json["tests_only"].size(), 1);
  EXPECT_EQ(json["tests_only"][0]["before"], "line 1");
}

TEST(MutationResults, ShowOnAPageWhatNoClaimNoticed) {
  const FiveMutants run;
  const std::string page = mutation_page(run.mutants, run.results, "audit");
  EXPECT_THAT(page, HasSubstr("`stats/x.h`, line 2 (clamp), noticed by why"));
  EXPECT_THAT(page, HasSubstr("line 3 (clamp), noticed by nothing in why"));
  EXPECT_THAT(page, Not(HasSubstr("line 1 ")));
}

TEST(MutationResults, AreReadAgain) {
  const TemporaryFolder folder;
  const FiveMutants run(folder / "a.jsonl");
  const MutationResults again(folder / "a.jsonl");
  EXPECT_EQ(again.fate(run.mutants[1]).kind, Fate::Kind::killed_by_tests);
  write_file(folder / "b.jsonl", "{}\n");
  EXPECT_THROW(MutationResults(folder / "b.jsonl"), std::runtime_error);
}

}  // namespace
}  // namespace fairlight
