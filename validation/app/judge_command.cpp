#include <cmath>
#include <cstdio>
#include <fstream>
#include <memory>
#include <optional>

#include <fairlight/render/atomic_file.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/app/commands.h>
#include <fairlight/validation/app/options.h>
#include <fairlight/validation/report/report.h>
#include <fairlight/validation/run/clock.h>
#include <fairlight/validation/run/judge_numbers.h>
#include <fairlight/version.h>

namespace fairlight {
namespace {

struct JudgeOptions {
  std::optional<double> mean, scale;
  std::vector<double> range;
  bool agree = false, uniform = false;
  std::string with, law, json;
  std::string format = "text";
  std::size_t columns = 0;
  std::uint64_t max_draws = std::numeric_limits<std::uint64_t>::max();
  Trial trial{"judge", 0, 1e-6, 0.01, 1e-3};
};

std::ifstream open(const std::string& path, const std::string& name) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw BadInput(name + " cannot be read (does it exist?)");
  return in;
}

NumberFormat format_of(const std::string& word) {
  if (word == "text") return NumberFormat::text;
  return word == "f32" ? NumberFormat::f32 : NumberFormat::f64;
}

std::optional<Interval> range_of(const JudgeOptions& options) {
  if (options.range.empty()) return {};
  if (!(options.range[0] < options.range[1]))
    throw std::invalid_argument("--range must ascend, for example --range 0,1");
  return Interval{options.range[0], options.range[1]};
}

void check(const JudgeOptions& options) {
  const int tests = options.mean.has_value() + options.agree + options.uniform + !options.law.empty();
  if (tests != 1) throw std::invalid_argument("judge takes exactly one of --mean, --agree, --law and --uniform");
  const bool law = options.uniform || !options.law.empty();
  if (law && (!options.range.empty() || options.scale))
    throw std::invalid_argument("--range and --scale are for --mean and --agree (a law states its own range)");
  if (!options.with.empty() && !options.agree) throw std::invalid_argument("--with is for --agree");
  if (options.format == "text" && options.columns > 0)
    throw std::invalid_argument("--columns is for binary numbers (text shows its columns)");
  if (options.mean && *options.mean == 0 && !options.scale)
    throw std::invalid_argument(
        "the margin is relative to the mean, which is 0 (give --scale, such as a typical size)");
  range_of(options);  // throws unless it ascends
  if (!options.json.empty()) AtomicFile::check_writable(options.json);
}

Finding judged(const JudgeOptions& options) {
  IntervalLaw law;
  if (!options.law.empty()) {
    std::ifstream in = open(options.law, "\"" + options.law + "\"");
    law = read_law(in, "\"" + options.law + "\"");
  }
  const NumberFormat format = format_of(options.format);
  std::ifstream in = open("/dev/stdin", "standard input");
  NumberStream stream(in, format, options.columns);
  const Numbers numbers{stream, options.max_draws};
  if (options.mean) {
    const double scale = options.scale.value_or(std::abs(*options.mean));
    return judge_mean(options.trial, numbers, *options.mean, scale, range_of(options));
  }
  if (options.uniform) return judge_uniform(options.trial, numbers);
  if (!options.law.empty()) return judge_law(options.trial, numbers, law);
  if (options.with.empty())
    return judge_agreement(options.trial, numbers, nullptr, options.scale, range_of(options));
  std::ifstream second = open(options.with, "\"" + options.with + "\"");
  NumberStream other(second, format, options.columns, "\"" + options.with + "\"");
  return judge_agreement(options.trial, numbers, &other, options.scale, range_of(options));
}

nlohmann::json json_of(const Finding& finding, const JudgeOptions& options, double seconds) {
  const auto end = [](double x) { return std::isfinite(x) ? nlohmann::json(x) : nlohmann::json(); };
  return {{"version", version},
          {"verdict", name(finding.verdict)},
          {"guarantee", name(finding.guarantee)},
          {"alpha", options.trial.alpha},
          {"beta", options.trial.beta},
          {"margin", finding.margin},
          {"bias", end(finding.bias)},
          {"interval", {end(finding.interval.lo), end(finding.interval.hi)}},
          {"samples", finding.draws},
          {"seconds", seconds},
          {"note", finding.note}};
}

void print(const Finding& finding) {
  std::printf("%s: margin %g, bias %.3g, between %s and %s, %llu draws, %s\n", name(finding.verdict),
              finding.margin, finding.bias, end_text(finding.interval.lo).c_str(),
              end_text(finding.interval.hi).c_str(), static_cast<unsigned long long>(finding.draws),
              name(finding.guarantee));
  if (!finding.note.empty()) std::printf("%s\n", finding.note.c_str());
}

int judge_input(const JudgeOptions& options) {
  check(options);
  const Clock clock;
  const Finding finding = judged(options);
  if (!options.json.empty()) write_json(options.json, json_of(finding, options, clock.seconds()));
  print(finding);
  return finding.verdict == Verdict::certified ? 0 : finding.verdict == Verdict::biased ? 1 : 3;
}

CLI::Option* add_optional_number(CLI::App& app, const std::string& name, std::optional<double>& value,
                                 const NumberRange& range, const std::string& help) {
  return app.add_option(name, value, help)->check(number_in(range))->type_name("X");
}

void add_tests(CLI::App& app, JudgeOptions& options) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  begin_group(app, "What to test (one of these)");
  add_optional_number(app, "--mean", options.mean, {.low = -infinite},
                      "Every column has this mean: exact with --range, otherwise asymptotic and one column.");
  app.add_flag("--agree", options.agree, "Two columns, or the input and that of --with, have the same mean.");
  add_text(app, "--law", options.law, "F.csv",
           "The numbers follow this law: rows of low, high, probability, or of x, density.");
  app.add_flag("--uniform", options.uniform, "The rows are uniform points of [0,1)^d, d the number of columns.");
  begin_group(app, "How strictly");
  app.add_option("--range", options.range, "Every number lies in [A, B]; one outside is biased.")
      ->delimiter(',')
      ->expected(2)
      ->check(number_in({.low = -infinite}))
      ->type_name("A,B");
  add_number(app, "--margin", options.trial.margin, {.low = 0, .high = 1},
             "Exclude biases of this part of the scale and more; of a law, this relative L2 distance.")
      ->capture_default_str();
  add_optional_number(app, "--scale", options.scale, {.low = 0},
                      "What the margin is relative to. The absolute mean if not given.");
  add_number(app, "--alpha", options.trial.alpha, {.low = 0, .high = 1},
             "Call right numbers biased with at most this probability.")
      ->capture_default_str();
  add_number(app, "--beta", options.trial.beta, {.low = 0, .high = 1},
             "Certify a bias of the margin with at most this probability.")
      ->capture_default_str();
}

