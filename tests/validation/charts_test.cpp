#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/temporary_folder.h>

#include <fairlight/validation/report/charts.h>
#include <fairlight/validation/run/registry.h>

namespace fairlight {
namespace {

using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::read_file;
using ::testing::SizeIs;
using ::testing::StartsWith;
using testing::TemporaryFolder;
using testing::write_file;

using Rows = std::vector<std::string>;

// The rows of the nth data block of a script, from 0 on.
Rows rows_of(const std::string& script, int n = 0) {
  std::istringstream lines(script);
  Rows rows;
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    if (line == "EOD") {
      inside = false;
      --n;
    }
    if (inside && n == 0) rows.push_back(line);
    if (line.ends_with("<< EOD")) inside = true;
  }
  return rows;
}

std::string picture_of(const std::string& script) {
  const TemporaryFolder folder;
  return read_file(write_chart(folder / "chart", script));
}

// What the function says as it throws; nothing if it does not.
template <class Function>
std::string problem_of(const Function& function) {
  try {
    function();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

// 100 draws in 2 x 2 cells that expect 25 each: 40 are 15 / sqrt(100/4 x 3/4) = 3.46 deviations too many.
const Evidence::Cells cells{2, 2, {0.25, 0.25, 0.25, 0.25}, {40, 20, 25, 15}, 100};

Evidence::Cells uniform_cells(int rows, int columns, std::uint64_t count) {
  const auto n = static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns);
  return {rows, columns, std::vector<double>(n, 1 / static_cast<double>(n)), std::vector<std::uint64_t>(n, count),
          static_cast<double>(n * count)};
}

TEST(CellResidue, IsInStandardDeviationsWithAPValueOfBothTails) {
  const CellResidue first = cell_residue(cells, 0);
  EXPECT_EQ(first.expected, 25);
  EXPECT_DOUBLE_EQ(first.deviations, 15 / std::sqrt(18.75));
  EXPECT_LT(first.p, 0.01);
  EXPECT_GT(first.p, 1e-4);
  EXPECT_LT(cell_residue(cells, 1).deviations, 0);
  EXPECT_GT(cell_residue(cells, 1).p, 0.1);
  EXPECT_EQ(cell_residue({1, 2, {0, 1}, {0, 5}, 5}, 0).p, 1) << "a cell that cannot be hit and is not";
}

// Half of 100 draws have a standard deviation of 5, or 10 % of the 50 that are expected.
TEST(Histogram, HasTheDrawsAlongBothAxesAndTheirDifferencesInPercent) {
  const std::string script = histogram_script("a", cells);
  EXPECT_THAT(rows_of(script, 0), ElementsAre("0.5 60 50 20 10", "1.5 40 50 -20 10"));
  EXPECT_THAT(rows_of(script, 1), ElementsAre("0.5 65 50 30 10", "1.5 35 50 -30 10"));
  EXPECT_THAT(rows_of(script, 2), SizeIs(0));
}

TEST(Histogram, HasOneAxisAndAtMost128BarsForAColumnOfCells) {
  const std::string script = histogram_script("a", uniform_cells(300, 1, 100));
  const Rows rows = rows_of(script, 0);
  ASSERT_THAT(rows, SizeIs(100));
  EXPECT_THAT(rows[0], StartsWith("1.5 300 300 0 ")) << "the middle of three cells";
  EXPECT_THAT(rows[99], StartsWith("298.5 300 300 0 "));
  EXPECT_THAT(script, HasSubstr("n = 300; width = 3\n"));
  EXPECT_THAT(rows_of(script, 1), SizeIs(0));
  EXPECT_THAT(rows_of(histogram_script("a", uniform_cells(128, 1, 5))), SizeIs(128));
  EXPECT_THAT(rows_of(histogram_script("a", uniform_cells(129, 1, 5))), SizeIs(65));
}

TEST(Histogram, ShowsTheDifferences) {
  const std::string script = histogram_script("a", {2, 1, {0.5, 0.5}, {5100, 4900}, 10'000});
  const std::string row = "0.5 5100 5000 2 ";
  ASSERT_THAT(script, HasSubstr(row));
  std::string other = script;
  other.replace(script.find(row), row.size(), "0.5 5100 5000 1 ");
  EXPECT_NE(picture_of(script), picture_of(other));
}

TEST(PMap, HasThePowersOfTenOfThePValuesAboveZeroWhereThereAreTooMany) {
  const Rows rows = rows_of(p_map_script("a", cells));
  ASSERT_THAT(rows, SizeIs(4));
  EXPECT_NEAR(std::stod(rows[0]), -std::log10(cell_residue(cells, 0).p), 1e-4);
  EXPECT_NEAR(std::stod(rows[1]), std::log10(cell_residue(cells, 1).p), 1e-4);
  EXPECT_EQ(std::stod(rows[2]), 0);
  EXPECT_LT(std::stod(rows[3]), std::stod(rows[1]));
}

TEST(PMap, WrapsAColumnOfCells) {
  EXPECT_THAT(p_map_script("a", cells), HasSubstr("across = 2; down = 2; most = 8\n"));
  EXPECT_THAT(p_map_script("a", uniform_cells(300, 1, 5)), HasSubstr("across = 32; down = 10; most = 8\n"));
  EXPECT_THAT(p_map_script("a", uniform_cells(1 << 15, 1, 5)), HasSubstr("across = 256; down = 128;"));
}

TEST(TileMap, HasTheBiasesRowByRow) {
  const std::string script = tile_map_script("a", {3, {2, -1, 0, -5, 0.5, 1}});
  EXPECT_THAT(script, HasSubstr("across = 3; down = 2; most = 2\n"));
  EXPECT_THAT(rows_of(script), ElementsAre("2", "-1", "0", "-5", "0.5", "1"));
}

// A course of a test of the mean 0.5, with draws that are all 1.
Evidence::Course course_of_ones(Sides sides) {
  BettingTest test({.mean = 0.5, .margin = 0.01, .lower = 0, .upper = 1, .sides = sides}, 2e-6, 0.01);
  Evidence::Course course(test);
  for (int i = 0; i < 10; ++i) {
    test.add(std::vector<double>(test.block_size(), 1.0));
    course.add(test);
  }
  return course;
}

TEST(WealthChart, StartsAtOneAndHasTheProcessesInTheOrderOfTheirNames) {
  const Evidence::Course course = course_of_ones(Sides::both);
  const std::string script = wealth_script("a", course);
  const Rows rows = rows_of(script);
  ASSERT_THAT(rows, SizeIs(course.steps().size() + 1));
  EXPECT_EQ(rows.front(), "0 0 0 0 0");
  const auto& step = course.steps().back();
  std::istringstream last(rows.back());
  double draws = 0;
  last >> draws;
  EXPECT_EQ(draws, static_cast<double>(step.draws));
  for (const double logarithm : {step.wealth.above_reference, step.wealth.below_upper_margin,
                                 step.wealth.below_reference, step.wealth.above_lower_margin}) {
    double power = 0;
    last >> power;
    EXPECT_NEAR(power, logarithm / std::log(10), 5e-6 * std::abs(power)) << "to six digits";
  }
  EXPECT_THAT(script, HasSubstr("; certified = 2; first = 1; last = 4\n"));
}

TEST(WealthChart, ShowsTheTwoProcessesOfAOneSidedClaim) {
  EXPECT_THAT(wealth_script("a", course_of_ones(Sides::not_above)), HasSubstr("first = 1; last = 2\n"));
  EXPECT_THAT(wealth_script("a", course_of_ones(Sides::not_below)), HasSubstr("first = 3; last = 4\n"));
}

std::string intervals_of(std::size_t n, Interval interval, Verdict verdict = Verdict::certified) {
  return intervals_script(
      std::vector<Outcome>(n, {&registry()[0], {verdict, Guarantee::exact, 0.02, 0, interval}, 1}));
}

TEST(Intervals, AreInUnitsOfTheirMargins) {
  const std::string name = registry()[0].name;
  EXPECT_THAT(rows_of(intervals_of(1, {-0.01, 0.03})), ElementsAre(name + " certified -0.5 1.5"));
  EXPECT_THAT(rows_of(intervals_of(2, {0.01, 0.02}, Verdict::biased)),
              ElementsAre(name + " biased 0.5 1", name + " biased 0.5 1"));
}

// Beyond two margins a line ends at the end of the chart, however far it goes.
TEST(Intervals, EndAtTheEndOfTheChartWhereTheyAreOpen) {
  EXPECT_EQ(intervals_of(1, {-infinity<double>, 0.01}), intervals_of(1, {-0.05, 0.01}));
  EXPECT_EQ(intervals_of(1, {-0.01, infinity<double>}), intervals_of(1, {-0.01, 0.05}));
  EXPECT_EQ(intervals_of(1, {-infinity<double>, infinity<double>}), intervals_of(1, {-0.05, 0.05}));
  EXPECT_NE(intervals_of(1, {-0.01, 0.01}), intervals_of(1, {-0.05, 0.01}));
  EXPECT_THAT(rows_of(intervals_of(1, {0.1, 0.2}))[0], HasSubstr(" 2 2"));
  EXPECT_THAT(rows_of(intervals_of(1, {-0.2, -0.1}))[0], HasSubstr(" -2 -2"));
}

TEST(Charts, AreDrawnForEveryShapeAndShowTheirData) {
  Evidence::Cells impossible = uniform_cells(4, 1, 100);
  impossible.probabilities = {0, 0.25, 0.25, 0.5};
  std::vector<std::string> pictures;
  for (const auto& law : {cells, uniform_cells(2, 2, 25), uniform_cells(2, 1, 5), uniform_cells(300, 1, 100),
                          uniform_cells(1 << 15, 1, 1), uniform_cells(1, 3, 5), impossible}) {
    pictures.push_back(picture_of(histogram_script("a", law)));
    pictures.push_back(picture_of(p_map_script("a", law)));
  }
  const auto second = [](double bias) { return picture_of(tile_map_script("a", {2, {0, bias, 0, 0}})); };
  for (const double bias : {0.0, 1.0, -1.0, 2.0}) pictures.push_back(second(bias));
  EXPECT_EQ(second(2), second(9)) << "from twice the margin on, the colour is full";
  for (const Sides sides : {Sides::both, Sides::not_above, Sides::not_below})
    pictures.push_back(picture_of(wealth_script("a", course_of_ones(sides))));
  pictures.push_back(picture_of(wealth_script("a", Evidence::Course(BettingTest({0.5, 0.01, 0, 1}, 1e-6, 0.01)))));
  for (const Verdict verdict : {Verdict::certified, Verdict::biased, Verdict::undecided})
    pictures.push_back(picture_of(intervals_of(1, {-0.01, 0.01}, verdict)));
  pictures.push_back(picture_of(intervals_of(1, {0, 0})));
  pictures.push_back(picture_of(intervals_of(1, {0.1, 0.2})));
  pictures.push_back(picture_of(intervals_of(1, {-0.2, -0.1})));
  for (const std::size_t n : {2, 40, 41, 1500}) pictures.push_back(picture_of(intervals_of(n, {-0.01, 0.01})));
  for (const std::string& picture : pictures) EXPECT_TRUE(picture.starts_with("\x89PNG"));
  std::ranges::sort(pictures);
  EXPECT_EQ(std::ranges::adjacent_find(pictures), pictures.end()) << "two of different data look alike";
}

TEST(Charts, HaveTitlesOfAnyLetters) {
  const TemporaryFolder folder;
  const std::string made = folder / "made";
  const std::string title = "it's a_b{c} \"\\n\" `touch " + made + "` '; system('touch " + made + "'); #";
  EXPECT_NE(picture_of(tile_map_script(title, {1, {1}})), picture_of(tile_map_script("", {1, {1}})));
  EXPECT_EQ(folder.files(), 0) << "a title is no command";
}

TEST(WriteChart, KeepsTheScriptBesideThePicture) {
  const TemporaryFolder folder;
  const std::string script = tile_map_script("a", {1, {1}});
  EXPECT_EQ(write_chart(folder / "it's a chart", script), folder / "it's a chart.png");
  EXPECT_EQ(read_file(folder / "it's a chart.gp"), script);
  EXPECT_EQ(folder.files(), 2);
  const auto here = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  write_chart("-e", script);
  std::filesystem::current_path(here);
  EXPECT_EQ(read_file(folder / "-e.png"), read_file(folder / "it's a chart.png")) << "it is no option of gnuplot";
  EXPECT_THAT(problem_of([&] { write_chart(folder / "none/a", script); }), HasSubstr("none/a.gp"));
}

TEST(WriteChart, SaysWhatGnuplotSaysAndLeavesNoHalfPicture) {
  const TemporaryFolder folder;
  const std::string chart = folder / "chart";
  write_file(chart + ".png", "earlier");
  const std::string half = tile_map_script("a", {1, {1}}) + "unset multiplot\nplot nothing\n";
  const std::string problem = problem_of([&] { write_chart(chart, half); });
  EXPECT_THAT(problem, StartsWith("gnuplot cannot draw \"" + chart + ".png\" (\"" + chart + ".gp\" line "));
  EXPECT_THAT(problem, EndsWith(": undefined variable: nothing)"));
  EXPECT_THAT(problem_of([&] { write_chart(chart, "set sise 1\n"); }),
              EndsWith("line 1: unrecognized option - see 'help set'.)"));
  EXPECT_THAT(problem_of([&] { write_chart(chart, "plot\n"); }), Not(HasSubstr("\n"))) << "one sentence";
  EXPECT_EQ(read_file(chart + ".png"), "earlier");
  EXPECT_EQ(folder.files(), 2) << "the picture and the script";
}

// While it lives, programs are looked for in one folder only.
class OnlyPath {
 public:
  explicit OnlyPath(const std::string& folder) { setenv("PATH", folder.c_str(), 1); }
  ~OnlyPath() { setenv("PATH", before_.c_str(), 1); }
  OnlyPath(const OnlyPath&) = delete;
  OnlyPath& operator=(const OnlyPath&) = delete;

 private:
  std::string before_ = std::getenv("PATH");
};

TEST(CheckGnuplot, RefusesAMachineWithoutItOrWithoutItsPngs) {
  EXPECT_NO_THROW(check_gnuplot());
  const TemporaryFolder folder;
  const OnlyPath path(folder.path().string());
  const auto hint = HasSubstr("charts need gnuplot with pngcairo, which is not on the PATH (install the Debian");
  EXPECT_THAT(problem_of(check_gnuplot), hint);
  write_file(folder / "gnuplot", "#!/bin/sh\nexit 1\n");
  std::filesystem::permissions(folder / "gnuplot", std::filesystem::perms::owner_all);
  EXPECT_THAT(problem_of(check_gnuplot), hint);
  write_file(folder / "gnuplot", "#!/bin/sh\nexit 0\n");
  EXPECT_NO_THROW(check_gnuplot());
}

}  // namespace
}  // namespace fairlight
