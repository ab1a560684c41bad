#include <cmath>

#include <Eigen/Core>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fairlight/estimators/density.h>
#include <fairlight/estimators/packet.h>
#include <fairlight/validation/audit/mutants.h>
#include <fairlight/validation/audit/mutation_values.h>

namespace fairlight {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// What a kind of operator makes of the lines of a source: each changed line.
std::vector<std::string> changes(const std::string& kind, const std::string& text) {
  std::vector<std::string> after;
  for (const Mutant& mutant : mutants_of("estimators/x.h", text, Operators::meaning)) {
    if (mutant.kind == kind) after.push_back(mutant.after);
  }
  return after;
}

// The same inside a function.
std::vector<std::string> changes_in(const std::string& signature, const std::string& kind,
                                    const std::string& line) {
  return changes(kind, signature + " {\n  " + line + "\n}\n");
}

TEST(MutantsOfMeaning, ClampWhatIsReturnedOrAdded) {
  EXPECT_THAT(changes_in("Real f(Real x)", "clamp", "return x / y;"),
              ElementsAre("return mutation::at_most(x / y, 0.9);"));
  EXPECT_THAT(changes("clamp", "sum += x * y;"), ElementsAre("sum += mutation::at_most(x * y, 3);"));
  EXPECT_THAT(changes_in("std::string f()", "clamp", "return text;"), IsEmpty());
}

TEST(MutantsOfMeaning, PutAFloorUnderADivisor) {
  EXPECT_THAT(changes("floor", "x = a / (d * d);"), ElementsAre("x = a / mutation::at_least((d * d), 0.1);"));
  EXPECT_THAT(changes("floor", "x = a / lens.area();"),
              ElementsAre("x = a / mutation::at_least(lens.area(), 0.1);"));
  EXPECT_THAT(changes("floor", "x = a / Real(2);"), IsEmpty());
}

TEST(MutantsOfMeaning, DropATerm) {
  EXPECT_THAT(changes("term", "x = a + b * c;"), ElementsAre("x = b * c;", "x = a;"));
  EXPECT_THAT(changes("term", "x = Real(1) - f(u.x());"), ElementsAre("x = Real(1);"));
}

TEST(MutantsOfMeaning, DropAFactorSuchAsACosine) {
  EXPECT_THAT(changes("factor", "x = a * w.z();"), ElementsAre("x = w.z();", "x = a;"));
  EXPECT_THAT(changes("factor", "x = a / q;"), ElementsAre("x = a;"));
}

TEST(MutantsOfMeaning, SwapArgumentsChannelsAndCoordinates) {
  EXPECT_THAT(changes("swap", "f(a, b(c));"), ElementsAre("f(b(c), a);"));
  EXPECT_THAT(changes("swap", "f(a, b, c);"), ElementsAre("f(b, a, c);", "f(a, c, b);"));
  EXPECT_THAT(changes("swap", "x = albedo[2];"), ElementsAre("x = albedo[1];"));
  EXPECT_THAT(changes("swap", "x = w.y();"), ElementsAre("x = w.x();"));
  EXPECT_THAT(changes("swap", "x = min(a, b);"), IsEmpty()) << "it is the same";
}

TEST(MutantsOfMeaning, UseARandomNumberTwice) {
  EXPECT_THAT(changes("reuse", "f(u.y());"), ElementsAre("f(u.x());"));
  EXPECT_THAT(changes("reuse", "return {first, source.next()};"), ElementsAre("return {first, first};"));
}

TEST(MutantsOfMeaning, TakeABoundOffByOne) {
  EXPECT_THAT(changes("bound", "for (int i = 0; i < n_; ++i) {"),
              ElementsAre("for (int i = 1; i < n_; ++i) {", "for (int i = 0; i < n_ - 1; ++i) {"));
  EXPECT_THAT(changes("bound", "x = table[k + 1];"), ElementsAre("x = table[k];"));
}

TEST(MutantsOfMeaning, TakeABranchNeverOrInAPartOfItsRange) {
  EXPECT_THAT(changes("branch", "if (x > y) z = 1;"),
              ElementsAre("if (false) z = 1;", "if (x > mutation::raised(y)) z = 1;"));
  EXPECT_THAT(changes("branch", "return select(m, a, b);"),
              ElementsAre("return mutation::always(m, a, b);", "return mutation::never(m, a, b);",
                          "return mutation::partly(m, a, b);"));
  EXPECT_THAT(
      changes("branch", "return select(f(m), Real(0), b);"),
      ElementsAre("return mutation::always(f(m), Real(0), b);", "return mutation::never(f(m), Real(0), b);"))
      << "a constant is always in its part";
  EXPECT_THAT(changes("branch", "if (!any(alive)) return alive;"), IsEmpty()) << "it only saves time";
}

TEST(MutantsOfMeaning, ChangeASampleWithoutItsDensity) {
  EXPECT_THAT(changes_in("Real sample(Real x)", "sample", "return f(u.x());"),
              ElementsAre("return f(mutation::scaled(u.x(), 0.9));"));
  EXPECT_THAT(changes_in("Real invert(Real x)", "sample", "return f(u.x());"), IsEmpty());
}

TEST(MutantsOfMeaning, ChangeADensityWithoutItsSample) {
  EXPECT_THAT(changes_in("Real pdf(Real x) const", "pdf", "return x * y;"),
              ElementsAre("return mutation::scaled(x * y, 1.1);"));
  EXPECT_THAT(changes_in("Real reflected_pdf(Real x)", "pdf", "return Density<M, Real>(f(x))"),
              ElementsAre("return Density<M, Real>(mutation::scaled((f(x)), 1.1))"));
  EXPECT_THAT(changes_in("Real sample(Real x)", "pdf", "return x * y;"), IsEmpty());
}

TEST(MutantsOfMeaning, ChangeAProbabilityWithoutItsWeight) {
  EXPECT_THAT(changes("probability", "return {u < q, Real(1) / q};"),
              ElementsAre("return {u < mutation::scaled(q, 0.9), Real(1) / q};"));
  EXPECT_THAT(changes("probability", "return x / pick.probability;"),
              ElementsAre("return x / mutation::scaled(pick.probability, 0.9);"));
}

TEST(MutantsOfMeaning, SumInFloats) {
  EXPECT_THAT(changes_in("double f()", "float", "double sum = 0;"), ElementsAre("float sum = 0;"));
  EXPECT_THAT(changes("float", "struct X {\n  double sum = 0;\n};"), IsEmpty()) << "other objects share the layout";
}

TEST(MutantsOfMeaning, DoNotResetAState) {
  EXPECT_THAT(changes_in("void f()", "state", "next_ = 0;"), ElementsAre(";"));
  EXPECT_THAT(changes_in("void f()", "state", "x.depth = select(begins, Real(0), x.depth);"), ElementsAre(";"));
  EXPECT_THAT(changes_in("void f()", "state", "rows_.clear();"), ElementsAre(";"));
  EXPECT_THAT(changes_in("void f()", "state", "const int n = 0;"), IsEmpty());
}

TEST(MutantsOfMeaning, KnowTheFunctionAroundThem) {
  const std::string text = "int f(int a,\n      int b) {\n  return a + b;\n}\n\nint c = d + e;\n";
  const auto mutants = mutants_of("estimators/x.h", text, Operators::slips);
  ASSERT_EQ(mutants.size(), 2);
  EXPECT_EQ(mutants[0].first_line, 1);
  EXPECT_EQ(mutants[0].last_line, 4);
  EXPECT_EQ(mutants[1].first_line, 6);
  EXPECT_EQ(mutants[1].last_line, 6);
}

TEST(MutantsOfMeaning, LeaveAloneCodeForWideInstructionSets) {
  EXPECT_THAT(changes("factor", "#if defined(__AVX2__)\nx = a * b;\n#else\nx = c / d;\n#endif\n"),
              ElementsAre("x = c;"));
  EXPECT_THAT(changes("factor", "#if !defined(__AVX__)\nx = c / d;\n#endif\n"), ElementsAre("x = c;"));
}

TEST(MutationValues, ChangeNumbersVectorsAndDensities) {
  EXPECT_EQ(mutation::at_most(2.0, 0.9), 0.9);
  EXPECT_EQ(mutation::at_most(0.5, 0.9), 0.5);
  EXPECT_EQ(mutation::at_least(0.01, 0.1), 0.1);
  const Eigen::Array3d colour(0.5, 2, 4);
  EXPECT_TRUE((mutation::at_most(colour * 2, 3) == Eigen::Array3d(1, 3, 3)).all());
  const Density<SolidAngle, double> density(2);
  EXPECT_EQ(mutation::scaled(density, 1.5).value(), 3);
}

TEST(MutationValues, ChangePackets) {
  std::array<double, lanes<Packet>> values{};
  store_lanes(mutation::at_most(Packet(2.0f), 0.5), values.data());
  EXPECT_EQ(values[0], 0.5);
  store_lanes(mutation::partly(Packet(1.0f) > Packet(0.0f), Packet(0.75f), Packet(7.0f)), values.data());
  EXPECT_EQ(values[0], 7);
}

TEST(MutationValues, LeaveTheRestAlone) {
  EXPECT_EQ(mutation::at_most(7, 0.9), 7);
  EXPECT_EQ(mutation::at_least(std::string("a"), 0.9), "a");
}

TEST(MutationValues, MoveThresholds) {
  EXPECT_DOUBLE_EQ(mutation::raised(1.0), 1.8);
  EXPECT_DOUBLE_EQ(mutation::lowered(0.0), -0.3);
  EXPECT_EQ(mutation::raised(4), 5);
  EXPECT_EQ(mutation::lowered(4), 3);
}

TEST(MutationValues, TakeBranches) {
  EXPECT_EQ(mutation::always(false, 1.0, 2.0), 1);
  EXPECT_EQ(mutation::never(true, 1.0, 2.0), 2);
  EXPECT_EQ(mutation::partly(true, 0.25, 2.0), 0.25);
  EXPECT_EQ(mutation::partly(true, 0.75, 2.0), 2);
  EXPECT_EQ(mutation::partly(false, 0.25, 2.0), 2);
}

TEST(OperatorsNamed, RefusesOthers) {
  EXPECT_EQ(operators_named("meaning"), Operators::meaning);
  EXPECT_THROW(operators_named("typos"), std::invalid_argument);
}

}  // namespace
}  // namespace fairlight
