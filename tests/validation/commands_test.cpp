#include <memory>
#include <set>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fairlight/validation/app/commands.h>
#include <fairlight/validation/app/options.h>

namespace fairlight {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;

struct Program {
  CLI::App app;
  Command command;
  Program() { add_commands(app, command); }

  // The sentence for a command line that cannot be parsed; "" for one that can.
  std::string problem(const std::string& line) {
    try {
      app.parse(line);
    } catch (const CLI::ParseError& error) {
      return usage_problem(app, error);
    }
    return "";
  }
};

std::vector<const CLI::App*> all_commands(const CLI::App& app) {
  std::vector<const CLI::App*> all{&app};
  for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; })) {
    for (const CLI::App* inner : all_commands(*sub)) all.push_back(inner);
  }
  return all;
}

std::vector<std::string> lines(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> all;
  for (std::string line; std::getline(in, line);) all.push_back(line);
  return all;
}

TEST(Commands, AreAllThere) {
  const Program program;
  std::set<std::string> names;
  for (const CLI::App* app : all_commands(program.app)) names.insert(full_name(*app));
  for (const char* name : {"verify", "audit", "audit calibration", "audit power", "audit faults", "audit mutate",
                           "audit judges", "audit ledger", "compare", "judge", "ledger", "ledger show",
                           "ledger merge", "render", "merge", "plan", "scenes", "study"})
    EXPECT_TRUE(names.contains("fairlight " + std::string(name))) << name;
}

TEST(Commands, SayEachOptionInASentenceUnderAHeading) {
  const Program program;
  for (const CLI::App* app : all_commands(program.app)) {
    EXPECT_THAT(app->get_description(), EndsWith(".")) << full_name(*app);
    for (const CLI::Option* option : app->get_options()) {
      const std::string name = full_name(*app) + " " + option->get_name();
      EXPECT_THAT(option->get_description(), EndsWith(".")) << name;
      EXPECT_TRUE(std::isupper(static_cast<unsigned char>(option->get_description()[0]))) << name;
      EXPECT_NE(option->get_group(), "Options") << name << " has no heading";
    }
    for (const std::string& line : lines(app->help())) EXPECT_LE(line.size(), 100u) << line;
  }
}

TEST(Commands, EndTheirHelpWithExamplesThatCanBeTyped) {
  const Program program;
  for (const CLI::App* app : all_commands(program.app)) {
    int examples = 0;
    for (std::string line : lines(app->get_footer())) {
      if (!line.starts_with("  ")) continue;
      ++examples;
      line = line.replace(2, line.find("fairlight") - 2, "");  // a program that it reads from
      EXPECT_TRUE(line.starts_with("  " + full_name(*app) + (app->get_name() == "fairlight" ? " " : ""))) << line;
      if (line.ends_with("--help")) continue;
      Program typed;
      EXPECT_EQ(typed.problem(line.substr(std::string("  fairlight ").size())), "") << line;
      EXPECT_TRUE(typed.command) << line;
    }
    EXPECT_GT(examples, 0) << full_name(*app);
  }
}

// "FLOAT" is what CLI11 calls the value of an option for a double that was not added by add_number.
TEST(Commands, TakeFloatingNumbersByOneCheck) {
  int numbers = 0;
  const Program program;
  for (const CLI::App* app : all_commands(program.app)) {
    for (const CLI::Option* option : app->get_options()) {
      const std::string name = full_name(*app) + " " + option->get_name();
      EXPECT_THAT(option->get_type_name(), Not(HasSubstr("FLOAT"))) << name;
      if (option->get_type_name() != "X") continue;
      ++numbers;
      const std::string command = name.substr(std::string("fairlight ").size());
      for (const char* value : {"nan", "inf", "-inf", "1e999", "x"})
        EXPECT_THAT(Program().problem(command + " " + value), HasSubstr(option->get_name() + ": \"")) << name;
    }
  }
  EXPECT_EQ(numbers, 24) << "plan has six, compare and judge five each, verify and render three each, "
                            "audit judges and audit mutate one each";
}

TEST(UsageProblem, NamesTheNearestOptionOrCommandAndHelp) {
  const auto problem = [](const std::string& line) { return Program().problem(line); };
  EXPECT_EQ(problem("rendr"),
            "there is no command \"rendr\" of fairlight (did you mean render? see fairlight --help)");
  EXPECT_EQ(problem("audit nope"), "there is no command \"nope\" of fairlight audit (see fairlight audit --help)");
  EXPECT_EQ(problem("audit faults --sed 1"),
            "there is no option \"--sed\" of fairlight audit faults (did you mean "
            "--seed or --seeds? see fairlight audit faults --help)");
  EXPECT_EQ(
      problem("render a --spp 1 -o b --bounc=uniform"),
      "there is no option \"--bounc\" of fairlight render (did you mean --bounce? see fairlight render --help)");
  EXPECT_EQ(problem("scenes foo"), "fairlight scenes does not take \"foo\" (see fairlight scenes --help)");
  EXPECT_THAT(problem("render a --sp 1 -o b"), HasSubstr("did you mean --spp?")) << "it is why --spp is missing";
  EXPECT_EQ(problem("render a --spp 1"), "-o is required (see fairlight render --help)");
}

TEST(NoCommand, ListsThoseThereAre) {
  Program program;
  program.app.parse("audit");
  EXPECT_EQ(no_command(program.app),
            "no command of fairlight audit was given (choose one of: faults, calibration, "
            "power, ledger, mutate, domains, judges)");
}

}  // namespace
}  // namespace fairlight
