#include <algorithm>
#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fairlight/stats/text.h>
#include <fairlight/validation/audit/known_equivalents.h>

namespace fairlight {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

std::vector<std::string> changes(const std::string& line) {
  std::vector<std::string> after;
  for (const Mutant& mutant : mutants_of("estimators/x.h", line, Operators::slips)) after.push_back(mutant.after);
  return after;
}

TEST(Mutants, ChangeOneOperatorEach) {
  EXPECT_THAT(changes("  return a + b * c;"), ElementsAre("return a - b * c;", "return a + b / c;"));
  EXPECT_THAT(changes("x += y;"), ElementsAre("x -= y;"));
  EXPECT_THAT(changes("x /= y;"), ElementsAre("x *= y;"));
}

TEST(Mutants, TurnComparisonsRoundAndLogicOver) {
  EXPECT_THAT(changes("a < b && c >= d"), ElementsAre("a > b && c >= d", "a < b || c >= d", "a < b && c <= d"));
}

TEST(Mutants, MakeConstantsTwoPercentLarger) {
  EXPECT_THAT(changes("Real(2)"), ElementsAre("Real(2.04)"));
  EXPECT_THAT(changes("Real(50)"), ElementsAre("Real(51)"));
  EXPECT_THAT(changes("Real(0)"), ElementsAre("Real(0.02)"));
  EXPECT_THAT(changes("pi<Real>"), ElementsAre("(Real(1.02) * pi<Real>)"));
}

TEST(Mutants, TakeAnotherCosine) {
  EXPECT_THAT(changes("w.z()"), ElementsAre("w.x()"));
  EXPECT_THAT(changes("cos(phi)"), ElementsAre("sin(phi)"));
}

TEST(Mutants, DropSignsAndExchangeExtremes) {
  EXPECT_THAT(changes("return -x;"), ElementsAre("return x;"));
  EXPECT_THAT(changes("min(a, -b)"), ElementsAre("max(a, -b)", "min(a, b)"));
}

TEST(Mutants, LeaveAloneWhatIsNoArithmetic) {
  EXPECT_THAT(changes("// a + b"), IsEmpty());
  EXPECT_THAT(changes("f(\"a + b\");"), IsEmpty());
  EXPECT_THAT(changes("#if A < B"), IsEmpty());
  EXPECT_THAT(changes("template <class Real>"), IsEmpty());
  EXPECT_THAT(changes("if (!(a > b)) throw std::invalid_argument(\"\");"), IsEmpty());
  EXPECT_THAT(changes("if (!(a > b))\n  throw std::invalid_argument(\"\");"), IsEmpty());
  EXPECT_THAT(
      changes("inside = inside && a > b &&\n  c > d;\nif (!all(inside)) {\n  throw std::invalid_argument(\"\");"),
      IsEmpty());
}

TEST(Mutants, ChangeMasksThatNoCheckIsAbout) {
  EXPECT_THAT(changes("alive = alive && a > b;\nif (!all(right))\n  throw std::invalid_argument(\"\");\nx + y;"),
              ElementsAre("alive = alive || a > b;", "alive = alive && a < b;", "x - y;"));
}

TEST(Mutants, AreNamedByTheirPlaceAndChange) {
  const std::string text = "x;\n  a - b;\n";
  const Mutant mutant = mutants_of("estimators/x.h", text, Operators::slips).at(0);
  EXPECT_EQ(mutant.name(), "estimators/x.h:2:5 a - b; => a + b;");
  EXPECT_EQ(mutated(text, mutant), "x;\n  a + b;\n");
}

TEST(Mutants, AreSampledBySeed) {
  const auto all = mutants_of("x.h", "a + b + c + d + e + f + g + h", Operators::slips);
  const auto names = [&](std::size_t n, std::uint64_t seed) {
    std::vector<std::string> chosen;
    for (const Mutant& mutant : sample_of(all, n, seed)) chosen.push_back(mutant.name());
    return chosen;
  };
  EXPECT_EQ(all.size(), 7);
  EXPECT_EQ(names(3, 1).size(), 3);
  EXPECT_EQ(names(3, 1), names(3, 1));
  EXPECT_NE(names(3, 1), names(3, 2));
  std::vector<std::string> more = names(5, 1);
  more.resize(3);
  EXPECT_EQ(names(3, 1), more);
  EXPECT_EQ(names(100, 1).size(), 7);
}

std::vector<Mutant> mutants_in(const std::string& file) {
  std::ifstream stream(FAIRLIGHT_SOURCE_DIR "/" + file);
  return mutants_of(file, {std::istreambuf_iterator<char>(stream), {}});
}

TEST(Mutants, AreSampledKindByKind) {
  const auto all = mutants_of("x.h", "a + b + c + d + e + f + g + h < i", Operators::slips);
  std::vector<std::string> kinds;
  for (const Mutant& mutant : sample_of(all, 2, 1)) kinds.push_back(mutant.kind);
  EXPECT_THAT(kinds, UnorderedElementsAre("operator", "order"));
}

TEST(Mutants, AreFoundInTheKitItself) { EXPECT_GT(mutants_in("estimators/cone.h").size(), 5); }

// Of a line that has changed nothing is known, and its row is to go.
TEST(Mutants, AreKnownToBeEquivalentByLinesThatStand) {
  const auto known = [](const std::string& file) {
    return std::ranges::count_if(mutants_in(file), [](const Mutant& m) { return !known_equivalence(m).empty(); });
  };
  for (const char* stem : {"gaussian_filter", "glossy", "inversion", "sphere_from_point"})
    EXPECT_EQ(known(formatted("estimators/%s.h", stem)), 1) << stem;
  EXPECT_EQ(known("estimators/ggx.h"), 2);
  EXPECT_EQ(known("render/sphere.h"), 1);
  EXPECT_EQ(known("estimators/cone.h"), 0);
}

}  // namespace
}  // namespace fairlight
