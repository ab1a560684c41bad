#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fairlight/render/nearest_names.h>

namespace fairlight {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(EditsToBeginning, CountsInsertedDeletedReplacedAndSwappedLetters) {
  EXPECT_EQ(edits_to_beginning("render", "render"), 0u);
  EXPECT_EQ(edits_to_beginning("rendr", "render"), 1u);
  EXPECT_EQ(edits_to_beginning("rrender", "render"), 1u);
  EXPECT_EQ(edits_to_beginning("ronder", "render"), 1u);
  EXPECT_EQ(edits_to_beginning("redner", "render"), 1u);
  EXPECT_EQ(edits_to_beginning("xxender", "render"), 2u);
  EXPECT_EQ(edits_to_beginning("RENDER", "render"), 0u);
}

TEST(EditsToBeginning, CountsNoneForWhatTheWordLeavesOffAtTheEnd) {
  EXPECT_EQ(edits_to_beginning("cornel", "cornell-simple"), 0u);
  EXPECT_EQ(edits_to_beginning("cornell-simple", "cornel"), 8u);
}

TEST(EditsToBeginning, CountsOneForFirstPartsThatTheWordLeavesOff) {
  EXPECT_EQ(edits_to_beginning("cosine.law", "hemisphere.cosine.law"), 1u);
  EXPECT_EQ(edits_to_beginning("law", "hemisphere.cosine.law"), 1u);
  EXPECT_EQ(edits_to_beginning("conductor", "rough_conductor"), 1u);
  EXPECT_EQ(edits_to_beginning("osine.law", "hemisphere.cosine.law"), 2u);
}

TEST(EditsToBeginning, TakesAPattern) {
  EXPECT_EQ(edits_to_beginning("pick.*.dize", "pick.one.dice"), 1u);
  EXPECT_EQ(edits_to_beginning("p?ck.on?", "pick.one.dice"), 0u);
  EXPECT_EQ(edits_to_beginning("*", "pick"), 0u);
}

RC_GTEST_PROP(EditsToBeginning, IsAtMostOneAfterOneEdit,
              (const std::string& front, const std::string& back, char letter)) {
  const std::string name = front + back + ".more";
  RC_ASSERT(edits_to_beginning(front + back, name) == 0u);
  RC_ASSERT(edits_to_beginning(front + letter + back, name) <= 1u);
}

TEST(Alternatives, AreListedWithAnOr) {
  EXPECT_EQ(alternatives({"a"}), "a");
  EXPECT_EQ(alternatives({"a", "b"}), "a or b");
  EXPECT_EQ(alternatives({"a", "b", "c"}), "a, b or c");
}

TEST(NearestNames, AreTheNearestFirstAndNoneThatIsFar) {
  const std::vector<std::string> names{"ledger", "merge", "render", "scenes", "verify"};
  EXPECT_THAT(nearest_names("rendr", names), ElementsAre("render"));
  EXPECT_THAT(nearest_names("nothing", names), IsEmpty());
  EXPECT_THAT(nearest_names("", {"render"}), ElementsAre("render"));
}

TEST(NearestNames, PutTheShorterOfTwoEqualBeginningsFirst) {
  EXPECT_THAT(nearest_names("hemisphre", {"hemisphere.cosine.law", "hemisphere", "hemisphere.cosine"}),
              ElementsAre("hemisphere", "hemisphere.cosine", "hemisphere.cosine.law"));
}

TEST(NearestNames, AreAtMostFiveAndEachOnce) {
  EXPECT_THAT(nearest_names("a", {"a6", "a5", "a6", "a4", "a3", "a2", "a1"}),
              ElementsAre("a6", "a5", "a4", "a3", "a2"));
}

TEST(NearestNames, AreNotMuchFartherThanTheNearest) {
  EXPECT_THAT(nearest_names("estimators/cane.h", {"estimators/lone.h", "estimators/cone.h", "estimators/lens.h"}),
              ElementsAre("estimators/cone.h", "estimators/lone.h"));
}

TEST(NearestNames, CompareOptionsWithoutTheirDashes) {
  const std::vector<std::string> options{"--direct", "--bounce", "--png", "-o"};
  EXPECT_THAT(nearest_names("--bounc", options), ElementsAre("--bounce"));
  EXPECT_THAT(nearest_names("-bounce", options), ElementsAre("--bounce"));
  EXPECT_THAT(nearest_names("-p", options), ElementsAre("--png"));
  EXPECT_THAT(nearest_names("--xyz", options), IsEmpty());
}

TEST(DidYouMean, NamesTheNearestAndWhereAllAre) {
  EXPECT_EQ(did_you_mean("b", {"b1"}, "fairlight scenes"), "(did you mean b1? see fairlight scenes)");
  EXPECT_EQ(did_you_mean("b", {"b1", "b2"}, "x"), "(did you mean b1 or b2? see x)");
  EXPECT_EQ(did_you_mean("b", {"b1", "b2", "b3"}, "x"), "(did you mean b1, b2 or b3? see x)");
  EXPECT_EQ(did_you_mean("b", {"c"}, "fairlight scenes"), "(see fairlight scenes)");
}

}  // namespace
}  // namespace fairlight
