#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fairlight/validation/app/options.h>

namespace fairlight {
namespace {

using ::testing::HasSubstr;

// What the option --x of a program with these numbers says to a text; nothing where it takes it.
std::string refusal(const NumberRange& range, const std::string& text) {
  CLI::App app;
  double value = -7;
  add_number(app, "--x", value, range, "A number.");
  try {
    app.parse(std::vector<std::string>{"--x=" + text});
  } catch (const CLI::ValidationError& error) {
    EXPECT_EQ(value, -7);
    return error.what();
  }
  EXPECT_EQ(value, std::strtod(text.c_str(), nullptr));
  return "";
}

TEST(AddNumber, TakesFiniteNumbersOfTheRange) {
  for (const char* text : {"0.5", "5e-324", "0.9999999999999999", "1e-3", "+0.25", "0x1p-3"})
    EXPECT_EQ(refusal({.low = 0, .high = 1}, text), "") << text;
  for (const char* text : {"0", "-0", "1e-999", "1.7976931348623157e308"})
    EXPECT_EQ(refusal({.low = 0, .from_low = true}, text), "") << text;
}

TEST(AddNumber, RefusesWhatIsNoNumberWhateverTheRange) {
  for (const NumberRange& range :
       {NumberRange{.low = 0}, {.low = 0, .high = 1}, {.low = -1e308, .from_low = true}}) {
    for (const char* text :
         {"nan", "NaN", "-nan", "nan(1)", "inf", "-inf", "infinity", "1e999", "-1e999", "one", "1x", " "})
      EXPECT_THAT(refusal(range, text), HasSubstr("--x: \"" + std::string(text) + "\" is not a finite number"))
          << text;
  }
}

TEST(AddNumber, RefusesNumbersOutOfTheRangeAndSaysWhichItIs) {
  EXPECT_THAT(refusal({.low = 0}, "0"), HasSubstr("a finite number above 0"));
  EXPECT_THAT(refusal({.low = 0}, "-1"), HasSubstr("a finite number above 0"));
  EXPECT_THAT(refusal({.low = 0, .from_low = true}, "-5e-324"), HasSubstr("a finite number of 0 or more"));
  EXPECT_THAT(refusal({.low = 0, .high = 180}, "180"), HasSubstr("above 0 and below 180"));
  EXPECT_THAT(refusal({.low = 0, .high = 180}, "1e999"), HasSubstr("above 0 and below 180"));
}

TEST(AddText, RefusesAnEmptyOne) {
  CLI::App app;
  std::string text;
  add_text(app, "--x", text, "F", "A file.");
  EXPECT_THROW(app.parse(std::vector<std::string>{"--x="}), CLI::ParseError);
  app.parse(std::vector<std::string>{"--x=a"});
  EXPECT_EQ(text, "a");
}

TEST(AddChoice, RefusesAnotherWordAndNamesTheNearest) {
  const auto refusal = [](const std::string& word) -> std::string {
    CLI::App app;
    std::string value;
    add_choice(app, "--x", value, {"cosine", "uniform"}, "Choose.");
    try {
      app.parse(std::vector<std::string>{"--x=" + word});
    } catch (const CLI::ValidationError& error) {
      return error.what();
    }
    EXPECT_EQ(value, word);
    return "";
  };
  EXPECT_EQ(refusal("cosine"), "");
  EXPECT_EQ(refusal("cosin"), "--x: there is no \"cosin\"; did you mean cosine?");
  EXPECT_EQ(refusal("sideways"), "--x: there is no \"sideways\"; choose cosine or uniform");
}

// The default is that of the option, not of its last value.
TEST(FormatHelp, IndentsTheValuesOfAnOption) {
  CLI::App app("Do it.", "program");
  std::string word = "one";
  app.add_option("--word", word, "Say it.\none: the first.\ntwo: " + std::string(60, 'a') + " b.")
      ->capture_default_str()
      ->type_name("WORD");
  format_help(app);
  const std::string indent(30, ' ');
  EXPECT_THAT(app.help(), HasSubstr("  --word WORD               Say it. [default: one]\n" + indent +
                                    "one: the first.\n" + indent + "two: " + std::string(60, 'a') + " b.\n"));
}

TEST(FormatHelp, HasTheOptionsInGroupsWithTheirDefaultsAndEndsWithExamples) {
  CLI::App app("Do it.", "program");
  double number = 0.25;
  std::string file, word = "one";
  int threads = 3;
  begin_group(app, "First");
  add_number(app, "--number", number, {.low = 0}, std::string(30, 'a') + " " + std::string(60, 'b'))
      ->capture_default_str();
  add_text(app, "-o", file, "F.exr", "Write this.")->required();
  begin_group(app, "Second");
  add_choice(app, "--word", word, {"one", "two"}, "Say it.")->capture_default_str();
  add_threads(app, threads);
  add_examples(app, {"program -o a"});
  format_help(app);
  const std::string indent(28, ' ');
  EXPECT_EQ(app.help(), "Do it.\n\nUsage: program [OPTIONS]\n\nFirst:\n  --number X" + std::string(16, ' ') +
                            std::string(30, 'a') + "\n" + indent + std::string(60, 'b') + "\n" + indent +
                            "[default: 0.25]\n"
                            "  -o F.exr                  Write this. [required]\n"
                            "\nSecond:\n"
                            "  --word WORD               Say it. One of: one, two. [default: one]\n"
                            "\nRunning:\n"
                            "  --threads N               Use this many threads. [default: 3]\n"
                            "\nHelp:\n"
                            "  -h,--help                 Print this help.\n"
                            "\nExample:\n  program -o a\n");
}

TEST(FullName, HasTheCommandsAround) {
  CLI::App app("", "program");
  EXPECT_EQ(full_name(*app.add_subcommand("outer")->add_subcommand("inner")), "program outer inner");
}

}  // namespace
}  // namespace fairlight