void add_input(CLI::App& app, JudgeOptions& options) {
  begin_group(app, "Input and output");
  add_choice(app, "--format", options.format, {"text", "f32", "f64"}, "How the numbers are written.")
      ->capture_default_str();
  add_count<std::size_t>(app, "--columns", options.columns, 1, 1024,
                         "The columns of a binary row; 1 if not given.");
  add_text(app, "--with", options.with, "FILE",
           "The second input of --agree: a file or a pipe, in the same format.");
  add_count<std::uint64_t>(app, "--max-draws", options.max_draws, 1, std::numeric_limits<std::int64_t>::max(),
                           "Give up, undecided, rather than read more rows than this. No limit if not given.");
  add_text(app, "--json", options.json, "F.json", "Write the finding to this JSON file.");
}

}  // namespace

void add_judge_command(CLI::App& program, Command& command) {
  auto* app = program.add_subcommand(
      "judge", "Test numbers that any program writes to standard input: certified, biased or undecided.");
  auto options = std::make_shared<JudgeOptions>();
  add_tests(*app, *options);
  add_input(*app, *options);
  add_examples(*app, {"myprogram | fairlight judge --mean 0.5 --range 0,1 --margin 1e-2",
                      "myprogram | fairlight judge --uniform --margin 0.05 --format f64 --columns 2"});
  app->callback([options, &command] { command = [options] { return judge_input(*options); }; });
}

}  // namespace fairlight
