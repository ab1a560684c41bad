#include <vector>

#include <fairlight/render/nearest_names.h>
#include <fairlight/validation/app/commands.h>
#include <fairlight/validation/app/options.h>

namespace fairlight {
namespace {

// The innermost command that the parser had reached.
const CLI::App& innermost(const CLI::App& app) {
  const auto parsed = app.get_subcommands();
  return parsed.empty() ? app : innermost(*parsed.front());
}

// The outermost command with a word that it does not know, or nullptr.
const CLI::App* with_unknown_word(const CLI::App& app) {
  if (app.remaining_size() > 0) return &app;
  const auto parsed = app.get_subcommands();
  return parsed.empty() ? nullptr : with_unknown_word(*parsed.front());
}

std::string help_of(const CLI::App& app) { return full_name(app) + " --help"; }

std::vector<std::string> commands_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(sub->get_name());
  return names;
}

std::vector<std::string> options_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

// The sentence for an unknown word. Of an option such as "--bounc=uniform" it quotes "--bounc"
// alone.
std::string unknown(const CLI::App& app, const std::string& word) {
  if (word.starts_with("-")) {
    const std::string option = word.substr(0, word.find('='));
    return "there is no option \"" + option + "\" of " + full_name(app) + " " +
           did_you_mean(option, options_of(app), help_of(app));
  }
  const std::vector<std::string> commands = commands_of(app);
  if (commands.empty()) return full_name(app) + " does not take \"" + word + "\" (see " + help_of(app) + ")";
  return "there is no command \"" + word + "\" of " + full_name(app) + " " +
         did_you_mean(word, commands, help_of(app));
}

}  // namespace

void add_commands(CLI::App& program, Command& command) {
  program.description("Monte Carlo light transport, statistically verified.");
  program.name("fairlight");
  add_verify_command(program, command);
  add_audit_command(program, command);
  add_ledger_command(program, command);
  add_render_commands(program, command);
  add_compare_command(program, command);
  add_judge_command(program, command);
  add_plan_command(program, command);
  add_study_command(program, command);
  add_examples(program,
               {"fairlight verify hemisphere", "fairlight render cornell-simple --spp 64 -o box.exr --png box.png",
                "fairlight render --help"});
  format_help(program);
}

std::string usage_problem(const CLI::App& program, const CLI::ParseError& error) {
  const CLI::App* app = with_unknown_word(program);
  // An unknown word may be the reason that a required one is missing.
  const bool may_be_unknown = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr ||
                              dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
  if (app != nullptr && may_be_unknown) {
    for (const std::string& word : app->remaining()) {
      if (word != "--") return unknown(*app, word);
    }
  }
  return error.what() + (" (see " + help_of(innermost(program)) + ")");
}

std::string no_command(const CLI::App& program) {
  const CLI::App& app = innermost(program);
  return "no command of " + full_name(app) +
         " was given (choose one of: " + CLI::detail::join(commands_of(app), ", ") + ")";
}

}  // namespace fairlight
