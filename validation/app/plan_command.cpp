#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>

#include <nlohmann/json.hpp>

#include <fairlight/render/atomic_file.h>
#include <fairlight/stats/plan.h>
#include <fairlight/validation/app/commands.h>
#include <fairlight/validation/app/options.h>
#include <fairlight/version.h>

namespace fairlight {
namespace {

struct PlanOptions {
  double mean = 0, deviation = 0, margin = 0, draws = 0, scale = 0, beta = 0.01;
  std::vector<double> range;
  std::string json;
};

MeanPlan plan_of(const PlanOptions& options) {
  const double scale = options.scale > 0 ? options.scale : std::abs(options.mean);
  return {options.mean, options.range[0], options.range[1], options.deviation, scale, options.beta};
}

nlohmann::json json_of(const PlanOptions& options, const char* what, double expected, double with_99_percent) {
  return {{"version", version},     {"mean", options.mean},
          {"range", options.range}, {"deviation", options.deviation},
          {"beta", options.beta},   {what, {{"expected", expected}, {"with_99_percent", with_99_percent}}}};
}

int plan(const PlanOptions& options) {
  if ((options.margin > 0) == (options.draws > 0))
    throw std::invalid_argument("plan takes one of --margin and --draws (it answers with the other)");
  if (!options.json.empty()) AtomicFile::check_writable(options.json);
  const MeanPlan planned = plan_of(options);
  nlohmann::json json;
  if (options.margin > 0) {
    const auto [expected, enough] = planned_draws(planned, options.margin);
    std::printf("a margin of %g takes %.3g draws on average, and at most %.3g with 99 %% probability\n",
                options.margin, expected, enough);
    json = json_of(options, "draws", std::ceil(expected), std::ceil(enough));
    json["margin"] = options.margin;
  } else {
    const auto [expected, sure] = planned_margin(planned, options.draws);
    std::printf("%g draws certify a margin of %.3g with 99 %% probability; they are the average for one of %.3g\n",
                options.draws, sure, expected);
    json = json_of(options, "margin", expected, sure);
    json["draws"] = options.draws;
  }
  if (!options.json.empty()) write_json(options.json, json);
  return 0;
}

}  // namespace

void add_plan_command(CLI::App& program, Command& command) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  auto* app = program.add_subcommand(
      "plan", "Say how many draws the test of a mean takes for a margin, or which margin draws can show.");
  auto options = std::make_shared<PlanOptions>();
  begin_group(*app, "The draws");
  add_number(*app, "--mean", options->mean, {.low = -infinite}, "The mean of the draws.")->required();
  app->add_option("--range", options->range, "Every draw lies in [A, B].")
      ->delimiter(',')
      ->expected(2)
      ->check(number_in({.low = -infinite}))
      ->type_name("A,B")
      ->required();
  add_number(*app, "--deviation", options->deviation, {.low = 0, .from_low = true},
             "The standard deviation of one draw.")
      ->required();
  begin_group(*app, "The question");
  add_number(*app, "--margin", options->margin, {.low = 0, .high = 1}, "Say how many draws this margin takes.");
  add_number(*app, "--draws", options->draws, {.low = 0}, "Say which margin so many draws certify.");
  add_number(*app, "--scale", options->scale, {.low = 0},
             "What the margin is relative to. The absolute mean if not given.");
  add_number(*app, "--beta", options->beta, {.low = 0, .high = 1}, "The miss rate of the test.")
      ->capture_default_str();
  begin_group(*app, "Output");
  add_text(*app, "--json", options->json, "F.json", "Write the answer to this JSON file.");
  add_examples(*app, {"fairlight plan --mean 0.5 --range 0,1 --deviation 0.3 --margin 1e-3",
                      "fairlight plan --mean 0.5 --range 0,1 --deviation 0.3 --draws 1e6"});
  app->callback([options, &command] { command = [options] { return plan(*options); }; });
}

}  // namespace fairlight
