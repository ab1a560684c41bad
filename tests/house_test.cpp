#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/house.h>
#include <support/temporary_folder.h>

#include <fairlight/validation/run/registry.h>

namespace fairlight {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using testing::foreign_includes_in_stats;
using ::testing::HasSubstr;
using testing::includes_up_the_chain;
using ::testing::IsEmpty;
using testing::missing_tests_of_bad_input;
using testing::sections_without_component;
using testing::stale_non_components;
using testing::TemporaryFolder;
using testing::unregistered_components;
using testing::write_file;

std::set<std::string> registered() {
  std::set<std::string> subjects;
  for (const Claim& claim : registry()) subjects.insert(claim.subjects.begin(), claim.subjects.end());
  return subjects;
}

TEST(House, IncludesPointDownTheChain) { EXPECT_THAT(includes_up_the_chain(FAIRLIGHT_SOURCE_DIR), IsEmpty()); }

TEST(House, EveryComponentIsRegistered) {
  EXPECT_THAT(unregistered_components(FAIRLIGHT_SOURCE_DIR, registered()), IsEmpty());
}

TEST(House, HasNoSectionWithoutAComponent) {
  EXPECT_THAT(sections_without_component(FAIRLIGHT_SOURCE_DIR), IsEmpty());
}

TEST(House, KnowsWhyWhatIsNoComponentIsNone) {
  EXPECT_THAT(stale_non_components(FAIRLIGHT_SOURCE_DIR, registered()), IsEmpty());
}

TEST(House, StatsUsesTheStandardLibraryEigenAndBoostMath) {
  EXPECT_THAT(foreign_includes_in_stats(FAIRLIGHT_SOURCE_DIR), IsEmpty());
}

TEST(House, NoticesAForeignIncludeInStats) {
  const TemporaryFolder tree;
  write_file(tree / "stats/a.h",
             "#include <vector>\n#include <Eigen/Core>\n#include <boost/math/tools/roots.hpp>\n");
  EXPECT_THAT(foreign_includes_in_stats(tree.path()), IsEmpty());
  write_file(tree / "stats/b.h", "#include <nlohmann/json.hpp>\n");
  EXPECT_THAT(foreign_includes_in_stats(tree.path()), Contains("stats/b.h includes nlohmann/json.hpp"));
}

TEST(House, NoticesAnIncludeThatPointsUp) {
  const TemporaryFolder tree;
  write_file(tree / "stats/budget.h", "#include <fairlight/stats/verdict.h>\n");
  EXPECT_THAT(includes_up_the_chain(tree.path()), IsEmpty());
  write_file(tree / "stats/verdict.cpp", "#include <fairlight/estimators/vec.h>\n");
  EXPECT_THAT(includes_up_the_chain(tree.path()), Contains(HasSubstr("stats/verdict.cpp includes estimators")));
}

TEST(House, NoticesAQuotedInclude) {
  const TemporaryFolder tree;
  write_file(tree / "stats/verdict.cpp", "#include \"../render/film.h\"\n");
  EXPECT_THAT(includes_up_the_chain(tree.path()), Contains(HasSubstr("quoted")));
}

// A sampler with its claim, test and page, of which a test takes one away.
struct Registration {
  std::string comment = "/// Formula  p\n/// Measure  m\n/// Domain   d\n/// Random   u\n/// Source   s\n";
  std::string head = "template <class Real>\n";
  std::string test = "Disk";
  std::string docs = "## Disk\n";
  std::set<std::string> rows{"Disk"};

