#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fairlight/render/strategy_table.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/app/commands.h>
#include <fairlight/validation/run/registry.h>

namespace fairlight {
namespace {

using ::testing::HasSubstr;

TEST(StrategyTable, NamesClaimsThatExistForEveryStrategy) {
  for_each_strategy_kind([](const auto& table) {
    for (const auto& row : table.rows)
      EXPECT_NO_THROW(select_claims({row.claims})) << table.setting << " " << row.name << ": " << row.claims;
  });
}

// The help of `fairlight render`, or the problem with one more option on a line that is right.
std::string render_help() {
  CLI::App program;
  Command command;
  add_commands(program, command);
  return program.get_subcommand("render")->help();
}
std::string problem_with(const std::string& option) {
  CLI::App program;
  Command command;
  add_commands(program, command);
  try {
    program.parse("render a --spp 1 -o b " + option);
  } catch (const CLI::ParseError& error) {
    return usage_problem(program, error);
  }
  return "";
}

TEST(RenderOptions, TakeEveryStrategyAndSayWhatItIs) {
  const std::string help = render_help();
  for_each_strategy_kind([&](const auto& table) {
    EXPECT_THAT(help, HasSubstr(formatted("  %s WORD", option_of(table.setting).c_str())));
    for (const auto& row : table.rows) {
      EXPECT_EQ(problem_with(option_with(row.value)), "");
      EXPECT_THAT(help, HasSubstr(formatted("\n%s%s: ", std::string(30, ' ').c_str(), row.name)));
    }
  });
  EXPECT_THAT(help, HasSubstr("Sample the points of a light in this way. [default: area]\n"));
  EXPECT_THAT(help, HasSubstr("cone: uniformly in the cone that it fills, for spheres (verify\n"));
}

TEST(RenderOptions, RefuseAStrategyThatDoesNotExistByItsOptionAndTheNearest) {
  EXPECT_EQ(problem_with("--bounce uniforn"),
            "--bounce: there is no \"uniforn\"; did you mean uniform? (see fairlight render --help)");
  EXPECT_EQ(problem_with("--bounce sideways"),
            "--bounce: there is no \"sideways\"; choose cosine or uniform (see fairlight render --help)");
  for_each_strategy_kind([](const auto& table) {
    const std::string option = option_of(table.setting);
    for (const auto& row : table.rows) {
      const std::string problem = problem_with(formatted("%s %sx", option.c_str(), row.name));
      EXPECT_THAT(problem, HasSubstr(formatted("%s: there is no \"%sx\"; ", option.c_str(), row.name)));
      EXPECT_THAT(problem, HasSubstr(row.name));
    }
  });
}

// The page on rendering has a row for each option, with its values in code font.
TEST(RenderOptions, AreOnThePageOnRendering) {
  for_each_strategy_kind([](const auto& table) {
    std::ifstream page(FAIRLIGHT_SOURCE_DIR "/docs/rendering.md");
    const std::string start = formatted("| `%s`", option_of(table.setting).c_str());
    std::string line;
    while (std::getline(page, line) && !line.starts_with(start)) {
    }
    for (const auto& row : table.rows) EXPECT_THAT(line, HasSubstr(formatted("`%s`", row.name))) << start;
  });
}

}  // namespace
}  // namespace fairlight