  std::vector<std::string> problems() const {
    const TemporaryFolder tree;
    write_file(tree / "estimators/disk.h",
               comment + head + "struct Disk {\n  P sample(U u) const;\n  D pdf(P x) const;\n};\n");
    write_file(tree / "tests/estimators/disk_test.cpp", test);
    write_file(tree / "docs/estimators.md", docs);
    return unregistered_components(tree.path(), rows);
  }
};

TEST(House, NoticesASamplerWithoutARegistryRow) {
  Registration registration;
  EXPECT_THAT(registration.problems(), IsEmpty());
  registration.rows = {"Dusk"};
  EXPECT_THAT(registration.problems(), Contains("Disk has no row in the registry"));
}

TEST(House, NoticesASamplerWithoutATest) {
  Registration registration;
  registration.test = "";
  EXPECT_THAT(registration.problems(), Contains("Disk has no test in tests/estimators/disk_test.cpp"));
}

TEST(House, NoticesASamplerWithoutASectionInTheDocs) {
  Registration registration;
  registration.docs = "## Disks\n";
  EXPECT_THAT(registration.problems(), Contains("Disk has no section in docs/estimators.md"));
}

// Whatever its methods are called, and without any: a function that has a mean is one.
TEST(House, TakesWhateverAHeaderDeclaresForAComponent) {
  const auto problems_with = [](const std::string& header) {
    const TemporaryFolder tree;
    write_file(tree / "estimators/disk.h", header);
    write_file(tree / "tests/estimators/disk_test.cpp", "");
    write_file(tree / "docs/estimators.md", "");
    return unregistered_components(tree.path(), {});
  };
  const std::string class_of = "Disk has no row in the registry", function_of = "disk has no row in the registry";
  EXPECT_THAT(problems_with("template <class Real>\nclass Disk {\n  Real area() const;\n};\n"), Contains(class_of));
  EXPECT_THAT(problems_with("class Disk final : public Shape,\n  public Area {\n};\n"), Contains(class_of));
  EXPECT_THAT(problems_with("template <class Real>\nReal disk(Real radius) {\n  return radius;\n}\n"),
              Contains(function_of));
  EXPECT_THAT(
      problems_with("template <class Real>\nconstexpr std::pair<Real, Real> disk(\n    Real radius) {\n}\n"),
      Contains(function_of));
  EXPECT_THAT(problems_with("inline constexpr auto disk = [](double radius) { return radius; };\n"),
              Contains(HasSubstr("disk")));
  EXPECT_THAT(problems_with("DISK(4) something\n"), Contains(HasSubstr("DISK(4) something has no row")))
      << "what it cannot read";
  EXPECT_THAT(problems_with("namespace detail {\nclass Disk {\n};\n}  // namespace detail\n"), IsEmpty());
  EXPECT_THAT(problems_with("namespace detail {\n}  // namespace detail\nclass Disk {\n};\n"), Contains(class_of));
}

TEST(House, NoticesASectionWithoutAComponent) {
  const TemporaryFolder tree;
  write_file(tree / "estimators/disk.h", "struct Disk {\n};\n");
  write_file(tree / "docs/estimators.md", "## Disk, Square\n");
  EXPECT_THAT(sections_without_component(tree.path()), ElementsAre("Square"));
}

TEST(House, ReadsTheCommentAboveATemplateOfSeveralLines) {
  Registration registration;
  registration.head = "template <class Real,\n          class Other>\n";
  EXPECT_THAT(registration.problems(), IsEmpty());
}

TEST(House, NoticesASamplerThatDoesNotNameItsMeasure) {
  Registration registration;
  registration.comment = "/// Formula  p\n/// Domain   d\n/// Random   u\n/// Source   s\n";
  EXPECT_THAT(registration.problems(), Contains("Disk has no field Measure"));
}

TEST(House, TestsWhatItSaysOfBadInput) { EXPECT_THAT(missing_tests_of_bad_input(FAIRLIGHT_SOURCE_DIR), IsEmpty()); }

TEST(House, NoticesALineOfBadInputWithoutItsTest) {
  const TemporaryFolder tree;
  write_file(tree / "docs/estimators.md", "\n# Bad input\n`Disk.RefusesNone`, `Disk.IsBlack`\n");
  write_file(tree / "tests/estimators/disk_test.cpp", "TEST(Disk, RefusesNone) {}\n");
  EXPECT_THAT(missing_tests_of_bad_input(tree.path()), ElementsAre("there is no test Disk.IsBlack"));
}

}  // namespace
}  // namespace fairlight
